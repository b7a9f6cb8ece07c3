#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>
#include <nipref/ref/viscoelastic_nip/internal/trace.hpp>

namespace nipref::ref {
namespace {

using Terms = std::vector<RollingMemory>;

/// Adds a term, joined with one whose rate is the same to rounding: to 2^16 units, which are 10^-(digits + 9).
void add_term(Terms& terms, const RollingMemory& term) {
  const auto same = std::ranges::find_if(terms, [&](const RollingMemory& other) {
    return abs(other.rate - term.rate) <= ldexp(abs(other.rate), 16 - working_bits());
  });
  if (same == terms.end())
    terms.push_back(term);
  else
    same->amplitude = same->amplitude + term.amplitude;
}

/// Largest width of the first panel at an end, over that without memory, times the largest rate.
constexpr double widest_of_memory = 1.5;

/// The zeros of C(-s), as those of C(-s) prod (r_i - s). The guesses are complex: real steps find no complex zeros.
std::vector<ComplexFloat> zeros_of(const Terms& terms) {
  const ComplexFloat beside(1, Float(1) / 8);
  std::vector<ComplexFloat> guesses;
  for (const RollingMemory& term : terms) guesses.push_back(term.rate + term.amplitude * beside);
  const auto slope_over_value = [&](const ComplexFloat& s) -> std::optional<ComplexFloat> {
    ComplexFloat value(1), slope, poles;
    for (const RollingMemory& term : terms) {
      const ComplexFloat distance = term.rate - s, part = term.amplitude / distance;
      value = value + part;
      slope = slope + part / distance;
      poles = poles + ComplexFloat(1) / distance;
    }
    if (abs(value) == 0) return std::nullopt;
    return slope / value - poles;
  };
  return zeros_by_steps(std::move(guesses), slope_over_value, ldexp(Float(1), 8 - working_bits()));
}

}  // namespace

RollingMaterial rolling_material(const data::ViscoelasticNip& nip) {
  const auto [theta1, theta2] = material_compliances(nip.material);
  RollingMaterial result{theta1.at_once + theta2.at_once, {}, 0, {}};
  result.theta2_at_once = theta2.at_once / result.compliance;
  const Float ways = Float(nip.sheet_thickness) / 2 / nip.speed;  // time to move by a half-thickness
  const auto add_rolled = [&](Terms& terms, const Terms& in_time) {
    for (const auto& [amplitude, rate] : in_time)
      add_term(terms, {amplitude * (ways / result.compliance), rate * ways});
  };
  add_rolled(result.theta2, theta2.terms);
  add_rolled(result.normal, theta1.terms);
  add_rolled(result.normal, theta2.terms);
  std::erase_if(result.normal, [](const RollingMemory& term) { return abs(term.amplitude) == 0; });
  return result;
}

RollingSheet::RollingSheet(RollingMaterial the_material) : material(std::move(the_material)) {
  for (const ComplexFloat& s : zeros_of(material.normal)) {
    ComplexFloat sum;
    for (const RollingMemory& term : material.normal) {
      const ComplexFloat distance = term.rate - s;
      sum = sum - term.amplitude / (distance * distance);
    }
    inverse.push_back({ComplexFloat(1) / sum, s});
  }
}

Resolution RollingSheet::resolution() const {
  Resolution resolution{std::numbers::pi, {}, 1};
  for (const auto* terms : {&material.normal, &inverse}) {
    for (const RollingMemory& term : *terms) {
      resolution.rates.emplace_back(static_cast<double>(term.rate.re), static_cast<double>(term.rate.im));
      resolution.first = std::min(resolution.first, widest_of_memory / std::abs(resolution.rates.back()));
    }
  }
  return resolution;
}

int RollingSheet::unknowns(int terms) const {
  return 2 * (terms + 1) + 2 + 2 * static_cast<int>(inverse.size());
}

void RollingSheet::check(double half_length) const {
  constexpr double shortest_memory = 1e-8, longest_memory = 1e8;
  for (const RollingMemory& term : material.normal) {
    const double length = 2 * half_length;
    if (is_flow(term)) continue;
    const double shortest = 1 / static_cast<double>(abs(term.rate)),
                 longest = 1 / static_cast<double>(term.rate.re);
    if (shortest < shortest_memory * length || longest > longest_memory * length)
      throw data::BadInput("nip.material", shortest / length,
                           "must have relaxation lengths from 1e-8 to 1e8 contacts for the reference");
  }
}

int RollingSheet::lost_digits() const {
  double softness = 1;
  for (const RollingMemory& term : material.normal)
    softness +=
        static_cast<double>(is_flow(term) ? abs(term.amplitude) : abs(term.amplitude) / abs(term.rate));
  return static_cast<int>(std::log10(softness));
}

namespace {

using Index = Matrix::Index;

/// The columns of direct_row(): the known part, edge_displacement, the offset, then Re and Im of each b_j n_j.
constexpr Index known = 0, edge = 1, shift = 2, first_memory = 3;
/// The two rows or columns of a complex number, from its first one on.
constexpr Index real_part = 0, imaginary_part = 1;

struct EvenAndOdd {
  Matrix even, odd;
};

/// The functionals int kind p/pi of an even and of an odd pressure.
std::vector<LineFunctional> both_parts(Influence kind) {
  std::vector<LineFunctional> parts(2);
  for (LineFunctional& part : parts) part.pressure(kind, 1 / pi());
  parts[1].parity = -1;
  return parts;
}

Fineness fineness_of_traces(double nats) { return {1.5, 2, nats}; }

/// Panels outside the contact. The first is as narrow as the first panel in the contact.
std::vector<TractionPanel> outside_panels(const Float& far, const Resolution& resolution,
                                          const TractionPanel& inside, double nats) {
  Fineness fineness = fineness_of_traces(nats);
  fineness.first = static_cast<double>(inside.width) / resolution.first;
  return panels_of(far, resolution, fineness);
}

/// Appends panels that grow from a place on, downstream or upstream, the first with a root of the distance or without.
void append(std::vector<TracePanel>& panels, const std::vector<TractionPanel>& growing, const Float& place,
            bool downstream, bool has_root, int extra_terms) {
  using Root = TracePanel::Root;
  const Root end = downstream ? Root::left : Root::right;
  std::vector<TracePanel> added;
  for (const TractionPanel& panel : growing) {
    const Float left = downstream ? Float(place + panel.left) : Float(place - panel.left - panel.width);
    const bool root = has_root && panel.left == 0;
    added.push_back({left, panel.width, root ? end : Root::none, panel.terms + (root ? extra_terms : 0)});
  }
  if (!downstream) std::ranges::reverse(added);
  panels.insert(panels.end(), added.begin(), added.end());
}

/// The number of nodes that integrate f times e^(-rate w) on a panel outside the contact; n nodes are exact for 2n
/// coefficients. On the ellipse for the panel's terms, with semi-axes of 3 and 2.8 half widths, a real memory is at
/// most 1, an oscillating one at most e^(1.4 |Im rate| width), which takes 0.8 |Im rate| width more coefficients.
int nodes_of(const TractionPanel& panel, const Resolution& resolution) {
  double turn = 0;
  for (const std::complex<double>& rate : resolution.rates)
    turn = std::max(turn, std::fabs(rate.imag()) * static_cast<double>(panel.width));
  return panel.terms / 2 + static_cast<int>(0.4 * std::min(turn, 2.0 * panel.terms)) + 4;
}

/// The solutions for all columns of `right`.
Matrix refined_solutions(const Matrix& matrix, const Matrix& right) {
  Matrix solution(right.rows(), right.cols());
  for (Index k = 0; k < right.cols(); ++k) solution.col(k) = refined_solution(matrix, Vector(right.col(k)));
  return solution;
}

/// The contact of a steadily rolling viscoelastic sheet as a sum of elastic contacts, whose right-hand sides the
/// inverse compliance makes from the displacement: ref/viscoelastic_nip/README.md, Rolling contacts. n_j is the part of
/// memory j that comes from ahead of the contact.
class RollingSolution : public NipSolution {
 public:
  /// Integrals are good to about e^-nats.
  RollingSolution(const RollingSheet& sheet, Tractions tractions, double nats, SheetKernels& kernels)
      : NipSolution(std::move(tractions), kernels),
        sheet_(sheet),
        outside_(outside_panels(kernels.far(), sheet_.resolution(), tractions_.panels().front(), nats)),
        nats_(nats) {
    const EvenAndOdd parts = bounded_parts();
    const Matrix zero = conditions(parts);
    const Index unknown = zero.rows(), columns = tractions_.columns();
    amplitudes_ = Vector(unknown + 1);
    amplitudes_(known) = 1;
    amplitudes_.bottomRows(unknown) = ref::solve<Float>(zero.rightCols(unknown), -zero.col(known));
    edge_displacement_ = amplitudes_(edge) * half_length() * half_length();
    offset_ = amplitudes_(shift) * half_length();
    const Vector even = Matrix(parts.even.topRows(columns)) * amplitudes_,
                 odd = Matrix(parts.odd.topRows(columns)) * amplitudes_;
    leading_ = even + odd;
    trailing_ = even - odd;
    load_ = 2 * tractions_.integral().cwiseProduct(even).sum();
    moment_ = 2 * tractions_.moment().cwiseProduct(odd).sum();
  }

  /// dW/dA has the product of both ends' coefficients: the same load rolls the other way with the ends exchanged.
  [[nodiscard]] Float growth() const override {
    const Float leading = tractions_.at_root(leading_).pressure,
                trailing = tractions_.at_root(trailing_).pressure;
    return pi() * half_length() * leading * trailing / (4 * tractions_.panels().front().width * load_);
  }

  [[nodiscard]] Float normal(const Float& x) const override {
    const Float& size = half_length();
    if (x >= 0 && x <= 2 * size) return on_roller(x);
    Float sum = elastic(Influence::normal, x);
    for (const auto& [amplitude, rate] : sheet_.material.normal)
      sum += (amplitude * elastic_trace(Influence::normal).faded(rate, x)).re;
    return sum;
  }

  /// theta2 P - N g, P the pressure's integral up to x, g = int I3(x - x') p(x') dx'/pi less its value far ahead.
  [[nodiscard]] Float tangential(const Float& x) const override {
    const RollingMaterial& material = sheet_.material;
    const ComplexFloat at_once;
    Float sum = material.theta2_at_once * pressure_trace().faded(at_once, x).re -
                (load_ / 4 - elastic(Influence::coupling, x));
    for (const auto& [amplitude, rate] : material.theta2)
      sum += (amplitude * pressure_trace().faded_integral(rate, x)).re;
    for (const auto& [amplitude, rate] : material.normal) {
      const Trace& trace = elastic_trace(Influence::coupling);
      ComplexFloat faded = trace.faded(rate, x);
      // Behind the last panel g is constant.
      if (x > trace.end()) faded = faded + faded_power(rate, x - trace.end(), 0) * Float(load_ / 2);
      sum -= (amplitude * faded).re;
    }
    return sum;
  }

  [[nodiscard]] Float strain(const Float& x) const override {
    const RollingMaterial& material = sheet_.material;
    Float sum = elastic(Influence::coupling_slope, x) - material.theta2_at_once * tractions(x).pressure;
    for (const auto& [amplitude, rate] : material.theta2)
      sum -= (amplitude * pressure_trace().faded(rate, x)).re;
    for (const auto& [amplitude, rate] : material.normal)
      sum += (amplitude * elastic_trace(Influence::coupling_slope).faded(rate, x)).re;
    return sum;
  }

 private:
  /// f in the contact: the known part, and the parts of an edge displacement A^2, of an offset A, and of b_j n_j = A^2.
  [[nodiscard]] Vector direct_row(const Float& x) const {
    const Float& size = half_length();
    const auto modes = static_cast<Index>(sheet_.inverse.size());
    Vector row(first_memory + 2 * modes);
    std::array<Float, 3> powers{1, x, x * x / 2};
    for (Index j = 0; j < modes; ++j) {
      const auto& [amplitude, rate] = sheet_.inverse[static_cast<std::size_t>(j)];
      for (int k = 0; k < 3; ++k)
        powers[static_cast<std::size_t>(k)] += (amplitude * faded_power(rate, x, k)).re;
      const ComplexFloat wave = exp(-(rate * x)) * Float(size * size);
      row(first_memory + 2 * j + real_part) = wave.re;
      row(first_memory + 2 * j + imaginary_part) = -wave.im;
    }
    row(known) = 2 * size * powers[1] - 2 * powers[2];
    row(edge) = size * size * powers[0];
    row(shift) = 2 * size * powers[1];
    return row;
  }

  /// int_0^inf e^(-r_i w) f(-w) dw as rows for the coefficients of the even and then of the odd part of the pressure.
  /// Each memory has two rows, for the real and the imaginary part.
  [[nodiscard]] Matrix memory_rows() const {
    const Index columns = tractions_.columns();
    const auto count = static_cast<Index>(sheet_.material.normal.size());
    Matrix result(2 * count, 2 * columns);
    Float slowest = sheet_.material.normal.empty() ? Float(0) : sheet_.material.normal.front().rate.re;
    for (const RollingMemory& term : sheet_.material.normal) slowest = std::min(slowest, term.rate.re);
    for (const TractionPanel& panel : outside_) {
      if (count == 0 || slowest * panel.left > nats_) break;
      const UnitRule rule = gauss_rule(nodes_of(panel, sheet_.resolution()));
      for (std::size_t i = 0; i < rule.size(); ++i) {
        // Next to the end f is analytic in the root of the distance.
        const Float& xi = rule.from_left[i];
        const bool at_end = panel.left == 0;
        const Float way = panel.left + panel.width * (at_end ? Float(xi * xi) : xi);
        const Float weight = panel.width * rule.weight[i] * (at_end ? Float(2 * xi) : Float(1));
        const std::vector<Vector> rows = tractions_.rows(-way, both_parts(Influence::normal), kernels_);
        for (Index m = 0; m < count; ++m) {
          const ComplexFloat factor =
              exp(-(sheet_.material.normal[static_cast<std::size_t>(m)].rate * way)) * weight;
          for (Index part = 0; part < 2; ++part) {
            const Vector& row = rows[static_cast<std::size_t>(part)];
            result.row(2 * m + real_part).middleCols(part * columns, columns) += factor.re * row.transpose();
            if (!factor.is_real())
              result.row(2 * m + imaginary_part).middleCols(part * columns, columns) +=
                  factor.im * row.transpose();
          }
        }
      }
    }
    return result;
  }

  /// The even and the odd part of the pressure for each column of direct_row(), with the constant or the line below it.
  [[nodiscard]] EvenAndOdd bounded_parts() const {
    const std::vector<Float> points = tractions_.matching_points();
    const auto rows = static_cast<Index>(points.size());
    const Index beside = tractions_.columns(), sides = direct_row(0).size();
    const Float& size = half_length();
    Matrix even(rows, rows), odd(rows, rows), even_right(rows, sides), odd_right(rows, sides);
    for (Index i = 0; i < rows; ++i) {
      const Float& e = points[static_cast<std::size_t>(i)];
      const std::vector<Vector> here = tractions_.rows(e, both_parts(Influence::normal), kernels_);
      even.row(i).leftCols(beside) = here[0].transpose();
      odd.row(i).leftCols(beside) = here[1].transpose();
      even(i, beside) = -size;
      odd(i, beside) = -(size - e);
      const Vector leading = direct_row(e), trailing = direct_row(2 * size - e);
      even_right.row(i) = (leading + trailing).transpose() / Float(2);
      odd_right.row(i) = (leading - trailing).transpose() / Float(2);
    }
    return {refined_solutions(even, even_right), refined_solutions(odd, odd_right)};
  }

  /// The numbers that must be 0, by the columns of direct_row(): the constant, the line, and for each n_j, in real and
  /// imaginary part, n_j less the n_j of the pressure.
  [[nodiscard]] Matrix conditions(const EvenAndOdd& parts) const {
    constexpr Index constant = 0, line = 1, first_condition = 2;
    const Index columns = tractions_.columns(), sides = parts.even.cols();
    const Float square = half_length() * half_length();
    const Matrix rows = memory_rows();
    const Matrix remembered = Matrix(rows.leftCols(columns)) * Matrix(parts.even.topRows(columns)) +
                              Matrix(rows.rightCols(columns)) * Matrix(parts.odd.topRows(columns));
    Matrix result(sides - 1, sides);
    result.row(constant) = parts.even.row(columns);
    result.row(line) = parts.odd.row(columns);
    Index row = first_condition, column = first_memory;
    for (const auto& [amplitude, rate] : sheet_.inverse) {
      result(row + real_part, column + real_part) = 1;
      result(row + imaginary_part, column + imaginary_part) = 1;
      Index its_row = 0;
      for (const auto& [its_amplitude, its_rate] : sheet_.material.normal) {
        const ComplexFloat factor = amplitude * its_amplitude / (rate - its_rate) / square;
        const auto real = remembered.row(its_row + real_part),
                   imaginary = remembered.row(its_row + imaginary_part);
        result.row(row + real_part) -= factor.re * real - factor.im * imaginary;
        result.row(row + imaginary_part) -= factor.re * imaginary + factor.im * real;
        its_row += 2;
      }
      row += 2;
      column += 2;
    }
    return result;
  }

  /// int kind p/pi, where alpha = x' - x is positive upstream.
  [[nodiscard]] Float elastic(Influence kind, const Float& x) const {
    const bool leads = x <= half_length(), is_odd = kind == Influence::coupling;
    const Float e = leads ? x : Float(2 * half_length() - x);
    const std::vector<Vector> rows = tractions_.rows(e, both_parts(kind), kernels_);
    const Vector even = leading_ + trailing_, odd = leading_ - trailing_;
    const Float of_even = rows[0].cwiseProduct(even).sum() / 2, of_odd = rows[1].cwiseProduct(odd).sum() / 2;
    if (leads) return of_even + of_odd;
    return is_odd ? Float(of_odd - of_even) : Float(of_even - of_odd);
  }

  [[nodiscard]] const Trace& pressure_trace() const {
    if (!pressure_) {
      const std::vector<TractionPanel>& own = tractions_.panels();
      std::vector<TracePanel> panels;
      append(panels, own, 0, true, true, own.front().terms + 1);
      append(panels, own, 2 * half_length(), false, true, own.front().terms + 1);
      pressure_ = Trace(
          std::move(panels), [this](const Float& x) { return tractions(x).pressure; }, nats_);
    }
    return *pressure_;
  }

  /// The trace of f (normal), in the contact by the roller, of the g of tangential() (coupling), or of the slope of g.
  [[nodiscard]] const Trace& elastic_trace(Influence kind) const {
    const auto found = elastic_.find(kind);
    if (found != elastic_.end()) return found->second;
    const auto function = [this, kind](const Float& x) -> Float {
      if (kind == Influence::normal && x >= 0 && x <= 2 * half_length())
        return direct_row(x).cwiseProduct(amplitudes_).sum();
      const Float value = elastic(kind, x);
      return kind == Influence::coupling ? Float(load_ / 4 - value) : value;
    };
    // g is smooth on the scale of half a thickness, even if the pressure is not, and has no roots at the ends.
    const bool has_roots = kind == Influence::normal;
    Resolution resolution = sheet_.resolution();
    if (!has_roots) resolution.first = 1;
    const Fineness fineness = fineness_of_traces(nats_);
    const std::vector<TractionPanel> inside = panels_of(half_length(), resolution, fineness),
                                     outside = has_roots ? outside_
                                                         : panels_of(kernels_.far(), resolution, fineness);
    std::vector<TracePanel> panels;
    append(panels, outside, 0, false, has_roots, 0);
    append(panels, inside, 0, true, false, 0);
    append(panels, inside, 2 * half_length(), false, false, 0);
    append(panels, outside, 2 * half_length(), true, has_roots, 0);
    return elastic_.emplace(kind, Trace(std::move(panels), function, nats_)).first->second;
  }

  const RollingSheet& sheet_;
  std::vector<TractionPanel>
      outside_;  ///< panels from an end outwards, to where the elastic sheet moves no more
  double nats_;
  Vector amplitudes_;  ///< of the columns of direct_row()
  mutable std::optional<Trace> pressure_;
  mutable std::map<Influence, Trace> elastic_;
};

}  // namespace

std::unique_ptr<NipSolution> RollingSheet::solved(const Float& half_length, std::vector<TractionPanel> panels,
                                                  double nats, SheetKernels& kernels) const {
  return std::make_unique<RollingSolution>(*this, Tractions(half_length, std::move(panels), 0, false, nats),
                                           nats, kernels);
}

}  // namespace nipref::ref
