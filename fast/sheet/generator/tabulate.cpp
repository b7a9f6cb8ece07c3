#include <boost/math/constants/constants.hpp>
#include <span>

#include <nipref/fast/sheet/generator/component_series.hpp>
#include <nipref/fast/sheet/generator/series.hpp>
#include <nipref/fast/sheet/generator/tabulate.hpp>

namespace nipref::fast::generator {
namespace {

using internal::Component;
using internal::ComponentTable;
using internal::Shape;

/// Terms of a series whose truncation error is below the rounding of two doubles: arguments are at most 1/64 of the
/// radius of convergence.
constexpr int local_length = 24;

double rounded(const Real& x) { return x.convert_to<double>(); }

void split(const Real& x, double& high, double& low) {
  high = rounded(x);
  low = rounded(x - high);
}

Real row_centre(int row) {
  const bool fine = row <= static_cast<int>(internal::fine_pieces);
  return fine ? Real(row) / internal::fine_pieces
              : Real(row - internal::coarse_offset) / internal::coarse_pieces;
}

/// The Taylor series of f, or of f(x)/x for odd f, about the centre of a row. Near 0, where the residue series
/// converges too slowly, it is computed from the power series about 0.
Series local_series(const ComponentSeries& component, Series about_zero, bool odd, const Real& centre) {
  if (centre < Real(1) / 8) {
    if (odd) about_zero.erase(about_zero.begin());
    return shifted(about_zero, centre, local_length);
  }
  const Series series = component.about(centre, local_length);
  return odd ? divided_by_argument(series, centre) : series;
}

void fill_rows(Component id, const ComponentSeries& component, const Series& about_zero,
               ComponentTable& table) {
  const bool logarithmic = shape(id) == Shape::logarithmic;
  const int first_row = logarithmic ? static_cast<int>(internal::near_end * internal::fine_pieces) : 0;
  for (int row = first_row; row < internal::rows; ++row) {
    const Real centre = row_centre(row);
    const Real half_width =
        1 / (2 * Real(centre < internal::fine_end ? internal::fine_pieces : internal::coarse_pieces));
    const Series local = local_series(component, about_zero, shape(id) == Shape::odd, centre);
    const Series polynomial = economised(local, -half_width, half_width, internal::piece_degree);
    for (std::size_t k = 0; k < polynomial.size(); ++k) table.power[row][k] = rounded(polynomial[k]);
    split(polynomial.front(), table.power[row][0], table.constant_low[row]);
  }
}

void write_row(const Series& local, double (&row)[internal::coarse_degree + 1]) {
  const Real half_width = 1 / (2 * Real(internal::coarse_pieces));
  const Series polynomial = economised(local, -half_width, half_width, internal::coarse_degree);
  for (std::size_t k = 0; k < polynomial.size(); ++k) row[k] = rounded(polynomial[k]);
}

void fill_coarse_rows(Component id, const ComponentSeries& component, const Series& about_zero,
                      ComponentTable& table) {
  const bool logarithmic = shape(id) == Shape::logarithmic;
  const int first_row = logarithmic ? static_cast<int>(internal::near_end * internal::coarse_pieces) : 0;
  for (int row = first_row; row < internal::coarse_piece_rows; ++row) {
    const Real centre = Real(row) / internal::coarse_pieces;
    write_row(local_series(component, about_zero, shape(id) == Shape::odd, centre), table.coarse[row]);
  }
  if (!logarithmic) return;
  for (int row = 0; row < internal::coarse_log_rows; ++row) {
    Series minus_log = logarithm(1 + Real(row) / internal::coarse_pieces, local_length);
    for (Real& c : minus_log) c = -c;
    minus_log.front() += about_zero.front();
    write_row(minus_log, table.coarse[internal::coarse_piece_rows + row]);
  }
}

Real log_cell_centre(int cell, int cells) { return 1 + (cell + Real(1) / 2) / cells; }

/// The first is a multiple of 2^-42.
void split_on_log_grid(const Real& x, double& high, double& low) {
  high = rounded(ldexp(Real(floor(ldexp(x, 42) + Real(1) / 2)), -42));
  low = rounded(x - high);
}

void fill_logarithm(const Series& about_zero, ComponentTable& table) {
  for (int cell = 0; cell < internal::log_cells; ++cell) {
    const Real constant = about_zero.front() - log(log_cell_centre(cell, internal::log_cells));
    split_on_log_grid(constant, table.log_high[cell], table.log_low[cell]);
  }
  for (int cell = 0; cell < internal::short_log_cells; ++cell) {
    const Real reciprocal = rounded(1 / log_cell_centre(cell, internal::short_log_cells));
    split_on_log_grid(about_zero.front() + log(reciprocal), table.short_log_high[cell],
                      table.short_log_low[cell]);
  }
}

/// The even remainder over x^2, as a function of x^2 on [0, near_end^2], economised for each tier separately.
void fill_even_remainder(const Series& about_zero, ComponentTable& table) {
  Series even;
  for (std::size_t k = 2; k < about_zero.size(); k += 2) even.push_back(about_zero[k]);
  const Real end = Real(internal::near_end) * internal::near_end;
  for (int tier = 0; tier < internal::tier_count; ++tier) {
    const Series polynomial = economised(even, Real(0), end, internal::tier_works[tier].even - 1);
    for (std::size_t k = 0; k < polynomial.size(); ++k) table.even[tier][k] = rounded(polynomial[k]);
  }
}

void fill_residue(const ComponentSeries& component, ComponentTable& table) {
  split(component.limit(), table.limit_high, table.limit_low);
  for (std::size_t n = 0; n < internal::tabulated_roots; ++n) {
    table.amplitude[n][0] = rounded(component.amplitudes()[n].real());
    table.amplitude[n][1] = rounded(component.amplitudes()[n].imag());
  }
  const Complex amplitude = component.amplitudes().front();
  const Real size = abs(amplitude);
  const Real phase = atan2(Real(amplitude.imag()), Real(amplitude.real()));
  for (int j = 0; j < internal::exponential_cells; ++j)
    split(size * exp2(-Real(j) / internal::exponential_cells), table.exponential_high[j],
          table.exponential_low[j]);
  for (int p = 0; p < internal::phase_cells; ++p) {
    const Real angle = phase + 2 * pi() * p / internal::phase_cells;
    split(cos(angle), table.cosine_high[p], table.cosine_low[p]);
    table.sine[p] = rounded(sin(angle));
  }
}

}  // namespace

std::unique_ptr<ComponentTable> tabulate(Component id, const std::vector<Complex>& roots) {
  auto table = std::make_unique<ComponentTable>();
  const ComponentSeries component(id, roots);
  const Series about_zero = component.about_zero();
  fill_rows(id, component, about_zero, *table);
  fill_coarse_rows(id, component, about_zero, *table);
  if (shape(id) == Shape::logarithmic) {
    fill_logarithm(about_zero, *table);
    fill_even_remainder(about_zero, *table);
    table->odd = rounded(about_zero[1]);
  }
  fill_residue(component, *table);
  return table;
}

internal::CommonTable tabulate_common(const std::vector<Complex>& roots) {
  internal::CommonTable table{};
  for (int cell = 0; cell < internal::log_cells; ++cell)
    table.log_reciprocal[cell] = rounded(1 / log_cell_centre(cell, internal::log_cells));
  for (int cell = 0; cell < internal::short_log_cells; ++cell)
    table.short_log_reciprocal[cell] = rounded(1 / log_cell_centre(cell, internal::short_log_cells));
  const Complex& z = roots.front();
  split(internal::exponential_cells * z.imag() / boost::math::constants::ln_two<Real>(), table.decay_high,
        table.decay_low);
  split(internal::phase_cells * z.real() / (2 * pi()), table.phase_high, table.phase_low);
  return table;
}

internal::RootTable tabulate_roots(const std::vector<Complex>& roots) {
  internal::RootTable table{};
  for (std::size_t n = 0; n < internal::tabulated_roots; ++n) {
    split(Real(roots[n].real()), table.frequency_high[n], table.frequency_low[n]);
    split(Real(roots[n].imag()), table.decay_high[n], table.decay_low[n]);
  }
  return table;
}

}  // namespace nipref::fast::generator
