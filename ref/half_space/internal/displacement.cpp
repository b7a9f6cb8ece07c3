#include <algorithm>
#include <limits>
#include <vector>

#include <nipref/ref/half_space/internal/displacement.hpp>
#include <nipref/ref/number/internal/complex_float.hpp>

namespace nipref::ref {
namespace {

/// t + (1 - t^2) artanh t for 0 <= t <= 1, with arcoth t beyond.
Float logarithmic_part(const Float& t) {
  if (t == Float(1)) return t;
  if (t < Float(1)) return t + (1 - t * t) * atanh(t);
  if (t < Float(2)) return t + (1 - t * t) * atanh(Float(1 / t));
  Float sum = 0, term = 1, power = 1 / t;
  for (long k = 1; term > std::numeric_limits<Float>::epsilon() * sum; k += 2, power /= t * t) {
    term = 2 * power / (k * (k + 2));
    sum += term;
  }
  return sum;
}

/// Re Y (1 - t^2) + Im Y H[1 - t^2]: along the line, across it and into the half-space.
std::array<Float, 3> moved_at_surface(const WorkingAnswer& y, const Float& t) {
  const Float size = abs(t), part = 2 / pi() * logarithmic_part(size);
  const Float pressed = std::max(Float(0), Float(1 - t * t)), pulled = t < Float(0) ? part : Float(-part);
  return {y.shear_compliance * pressed + y.coupling * pulled,
          y.shear_compliance_across * pressed + y.coupling_across * pulled, y.compliance * pressed};
}

using ComplexVector = std::array<ComplexFloat, 3>;
using ComplexRows = std::array<ComplexVector, 3>;

ComplexVector product(const ComplexRows& matrix, const ComplexVector& x, const ComplexFloat& shift) {
  ComplexVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = -(shift * x[i]);
    for (std::size_t k = 0; k < 3; ++k) result[i] = result[i] + matrix[i][k] * x[k];
  }
  return result;
}

ComplexFloat square_root(const ComplexFloat& z) {
  const Float size = sqrt(abs(z));
  const ComplexFloat half = log(z) * Float(0.5);
  return size == Float(0) ? ComplexFloat() : ComplexFloat(size * cos(half.im), size * sin(half.im));
}

/// The eigenvalues by Cardano's formula, which must not all be equal.
ComplexVector eigenvalues(const ComplexRows& g) {
  const ComplexFloat third = (g[0][0] + g[1][1] + g[2][2]) / Float(3);
  ComplexRows h = g;  // its trace is 0: x^3 + 3 p x - 2 q = 0
  for (std::size_t i = 0; i < 3; ++i) h[i][i] = g[i][i] - third;
  const auto minor = [&](std::size_t i, std::size_t k) { return h[i][i] * h[k][k] - h[i][k] * h[k][i]; };
  const ComplexFloat p = (minor(0, 1) + minor(1, 2) + minor(0, 2)) / Float(3);
  const ComplexFloat q = (h[0][0] * minor(1, 2) - h[0][1] * (h[1][0] * h[2][2] - h[1][2] * h[2][0]) +
                          h[0][2] * (h[1][0] * h[2][1] - h[1][1] * h[2][0])) /
                         Float(2);
  const ComplexFloat root = square_root(q * q + p * p * p);
  const ComplexFloat cube = abs(q + root) > abs(q - root) ? q + root : q - root;
  const ComplexFloat first = exp(log(cube) / Float(3));
  ComplexVector result;
  for (int i = 0; i < 3; ++i) {
    const Float turn = 2 * pi() * i / 3;
    const ComplexFloat one = first * ComplexFloat(cos(turn), sin(turn));
    result[static_cast<std::size_t>(i)] = third + one - p / one;
  }
  return result;
}

/// int_-1^1 (1 - s^2)/(s - z) ds for Im z > 0.
ComplexFloat parabola_over(const ComplexFloat& z) {
  const ComplexFloat one(Float(1));
  if (abs(z) < Float(1000)) return (one - z * z) * log((z - one) / (z + one)) - z * Float(2);
  // In powers of 1/z, as the terms above cancel.
  ComplexFloat sum, power = one / z;
  const ComplexFloat factor = power * power;
  for (long k = 1; k == 1 || abs(power) > std::numeric_limits<Float>::epsilon() * abs(sum);
       k += 2, power = power * factor)
    sum = sum - power * Float(4) / Float(k * (k + 2));
  return sum;
}

/// Im(P(t + i G depth)/pi Y e3), P = parabola_over, which in the surface is the above: by Lagrange's interpolation of P
/// between the eigenvalues of G. They differ by 10^-digits at least, as G is changed by about its error; it is divided by
/// two such differences, so that what cancels has four times the digits.
std::array<Float, 3> moved_inside(const WorkingAnswer& y, const Float& t, const Float& depth) {
  const int digits = static_cast<int>(Float::thread_default_precision());
  const WorkingDigits scope(4 * digits);
  ComplexRows g;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) g[i][k] = {y.decay->re[i][k], y.decay->im[i][k]};
  for (int i = 0; i < 3; ++i) {
    ComplexFloat& entry = g[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)];
    entry = entry * (1 + (i * i + 1) * tolerance(digits));
  }
  const ComplexVector at_surface{ComplexFloat(y.shear_compliance, y.coupling),
                                 ComplexFloat(y.shear_compliance_across, y.coupling_across),
                                 ComplexFloat(y.compliance)};
  const ComplexVector values = eigenvalues(g);
  std::array<Float, 3> result{Float(0), Float(0), Float(0)};
  for (std::size_t i = 0; i < 3; ++i) {
    const ComplexFloat &own = values[i], &second = values[(i + 1) % 3], &third = values[(i + 2) % 3];
    const ComplexVector part = product(g, product(g, at_surface, second), third);
    const ComplexFloat factor =
        parabola_over({t - depth * own.im, depth * own.re}) / ((own - second) * (own - third)) / pi();
    for (std::size_t k = 0; k < 3; ++k) result[k] += (factor * part[k]).im;
  }
  return result;
}

/// Lines of half a turn about the peak of the compliance, as angle = centre + width sinh(v), |angle - centre| <= pi/2: the
/// compliance's singularities about its peak are at v = +-i pi/2.
struct CentredLines {
  Float centre, width;

  explicit CentredLines(const PeakOfCompliance& peak)
      : centre(peak.degrees * pi() / 180), width(peak.width) {}
  [[nodiscard]] Float angle(const Float& v) const { return centre + width * sinh(v); }
  /// Of the line at this angle or turned by half turns.
  [[nodiscard]] Float v(const Float& angle) const {
    const Float off = angle - centre;
    return asinh(Float((off - pi() * round(Float(off / pi()))) / width));
  }
};

/// The ends of the parts of these lines: across the place, along the minor axis, at the peak of the compliance, where lines
/// touch the ellipse, and where they come nearest to that if the place is within it.
std::vector<Float> ends_of_parts(const CentredLines& lines, const EllipticPressure& on, const Float& psi,
                                 const Float& x) {
  const Float right = pi() / 2;
  std::vector<Float> angles{psi + right, on.major + right, lines.centre};
  // In the plane in which the ellipse is the unit circle.
  const Float first = x * cos(Float(psi - on.major)) / on.a, second = x * sin(Float(psi - on.major)) / on.b;
  const Float angle = atan2(second, first), distance = hypot(first, second);
  const Float off = distance > Float(1) ? acos(Float(1 / distance)) : Float(0);
  for (const Float& each : {Float(angle - off), Float(angle + off)})
    angles.push_back(on.major + atan2(Float(sin(each) / on.b), Float(cos(each) / on.a)));
  const Float last = asinh(Float(right / lines.width));
  std::vector<Float> ends{-last, last};
  for (const Float& each : angles) ends.push_back(lines.v(each));
  std::ranges::sort(ends);
  return ends;
}

}  // namespace

std::array<Float, 3> displacement_under(const EllipticPressure& on, const WorkingSurface& half_space,
                                        const PeakOfCompliance& peak, const PlaceInside& place, int digits) {
  const auto& [psi, x, depth] = place;
  std::array<Float, 3> sums{Float(0), Float(0), Float(0)};
  const CentredLines lines(peak);
  const auto add_line = [&](const Float& v, const Float& dv) {
    const Float angle = lines.angle(v), weight = dv * lines.width * cosh(v);
    const WorkingAnswer y = half_space.at(to_exact(Float(angle * 180 / pi())));
    const Float width =
        hypot(Float(on.a * cos(Float(angle - on.major))), Float(on.b * sin(Float(angle - on.major))));
    const Float t = x * cos(Float(angle - psi)) / width, share = weight / width;
    const auto [along, across, into] =
        depth == Float(0) ? moved_at_surface(y, t) : moved_inside(y, t, depth / width);
    const Float c = cos(angle), s = sin(angle);
    sums[0] += share * (c * along - s * across);
    sums[1] += share * (s * along + c * across);
    sums[2] += share * into;
  };
  const std::vector<Float> ends = ends_of_parts(lines, on, psi, x);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Float length = ends[i + 1] - ends[i];
    if (!(length > tolerance(digits))) continue;
    for (const UnitNode& node : *unit_nodes(digits)) {
      const bool is_left = node.left < node.right;
      add_line(is_left ? Float(ends[i] + length * node.left) : Float(ends[i + 1] - length * node.right),
               length * node.weight);
    }
  }
  for (Float& sum : sums) sum *= on.peak * on.a * on.b / 4;
  return sums;
}

}  // namespace nipref::ref
