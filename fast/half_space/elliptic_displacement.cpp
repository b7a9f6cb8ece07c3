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
  /// The reciprocal of the half-width w over b of the ellipse along the line of this unit vector.
  [[nodiscard]] double over_width(double ratio) const { return std::hypot(ratio * first, second); }
};

/// Lines whose m is `start` turned by sense times an angle. The line through the place has t = at_start cos(angle) +
/// slope sin(angle), a form in which a small t keeps its digits.
struct Arc {
  Scaled start;
  double sense, at_start, slope;

  [[nodiscard]] Scaled m(double angle) const { return start.turned(sense * angle); }
  [[nodiscard]] double t(double angle) const { return at_start * std::cos(angle) + slope * std::sin(angle); }
};

/// A part of the integral over the lines: those of an arc at the angles origin + unit sinh v, with v from 0 to `last`.
struct Part {
  Arc arc;
  double origin, unit, last;  ///< the unit is negative if the angle falls with v

  [[nodiscard]] double angle(double v) const { return origin + unit * std::sinh(v); }
  [[nodiscard]] double slope_of_angle(double v) const { return std::fabs(unit) * std::cosh(v); }
};

/// The lines of half a turn for the place e, at a depth in units of b. Arcs run in both senses from the major axis to the
/// line across e, where t = 0. Each half of an arc begins at its own end, where w and t may be small. It is split at the
/// line that touches the ellipse or, if the place is inside the ellipse, at the line nearest to touching. At that line
/// the integrand has a kink on the surface and a bend below it, where t changes by the depth over w. A narrow bend could
/// escape the panels; therefore v is the angle in units of the bend next to the line, and logarithmic farther off.
std::vector<Part> integral_parts(const Scaled& e, double ratio, double depth) {
  constexpr double half_turn = std::numbers::pi;
  const double distance = std::hypot(e.first, e.second);
  Scaled across = distance > 0 ? Scaled{-e.second / distance, e.first / distance} : Scaled{0, 1};
  if (std::signbit(across.second)) across = {-across.first, -across.second};
  const double slope_across = e.first * -across.second + e.second * across.first;
  const double across_to_touching = distance > 1 ? std::asin(1 / distance) : half_turn / 2;
  const double slope_of_t = std::sqrt(std::max(0.0, (distance - 1) * (distance + 1)));
  std::vector<Part> parts;
  const auto add = [&](const Arc& arc, double from, double unit, double size) {
    if (size > 0) parts.push_back({arc, from, unit, std::asinh(size / std::fabs(unit))});
  };
  for (const double sense : {1.0, -1.0}) {
    const double length = std::atan2(across.second, sense * across.first), half = length / 2;
    const auto add_half = [&](const Arc& arc, double touching) {
      const double split = std::clamp(touching, 0.0, half);
      // t = distance cos(angle from e) changes by this next to the line.
      const double change = depth * arc.m(split).over_width(ratio) + std::max(0.0, 1 - distance);
      const double bend =
          2 * change / (slope_of_t + std::sqrt(slope_of_t * slope_of_t + 2 * distance * change) + 0x1p-500);
      // A narrower bend changes the integrand by about its angle, over this angle: with 2^-30 the effect is 2^-60.
      const double unit = std::max(std::min(bend, half_turn) + std::fabs(touching - split), 0x1p-30);
      add(arc, 0, split / 2, split / 2);
      add(arc, split, -unit, split / 2);
      add(arc, split, unit, half - split);
    };
    add_half({{1, 0}, sense, e.first, sense * e.second}, length - across_to_touching);
    add_half({across, -sense, 0, -sense * slope_across}, across_to_touching);
  }
  return parts;
}

/// The contribution of a line to the displacement over pi p0 a/4, with b as unit of length: its wave at
/// t + i g depth/w; on the surface Re Y (1 - t^2) w and Im Y H[1 - t^2] w.
struct Line {
  PressureWave wave;
  Direction n;          ///< direction from the motion
  double width, depth;  ///< depth over width
  std::array<internal::PressurePotential, 3> potentials;
  std::complex<double> smooth;  ///< C at the mean place, smooth where decays meet, unlike the wave's parts

  Line(PressureWave of, Direction direction, double t, double w, double z)
      : wave(std::move(of)), n(direction), width(w), depth(z / w) {
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

  /// The displacements along the motion, across it and into the half-space, each plus a size; then the size of the first
  /// two and that of the third. With them, parts that may vanish are integrated to the rounding error of what cancels.
  enum Term : std::size_t { along, across, into, size_in_surface, size_into, term_count };
  [[nodiscard]] std::array<double, term_count> terms() const {
    std::array<double, 3> sums{};
    for (std::size_t j = 0; j < wave.count; ++j)
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += (wave.shares[j][i] * potentials[j].parabola).imag();
    const double in_surface = length(wave.shares[0]) * std::abs(smooth),
                 downward = (wave.shares[0][2] * smooth).imag();
    return {n.cosine * sums[0] - n.sine * sums[1] + in_surface,
            n.sine * sums[0] + n.cosine * sums[1] + in_surface, sums[2] + downward, in_surface, downward};
  }
  /// The largest changes of the displacements in the surface and into the half-space per relative change of the force
  /// or of the response. Per relative change of the width w they are three times as large, as w d/dw of C(s/w)/w is
  /// (2 L - 3 C)/w. The third number is the scale of the rounding errors of the displacement into the half-space.
  enum Change : std::size_t { change_in_surface, change_into, rounding_into, change_count };
  [[nodiscard]] std::array<double, change_count> changes() const {
    std::array<double, change_count> sums{};
    for (std::size_t j = 0; j < wave.count; ++j) {
      const auto& [parabola, logarithm] = potentials[j];
      const std::complex<double> share = wave.shares[j][2];
      const double size = std::abs(parabola) + std::abs(logarithm);
      sums[change_in_surface] += length(wave.shares[j]) * size;
      sums[change_into] += std::fabs((share * parabola).imag()) + std::fabs((share * logarithm).imag());
      sums[rounding_into] += std::abs(share) * size;
    }
    const double distance = depth * std::abs(wave.decays[0] - wave.decays[2]);
    if (wave.count == 3 && distance > 0) {
      const double size = std::abs(potentials[1].parabola) + std::abs(potentials[1].logarithm);
      const double rounding = length(wave.shares[2]) * size / distance;
      sums[change_in_surface] += rounding;
      sums[rounding_into] += rounding;
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
    const Scaled m = arc.m(angle);
    const double over_width = m.over_width(ratio);
    const Direction n = Direction{ratio * m.first / over_width, m.second / over_width}.turned(major_);
    return {half_space(n), n, arc.t(angle), 1 / over_width, depth / b};
  };
  std::array<Estimate, Line::term_count> sums{};
  std::array<double, Line::change_count> changes{};
  for (const Part& part : integral_parts({x * place.cosine / a, x * place.sine / b}, ratio, depth / b)) {
    const auto terms = [&](double v) {
      auto found = line_at(part.arc, part.angle(v)).terms();
      for (double& term : found) term *= part.slope_of_angle(v);
      return found;
    };
    const auto [panels, integral] = internal::adapt_panels<Line::term_count>(terms, 0, part.last);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].value += integral[i].value;
      sums[i].error += integral[i].error;
    }
    for (const internal::Subinterval& panel : panels)
      internal::visit_nodes(panel, [&](double v, double weight) {
        const auto here = line_at(part.arc, part.angle(v)).changes();
        for (std::size_t i = 0; i < here.size(); ++i) changes[i] += weight * part.slope_of_angle(v) * here[i];
      });
  }
  const auto relative = [](const Estimate& number) { return number.error / number.value; };
  // As the force is (2 pi/3) p0 a b, only the force and w contribute errors; that of w is due to the axes and their twist.
  const double of_width = std::max(relative(load.semi_major), relative(load.semi_minor)) + twist_error_;
  const double change = relative(load.force) + internal::response_rounding + 3 * of_width;
  const double unit = load.peak_pressure.value * b / 4;
  using enum Line::Term;
  using enum Line::Change;
  const auto without = [&](const Estimate& sum, const Estimate& size, double of_change) {
    return Estimate{unit * (sum.value - size.value), unit * (sum.error + size.error + of_change)};
  };
  const double in_surface = change * changes[change_in_surface];
  return {without(sums[along], sums[size_in_surface], in_surface),
          without(sums[across], sums[size_in_surface], in_surface),
          without(sums[into], sums[size_into],
                  change * changes[change_into] + internal::response_rounding * changes[rounding_into])};
}

}  // namespace nipref::fast
