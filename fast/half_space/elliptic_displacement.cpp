#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/internal/line_errors.hpp>
#include <nipref/fast/number/internal/adaptive_panels.hpp>

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

/// artanh t for 0 <= t < 1, arcoth t beyond; at t = 1, where it is infinite, its value a rounding away.
double area_function(double t) {
  return std::log1p(2 * std::min(t, 1.0) / std::max(std::fabs(1 - t), 0x1p-53)) / 2;
}

/// g(t) = t + (1 - t^2) area_function(t) for t >= 0: H[max(0, 1 - xi^2)](t) = -(2/pi) g(t).
double hilbert_of_parabola(double t) {
  if (t < 2) return t + (1 - t * t) * area_function(t);
  // In powers of 1/t, as the terms above cancel.
  double sum = 0, power = 1 / t;
  for (double k = 1; power > 0x1p-55 * sum; k += 2, power /= t * t) sum += 2 * power / (k * (k + 2));
  return sum;
}

/// A part of the integral over the lines: m = start turned by +-angle, angle from lower to upper. The place is on the line
/// of m for which t = at_start cos(angle) + slope sin(angle), with which t keeps its digits where it is small.
struct Arc {
  Scaled start;
  double sense, at_start, slope, lower, upper;
};

/// The lines of half a turn for the place e: in both senses from the major axis to the line across e, where t = 0. Each half of
/// an arc begins at its own end, where w and t may be small; the lines that touch the ellipse part it.
std::vector<Arc> arcs_to(const Scaled& e) {
  const double distance = std::hypot(e.first, e.second);
  Scaled across = distance > 0 ? Scaled{-e.second / distance, e.first / distance} : Scaled{0, 1};
  if (std::signbit(across.second)) across = {-across.first, -across.second};
  const double touching = distance > 1 ? std::asin(1 / distance) : std::numbers::pi;
  std::vector<Arc> arcs;
  for (const double sense : {1.0, -1.0}) {
    const double length = std::atan2(across.second, sense * across.first), half = length / 2;
    const auto add = [&](Arc arc, double touches) {
      const double edge = std::clamp(touches, 0.0, half);
      for (const auto& [lower, upper] : {std::pair(0.0, edge), std::pair(edge, half)}) {
        if (!(upper > lower)) continue;
        arc.lower = lower;
        arc.upper = upper;
        arcs.push_back(arc);
      }
    };
    add({{1, 0}, sense, e.first, sense * e.second, 0, 0}, length - touching);
    const double slope = e.first * -across.second + e.second * across.first;
    add({across, -sense, 0, -sense * slope, 0, 0}, touching);
  }
  return arcs;
}

/// What a line adds to the displacement: its response, its width w, and R and H[R] over pi p0 a/2, all with b as unit of
/// length.
struct Line {
  LineResponse y;
  Direction n;  ///< from the motion
  double t, width, pressed, pulled;

  /// The displacement along the motion, across it and into the half-space, and its size. That is added to the first two, which
  /// may vanish, so that they are integrated to the rounding of their size.
  [[nodiscard]] std::array<double, 4> terms() const {
    const double size = y.compliance * (pressed + std::fabs(pulled));
    const double along = y.shear_compliance * pressed + y.coupling * pulled;
    const double across = y.shear_compliance_across * pressed + y.coupling_across * pulled;
    return {n.cosine * along - n.sine * across + size, n.sine * along + n.cosine * across + size,
            y.compliance * pressed, size};
  }
  /// By a relative change of the force or the response the displacement in the surface and that into it change at most by
  /// these times as much; by one of the width w by three times that, as w d/dw of (1 - t^2)/w and g/w is at most 2/w and
  /// (3 g + 2 area_function)/w.
  [[nodiscard]] std::array<double, 2> changes() const {
    const double inside = std::fabs(t) < 1 ? width : 0;
    const double shear = std::fabs(y.shear_compliance) + std::fabs(y.shear_compliance_across),
                 coupling = std::fabs(y.coupling) + std::fabs(y.coupling_across);
    const double logarithm = 2 / std::numbers::pi * width * area_function(std::fabs(t));
    return {(y.compliance + shear) * inside + (y.compliance + coupling) * (std::fabs(pulled) + logarithm),
            y.compliance * inside};
  }
};

}  // namespace

// With R = (pi p0 a b/2 w) (1 - t^2) the integral of the pressure over the line n.x = s, t = s/w, the displacement is
// (1/2 pi) int (Re Y R + Im Y H[R]) dpsi over half a turn, Y the third column of the inverse impedance: the responses to waves
// along n and -n are conjugate. With m, the unit vector along (a n1, b n2), dpsi/w = w dm/(a b).
std::array<Estimate, 3> EllipticContact::displacement(const EllipticLoad& load,
                                                      const SurfaceResponse& half_space, Direction psi,
                                                      double x) const {
  if (!std::isfinite(x)) throw data::BadInput("x", x, "must be a finite number");
  const double a = load.semi_major.value, b = load.semi_minor.value, ratio = b / a;
  const Direction place = psi.turned({major_.cosine, -major_.sine, major_.cosine_low, -major_.sine_low});
  const auto line_at = [&](const Arc& arc, double angle) -> Line {
    const Scaled m = arc.start.turned(arc.sense * angle);
    const double t = arc.at_start * std::cos(angle) + arc.slope * std::sin(angle), size = std::fabs(t);
    const double over_width = std::hypot(ratio * m.first, m.second);
    const Direction n = Direction{ratio * m.first / over_width, m.second / over_width}.turned(major_);
    return {half_space(n),
            n,
            t,
            1 / over_width,
            std::max(0.0, (1 - size) * (1 + size)) / over_width,
            -2 / std::numbers::pi * std::copysign(hilbert_of_parabola(size), t) / over_width};
  };
  std::array<Estimate, 4> sums{};
  std::array<double, 2> changes{};
  for (const Arc& arc : arcs_to({x * place.cosine / a, x * place.sine / b})) {
    const auto terms = [&](double angle) { return line_at(arc, angle).terms(); };
    const auto [panels, integral] = internal::adapt_panels<4>(terms, arc.lower, arc.upper);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].value += integral[i].value;
      sums[i].error += integral[i].error;
    }
    for (const internal::Subinterval& panel : panels) {
      internal::visit_nodes(panel, [&](double angle, double weight) {
        const auto here = line_at(arc, angle).changes();
        for (std::size_t i = 0; i < here.size(); ++i) changes[i] += weight * here[i];
      });
    }
  }
  const auto relative = [](const Estimate& number) { return number.error / number.value; };
  // The force is (2 pi/3) p0 a b, so that besides it only w has an error: that of the axes and of their twist.
  const double of_width = std::max(relative(load.semi_major), relative(load.semi_minor)) + twist_error_;
  const double change = relative(load.force) + internal::response_rounding + 3 * of_width;
  const double unit = load.peak_pressure.value * b / 4;
  const auto in_surface = [&](const Estimate& sum) {
    return Estimate{unit * (sum.value - sums[3].value),
                    unit * (sum.error + sums[3].error + change * changes[0])};
  };
  return {in_surface(sums[0]), in_surface(sums[1]),
          Estimate{unit * sums[2].value, unit * (sums[2].error + change * changes[1])}};
}

}  // namespace nipref::fast
