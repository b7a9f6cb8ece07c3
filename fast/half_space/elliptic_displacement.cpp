#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/internal/line_errors.hpp>
#include <nipref/fast/half_space/internal/pressure_potential.hpp>
#include <nipref/fast/number/internal/adaptive_panels.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {
namespace {

/// A vector in the plane in which the ellipse is the unit circle and its major axis the first axis.
struct Scaled {
  double first, second;

  [[nodiscard]] Scaled turned(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {first * c - second * s, second * c + first * s};
  }
};

/// A part of the integral over the lines: m is `start` turned by sense angle(v), with v from 0 to `last`. The line of m
/// through the place has t = at_start cos(angle) + slope sin(angle), a form in which a small t keeps its digits.
struct Arc {
  Scaled start;
  double sense, at_start, slope;
  double from, core, last;  ///< core is negative if the angle falls with v

  [[nodiscard]] double angle(double v) const { return from + core * std::sinh(v); }
  [[nodiscard]] double slope_of_angle(double v) const { return std::fabs(core) * std::cosh(v); }
};

/// The lines of half a turn for the place e, at a depth in units of b. Arcs run in both senses from the major axis to the
/// line across e, where t = 0. Each half of an arc begins at its own end, where w and t may be small. It is split at the
/// line that touches the ellipse or, if the place is inside the ellipse, at the line nearest to touching. At that line
/// the integrand has a kink on the surface and a bend below it, where t changes by the depth over w. A narrow bend could
/// escape the panels; therefore v is the angle in units of the bend next to the line, and logarithmic farther off.
std::vector<Arc> arcs_to(const Scaled& e, double ratio, double depth) {
  constexpr double half_turn = std::numbers::pi;
  const double distance = std::hypot(e.first, e.second);
  Scaled across = distance > 0 ? Scaled{-e.second / distance, e.first / distance} : Scaled{0, 1};
  if (std::signbit(across.second)) across = {-across.first, -across.second};
  const double touching = distance > 1 ? std::asin(1 / distance) : half_turn / 2;
  const double slope_of_t = std::sqrt(std::max(0.0, (distance - 1) * (distance + 1)));
  std::vector<Arc> arcs;
  for (const double sense : {1.0, -1.0}) {
    const double length = std::atan2(across.second, sense * across.first), half = length / 2;
    const auto add = [&](Arc arc, double touches) {
      const double edge = std::clamp(touches, 0.0, half);
      const Scaled m = arc.start.turned(arc.sense * edge);
      // t = distance cos(angle from e) changes by this next to the line.
      const double change = depth * std::hypot(ratio * m.first, m.second) + std::max(0.0, 1 - distance);
      const double bend =
          2 * change / (slope_of_t + std::sqrt(slope_of_t * slope_of_t + 2 * distance * change) + 0x1p-500);
      // Angles within 2^-30 of the line contribute less than a rounding error of the integral.
      const double core = std::max(std::min(bend, half_turn) + std::fabs(touches - edge), 0x1p-30);
      const auto add_part = [&](double from, double unit, double size) {
        if (!(size > 0)) return;
        arc.from = from;
        arc.core = unit;
        arc.last = std::asinh(size / std::fabs(unit));
        arcs.push_back(arc);
      };
      add_part(0, edge / 2, edge / 2);
      add_part(edge, -core, edge / 2);
      add_part(edge, core, half - edge);
    };
    add({{1, 0}, sense, e.first, sense * e.second, 0, 0, 0}, length - touching);
    const double slope = e.first * -across.second + e.second * across.first;
    add({across, -sense, 0, -sense * slope, 0, 0, 0}, touching);
  }
  return arcs;
}

/// The contribution of a line to the displacement over pi p0 a/4, with b as unit of length: its wave at
/// t + i g depth/w; on the surface Re Y (1 - t^2) w and Im Y H[1 - t^2] w.
struct Line {
  PressureWave wave;
  Direction n;          ///< direction from the motion
  double width, depth;  ///< depth over width
  std::array<internal::PressurePotential, 3> potentials;
  std::complex<double> smooth;  ///< C at the mean place, smooth where decays meet, unlike the wave's parts

  Line(PressureWave of, Direction along, double t, double w, double z)
      : wave(std::move(of)), n(along), width(w), depth(z / w) {
    std::array<std::complex<double>, 3> places;
    for (std::size_t j = 0; j < places.size(); ++j) {
      const std::complex<double> down = std::complex(0.0, depth) * wave.decays[j];
      places[j] = {t + down.real(), down.imag()};
    }
    const std::size_t count = depth > 0 ? wave.count : 1;
    potentials = internal::pressure_potentials(places, count);
    const std::complex<double> mean = (places[0] + places[1] + places[2]) / 3.0;
    smooth = count == 1 ? potentials[0].parabola : internal::pressure_potentials({mean}, 1)[0].parabola;
    std::complex<double> factor = width / std::numbers::pi;
    for (std::size_t j = 0; j < wave.count; ++j, factor *= std::complex(0.0, depth))
      for (auto& component : wave.shares[j]) component *= factor;
  }

  /// The displacements along the motion, across it and into the half-space, each plus a size; then the sizes of the first
  /// two and of the third. With them, parts that may vanish are integrated to the rounding error of what cancels.
  [[nodiscard]] std::array<double, 5> terms() const {
    std::array<double, 3> sums{};
    for (std::size_t j = 0; j < wave.count; ++j)
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += (wave.shares[j][i] * potentials[j].parabola).imag();
    const double in_surface = length(wave.shares[0]) * std::abs(smooth),
                 into = (wave.shares[0][2] * smooth).imag();
    return {n.cosine * sums[0] - n.sine * sums[1] + in_surface,
            n.sine * sums[0] + n.cosine * sums[1] + in_surface, sums[2] + into, in_surface, into};
  }
  /// The largest changes of the displacements in the surface and into the half-space per relative change of the force
  /// or of the response. Per relative change of the width w they are three times as large, as w d/dw of C(s/w)/w is
  /// (2 L - 3 C)/w. The third number is the scale of the rounding errors of the displacement into the half-space.
  [[nodiscard]] std::array<double, 3> changes() const {
    std::array<double, 3> sums{};
    for (std::size_t j = 0; j < wave.count; ++j) {
      const auto& [parabola, logarithm] = potentials[j];
      const std::complex<double> into = wave.shares[j][2];
      const double size = std::abs(parabola) + std::abs(logarithm);
      sums[0] += length(wave.shares[j]) * size;
      sums[1] += std::fabs((into * parabola).imag()) + std::fabs((into * logarithm).imag());
      sums[2] += std::abs(into) * size;
    }
    const double distance = depth * std::abs(wave.decays[0] - wave.decays[2]);
    if (wave.count == 3 && distance > 0) {
      const double size = std::abs(potentials[1].parabola) + std::abs(potentials[1].logarithm);
      const double rounding = length(wave.shares[2]) * size / distance;
      sums[0] += rounding;
      sums[2] += rounding;
    }
    return sums;
  }

 private:
  static double length(const PressureWave::Vector& x) {
    return std::sqrt(std::norm(x[0]) + std::norm(x[1]) + std::norm(x[2]));
  }
};

}  // namespace

// R = (pi p0 a b/2 w) (1 - t^2) is the integral of the pressure over the line n.x = s, with t = s/w. As the responses to
// waves along n and -n are conjugate, the displacement of the surface is (1/2 pi) int (Re Y R + Im Y H[R]) dpsi over half
// a turn, where Y is the third column of the inverse impedance. With R - i H[R] = -i p0 a b C(t)/(2 w) this becomes
// (p0 a b/4 pi) int Im(Y C(t))/w dpsi. Inside, a wave decays as e^{-Gkz}, and C(t) becomes C(t + i G z/w). If m is the unit
// vector along (a n1, b n2), dpsi/w = w dm/(a b).
std::array<Estimate, 3> EllipticContact::displacement(const EllipticLoad& load,
                                                      const PressureWaves& half_space, Direction psi,
                                                      double x, double depth) const {
  internal::check_finite("x", x);
  internal::check_not_negative("depth", depth);
  const double a = load.semi_major.value, b = load.semi_minor.value, ratio = b / a;
  const Direction place = psi.turned({major_.cosine, -major_.sine, major_.cosine_low, -major_.sine_low});
  const auto line_at = [&](const Arc& arc, double angle) -> Line {
    const Scaled m = arc.start.turned(arc.sense * angle);
    const double t = arc.at_start * std::cos(angle) + arc.slope * std::sin(angle);
    const double over_width = std::hypot(ratio * m.first, m.second);
    const Direction n = Direction{ratio * m.first / over_width, m.second / over_width}.turned(major_);
    return {half_space(n), n, t, 1 / over_width, depth / b};
  };
  std::array<Estimate, 5> sums{};
  std::array<double, 3> changes{};
  for (const Arc& arc : arcs_to({x * place.cosine / a, x * place.sine / b}, ratio, depth / b)) {
    const auto terms = [&](double v) {
      auto found = line_at(arc, arc.angle(v)).terms();
      for (double& term : found) term *= arc.slope_of_angle(v);
      return found;
    };
    const auto [panels, integral] = internal::adapt_panels<5>(terms, 0, arc.last);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].value += integral[i].value;
      sums[i].error += integral[i].error;
    }
    for (const internal::Subinterval& panel : panels) {
      internal::visit_nodes(panel, [&](double v, double weight) {
        const auto here = line_at(arc, arc.angle(v)).changes();
        for (std::size_t i = 0; i < here.size(); ++i) changes[i] += weight * arc.slope_of_angle(v) * here[i];
      });
    }
  }
  const auto relative = [](const Estimate& number) { return number.error / number.value; };
  // As the force is (2 pi/3) p0 a b, only the force and w contribute errors; that of w is due to the axes and their twist.
  const double of_width = std::max(relative(load.semi_major), relative(load.semi_minor)) + twist_error_;
  const double change = relative(load.force) + internal::response_rounding + 3 * of_width;
  const double unit = load.peak_pressure.value * b / 4;
  const auto without = [&](const Estimate& sum, const Estimate& size, double of_change) {
    return Estimate{unit * (sum.value - size.value), unit * (sum.error + size.error + of_change)};
  };
  return {without(sums[0], sums[3], change * changes[0]), without(sums[1], sums[3], change * changes[0]),
          without(sums[2], sums[4], change * changes[1] + internal::response_rounding * changes[2])};
}

}  // namespace nipref::fast
