#include <cmath>
#include <functional>
#include <vector>

#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/half_space/sliding.hpp>

namespace nipref::ref {
namespace {

/// cos of an angle in degrees, exactly 0 across.
Float cosine(const Exact& degrees) {
  mpq_class from_90 = 90 - abs(degrees.value());
  return sin(to_float(Exact(from_90)) * pi() / 180);
}

Float sine(const Exact& degrees) { return sin(to_float(degrees) * pi() / 180); }

/// One line of a sliding contact.
struct SlidingLine {
  Float omega;
  Float h;  ///< sqrt(K^2 + (friction (cos(psi) S - sin(psi) S'))^2)

  SlidingLine(const WorkingSurface& surface, const Exact& friction, const Exact& degrees) {
    const WorkingAnswer answer = surface.at(degrees);
    const Float shear =
        to_float(friction) * (cosine(degrees) * answer.coupling - sine(degrees) * answer.coupling_across);
    omega = atan(shear / answer.compliance) / pi() - Float(0.5);
    h = sqrt(answer.compliance * answer.compliance + shear * shear);
  }
  /// Q = (1 + Omega)^(1 + Omega) (-Omega)^(-Omega): peak of the pressure over span/h and curvature.
  [[nodiscard]] Float Q() const { return pow(1 + omega, 1 + omega) * pow(-omega, -omega); }
};

/// int_0^1 f(x, 1 - x) dx for f with algebraic ends.
Float unit_integral(int digits, const std::function<Float(const Float& left, const Float& right)>& f) {
  const Float step = Float(1) / (digits + 20) * 2;
  // Where the weights have fallen to 10^-digits times any algebraic growth of the ends.
  const int last =
      static_cast<int>((std::asinh(2.3026 * (digits + 10) / 3.14159) + 0.5) / static_cast<double>(step));
  Float sum = 0;
  for (int i = -last; i <= last; ++i) {
    const Float s = i * step;
    const Float growth = exp(pi() * sinh(s));
    const Float right = 1 / (1 + growth), left = growth / (1 + growth);
    sum += f(left, right) * step * pi() * cosh(s) * left * right;
  }
  return sum;
}

/// int |x| (x+ - x)^(1 + Omega) (x - x-)^(-Omega) dx for span 1, cut at the kink x = 0.
Float line_moment(const Float& omega, int digits) {
  const Float ahead = -omega, behind = 1 + omega;
  const Float front = unit_integral(digits, [&](const Float& left, const Float& right) {
    const Float x = ahead * left;
    return ahead * x * pow(ahead * right, behind) * pow(x + behind, ahead);
  });
  const Float back = unit_integral(digits, [&](const Float& left, const Float& right) {
    const Float x = behind * left;
    return behind * x * pow(ahead + x, behind) * pow(behind * right, ahead);
  });
  return front + back;
}

}  // namespace

Estimated sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                           int digits) {
  return with_digits(digits, [&](int working) {
    return closed(SlidingLine(WorkingSurface(surface, working), friction, degrees).omega, digits);
  });
}

Estimated sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                             int digits) {
  return with_digits(digits, [&](int working) {
    const WorkingSurface lines(surface, working);
    const SlidingLine along(lines, friction, Exact(0.0)), line(lines, friction, degrees);
    return closed(along.Q() / line.Q() * line.h / along.h, digits);
  });
}

Estimated sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits) {
  return with_digits(digits, [&](int working) {
    const WorkingSurface lines(surface, working);
    const SlidingLine along(lines, friction, Exact(0.0));
    const Float steepness = along.Q() / along.h;
    // On a line of span L the pressure is (C/h) L times that of span 1, and L = steepness h/Q.
    const auto of_line = [&](const Exact& degrees) -> Float {
      const SlidingLine line(lines, friction, degrees);
      const Float span = steepness * line.h / line.Q();
      return pow(span, 3) / line.h * line_moment(line.omega, working);
    };
    const auto [degrees, width] = peak_of_compliance(surface);
    const CrowdedDirections directions(Exact(degrees), width, 1);
    Float sum = 0, change = 1;
    double_directions(digits, directions, of_line, [&](const std::vector<DirectionValue>& values) {
      Float total = 0;
      for (const auto& [at, value] : values) total += at.weight * value;
      total /= static_cast<long>(values.size());
      change = abs(total - sum);
      sum = total;
      return is_settled(change, sum, digits);
    });
    return estimated(sum, change, digits);
  });
}

}  // namespace nipref::ref
