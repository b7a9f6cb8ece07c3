#include <nipref/fast/sheet/generator/component_series.hpp>
#include <nipref/fast/sheet/generator/tabulate.hpp>

namespace nipref::fast::generator {
namespace {

using internal::Component;
using internal::ComponentTable;

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

/// Fills a row with the coefficients of a polynomial for f, or f(x)/x for odd f, about a centre.
template <std::size_t count>
Series fill_row(const std::function<Real(const Real&)>& f, const Real& centre, double pieces,
                double (&row)[count]) {
  const Real half_width = 1 / (2 * Real(pieces));
  const Series polynomial = interpolated([&](const Real& t) { return f(centre + t); }, -half_width,
                                         half_width, static_cast<int>(count) - 1);
  for (std::size_t k = 0; k < count; ++k) row[k] = rounded(polynomial[k]);
  return polynomial;
}

void fill_rows(const ComponentSeries& component, bool logarithmic, ComponentTable& table) {
  const auto f = [&](const Real& x) { return component(x); };
  const double first = logarithmic ? internal::near_end : 0;
  for (int row = static_cast<int>(first * internal::fine_pieces); row < internal::rows; ++row) {
    const Real centre = row_centre(row);
    const double pieces = centre < internal::fine_end ? internal::fine_pieces : internal::coarse_pieces;
    split(fill_row(f, centre, pieces, table.power[row]).front(), table.power[row][0],
          table.constant_low[row]);
  }
  const double coarse_pieces = internal::coarse_pieces;
  for (int row = static_cast<int>(first * coarse_pieces); row < internal::coarse_piece_rows; ++row)
    fill_row(f, Real(row) / coarse_pieces, coarse_pieces, table.coarse[row]);
  if (!logarithmic) return;
  const auto minus_log = [&](const Real& x) { return component.about_zero().front() - log(x); };
  for (int row = 0; row < internal::coarse_log_rows; ++row)
    fill_row(minus_log, 1 + Real(row) / coarse_pieces, coarse_pieces,
             table.coarse[internal::coarse_piece_rows + row]);
}

Real log_cell_centre(int cell, int cells) { return 1 + (cell + Real(1) / 2) / cells; }

/// Splits x into two words, the first of which is a multiple of 2^-42.
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

/// Fills, for each tier, a polynomial for the even remainder over x^2 as a function of x^2 on [0, near_end^2].
void fill_even_remainder(const Series& about_zero, ComponentTable& table) {
  const Series even(about_zero.begin() + 1, about_zero.end());
  const Real end = Real(internal::near_end) * internal::near_end;
  for (int tier = 0; tier < internal::tier_count; ++tier) {
    const Series polynomial = interpolated([&](const Real& square) { return value(even, square); }, Real(0),
                                           end, internal::tier_works[tier].even - 1);
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

std::unique_ptr<ComponentTable> tabulate(Component id) {
  auto table = std::make_unique<ComponentTable>();
  const ComponentSeries component(id);
  const bool logarithmic = shape(id) == internal::Shape::logarithmic;
  fill_rows(component, logarithmic, *table);
  if (logarithmic) {
    fill_logarithm(component.about_zero(), *table);
    fill_even_remainder(component.about_zero(), *table);
    table->odd = rounded(component.linear());
  }
  fill_residue(component, *table);
  return table;
}

internal::CommonTable tabulate_common() {
  internal::CommonTable table{};
  for (int cell = 0; cell < internal::log_cells; ++cell)
    table.log_reciprocal[cell] = rounded(1 / log_cell_centre(cell, internal::log_cells));
  for (int cell = 0; cell < internal::short_log_cells; ++cell)
    table.short_log_reciprocal[cell] = rounded(1 / log_cell_centre(cell, internal::short_log_cells));
  const Complex& z = roots().front();
  split(internal::exponential_cells * z.imag() / boost::math::constants::ln_two<Real>(), table.decay_high,
        table.decay_low);
  split(internal::phase_cells * z.real() / (2 * pi()), table.phase_high, table.phase_low);
  return table;
}

internal::RootTable tabulate_roots() {
  internal::RootTable table{};
  for (std::size_t n = 0; n < internal::tabulated_roots; ++n) {
    split(Real(roots()[n].real()), table.frequency_high[n], table.frequency_low[n]);
    split(Real(roots()[n].imag()), table.decay_high[n], table.decay_low[n]);
  }
  return table;
}

}  // namespace nipref::fast::generator
