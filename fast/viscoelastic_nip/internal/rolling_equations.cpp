#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_equations.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// int_0^x e^(-rate (x - s)) s^power ds over x^(power + 1), power = 0, 1, 2, as a function of z = rate x.
Complex remembered_power(int power, Complex z) {
  if (std::abs(z) < 2) {
    Complex term = 1.0 / (power + 1), sum = 0;
    for (int n = 0; n < 40; ++n) {
      sum += term;
      term *= -z / (n + power + 2.0);
    }
    return sum;
  }
  const Complex zeroth = (1.0 - std::exp(-z)) / z;
  if (power == 0) return zeroth;
  const Complex first = (1.0 - zeroth) / z;
  return power == 1 ? first : (1.0 - 2.0 * first) / z;
}

/// What the inverse's memory of a rate makes of the roller's displacement at a place: of u_m, of 2 offset and of the
/// parabola, beside the numbers H; and e^(-rate x).
struct Remembered {
  Complex middle, offset, parabola, exponential;

  friend Remembered operator+(const Remembered& a, const Remembered& b) {
    return {a.middle + b.middle, a.offset + b.offset, a.parabola + b.parabola, a.exponential + b.exponential};
  }
  friend Remembered operator*(Complex factor, const Remembered& a) {
    return {factor * a.middle, factor * a.offset, factor * a.parabola, factor * a.exponential};
  }
};

/// Of 1, -y and -y^2 with y = A - x.
Remembered remembered(Complex rate, double half_length, double x) {
  const Complex z = rate * x;
  const Complex p0 = x * remembered_power(0, z), p1 = x * x * remembered_power(1, z),
                p2 = x * x * x * remembered_power(2, z);
  return {p0, -half_length * p0 + p1, -half_length * half_length * p0 + 2 * half_length * p1 - p2,
          std::exp(-z)};
}

/// The same without what is left of e^(-rate x) in it, a polynomial in y: its even or its odd part.
Remembered polynomial_part(Complex rate, double y, bool odd) {
  const Complex twice = 1.0 / rate / rate;
  if (odd) return {0, -y / rate, -2 * y * twice, 0};
  return {1.0 / rate, -twice, -y * y / rate - 2.0 * twice / rate, 0};
}

}  // namespace

RollingEquations::RollingEquations(RollingSheet sheet) : sheet_(std::move(sheet)) {}

Resolution RollingEquations::resolution(double nats) const {
  std::vector<Complex> rates;
  for (const Memory& memory : sheet_.normal.inverse) rates.push_back(memory.rate);
  return {nats, std::numbers::pi, 2, rates};
}

std::vector<RollingEquations::Mode> RollingEquations::modes(const std::vector<Panel>& panels) const {
  std::vector<Mode> result;
  int unknown = 2, layers = 0;
  for (std::size_t j = 0; j < sheet_.normal.inverse.size(); ++j) {
    const Memory& memory = sheet_.normal.inverse[j];
    if (memory.rate.imag() < 0) continue;
    const int columns = memory.rate.imag() > 0 ? 2 : 1;
    result.push_back({memory, j, columns, unknown, is_layer(memory.rate, panels) ? layers++ : -1});
    unknown += columns;
  }
  return result;
}

/// The even and the odd part of the equation at the distance e from either end. For layers the polynomial and the
/// exponential are taken apart: where the memory is short, the odd part is small against the even one.
void RollingEquations::add_matching(const std::vector<Mode>& modes, double half_length, double e,
                                    Eigen::Index row, Equations& equations) const {
  const double y = half_length - e, trailing = 2 * half_length - e;
  for (const bool odd : {false, true}) {
    double of_middle = odd ? 0 : 1, of_offset = odd ? -2 * y : 0, constant = odd ? 0 : -y * y;
    const double sign = odd ? -0.5 : 0.5;
    for (const Mode& mode : modes) {
      const auto& [amplitude, rate] = mode.memory;
      Remembered part;
      if (mode.layer < 0) {
        part = 0.5 * remembered(rate, half_length, e) + sign * remembered(rate, half_length, trailing);
      } else {
        part = polynomial_part(rate, y, odd);
        part.exponential = 0.5 * std::exp(-rate * e) + sign * std::exp(-rate * trailing);
      }
      of_middle += mode.columns * (amplitude * part.middle).real();
      of_offset += mode.columns * 2 * (amplitude * part.offset).real();
      constant += mode.columns * (amplitude * part.parabola).real();
      equations.on_unknowns(row + odd, mode.unknown) = -mode.columns * part.exponential.real();
      if (mode.columns == 2) equations.on_unknowns(row + odd, mode.unknown + 1) = 2 * part.exponential.imag();
    }
    equations.on_unknowns(row + odd, middle_displacement) = -of_middle;
    equations.on_unknowns(row + odd, offset) = -of_offset;
    equations.right(row + odd) = constant;
  }
}

/// The coefficient of a layer is that of its exponential.
void RollingEquations::add_layers(const std::vector<Mode>& modes, Equations& equations) const {
  for (const Mode& mode : modes) {
    if (mode.layer < 0) continue;
    for (int c = 0; c < mode.columns; ++c)
      equations.layers(2 * mode.layer + c, mode.unknown + c) = mode.columns;
  }
}

/// The rows that determine the coefficients of the exponentials.
void RollingEquations::add_closure(const std::vector<Mode>& modes, const Tractions& tractions,
                                   double tolerance, CountedKernels& kernels, Equations& equations) const {
  const RollingKernels rolling(sheet_, kernels);
  const double leading_end[] = {0.0};
  const Eigen::Index first = equations.right.size() - equations.on_unknowns.cols();
  const auto is_layer = [](const Mode& mode) { return mode.layer >= 0; };
  const auto add = [&](const Mode& mode, Complex factor, const Eigen::MatrixXd& memory) {
    const Eigen::Index row = first + mode.unknown;
    equations.on_tractions.row(row) -= factor.real() * memory.row(0) - factor.imag() * memory.row(1);
    if (mode.columns == 2)
      equations.on_tractions.row(row + 1) -= factor.imag() * memory.row(0) + factor.real() * memory.row(1);
  };
  const auto rows = [&](const Tractions::Kernel& kernel) {
    return tractions.rows(leading_end, false, kernel, tolerance);
  };
  for (std::size_t k = 0; k < sheet_.normal.terms.size(); ++k) {
    Eigen::MatrixXd memory, slope;
    if (!std::ranges::all_of(modes, is_layer)) memory = rows(rolling.ahead(k));
    if (std::ranges::any_of(modes, is_layer)) slope = rows(rolling.slope_ahead(k));
    for (const Mode& mode : modes) {
      const Complex factor = sheet_.normal.closure[mode.number][k];
      add(mode, is_layer(mode) ? factor / mode.memory.rate : factor, is_layer(mode) ? slope : memory);
    }
  }
  for (const Mode& mode : modes) {
    for (int c = 0; c < mode.columns; ++c) {
      const Eigen::Index row = first + mode.unknown + c;
      equations.on_unknowns(row, mode.unknown + c) = 1;
      if (!is_layer(mode)) continue;
      const Complex of_offset = 2.0 * (mode.memory.amplitude / mode.memory.rate) / mode.memory.rate;
      const Complex constant = of_offset * (tractions.half_length() + 1.0 / mode.memory.rate);
      equations.on_unknowns(row, offset) = -(c == 0 ? of_offset.real() : of_offset.imag());
      equations.right(row) = c == 0 ? constant.real() : constant.imag();
    }
  }
}

Solution RollingEquations::solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                                 CountedKernels& kernels) const {
  std::vector<Panel> fitted = panels;
  fitted.back().right = 2 * half_length - fitted.back().left;
  const std::vector<Mode> modes = this->modes(fitted);
  std::vector<Complex> layers;
  for (const Mode& mode : modes)
    if (mode.layer >= 0) layers.push_back(mode.memory.rate);
  const Tractions tractions(half_length, fitted, true, 0.5, layers);
  const std::vector<double> points = tractions.matching_points(1);
  const RollingKernels rolling(sheet_, kernels);
  const Eigen::MatrixXd ahead = tractions.rows(points, false, rolling.elastic(), tolerance);

  const auto matching = 2 * static_cast<Eigen::Index>(points.size());
  const auto unknowns = static_cast<Eigen::Index>(2 + sheet_.normal.inverse.size());
  const auto of_layers = static_cast<Eigen::Index>(2 * layers.size());
  Equations equations{Eigen::MatrixXd::Zero(matching + unknowns - 2, tractions.columns()),
                      Eigen::MatrixXd::Zero(matching + unknowns - 2, unknowns),
                      Eigen::VectorXd::Zero(matching + unknowns - 2),
                      Eigen::MatrixXd::Zero(of_layers, unknowns + 1)};
  // Layers act on the other half, too.
  const Eigen::MatrixXd behind =
      of_layers > 0 ? tractions.rows(points, true, rolling.elastic(), tolerance) : Eigen::MatrixXd();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i), row = 2 * at;
    for (std::size_t p = 0; p < fitted.size(); ++p) {
      const int terms = fitted[p].terms + Tractions::left_out;
      for (const int component : {0, 1})
        equations.on_tractions.row(row + component).segment(tractions.column(p, component), terms) =
            ahead.row(at).segment(tractions.column(p, component), terms);
    }
    if (of_layers > 0) {
      const auto here = ahead.row(at).tail(of_layers), there = behind.row(at).tail(of_layers);
      equations.on_tractions.row(row).tail(of_layers) = 0.5 * (here + there);
      equations.on_tractions.row(row + 1).tail(of_layers) = 0.5 * (here - there);
    }
    add_matching(modes, half_length, points[i], row, equations);
  }
  add_layers(modes, equations);
  add_closure(modes, tractions, tolerance, kernels, equations);
  equations.memories = static_cast<int>(unknowns - 2);
  return {tractions, equations};
}

std::vector<AccuracyTarget> RollingEquations::accuracy_targets(const Solution& solution) const {
  const double half_length = solution.half_length(), middle = solution.traction(half_length).real();
  std::vector<AccuracyTarget> targets{{solution.of_unknown(middle_displacement), half_length * half_length},
                                      {solution.of_unknown(offset), 0.1 * half_length},
                                      {linearised_eccentricity(solution), 1e-4 * half_length}};
  for (const Panel& panel : solution.tractions().panels()) {
    const double at = panel.about_middle && !panel.at_end ? half_length : panel.left + 0.2 * panel.width();
    const Eigen::MatrixXd both = solution.tractions().values(at);
    targets.push_back({solution.of_tractions(both.row(0) + both.row(1)), middle});
    targets.push_back({solution.of_tractions(both.row(0) - both.row(1)), middle});
  }
  return targets;
}

double RollingEquations::softening_over(double half_length) const {
  double sum = 1;
  for (const Memory& term : sheet_.normal.terms)
    sum += (term.amplitude / (term.rate + 1 / half_length)).real();
  return sum;
}

double RollingEquations::half_length_guess(double load) const {
  const double stiff = fast::half_length_guess(load);
  return fast::half_length_guess(load * softening_over(stiff));
}

double eccentricity(const Solution& solution) {
  return solution.unknown(RollingEquations::offset) +
         solution.value(solution.moment()) / solution.value(solution.load());
}

Functional linearised_eccentricity(const Solution& solution) {
  const double load = solution.value(solution.load()), moment = solution.value(solution.moment());
  Functional result = solution.of_unknown(RollingEquations::offset);
  result.on_tractions =
      solution.moment().on_tractions / load - moment / load * (solution.load().on_tractions / load);
  return result;
}

}  // namespace nipref::fast
