#include <algorithm>
#include <limits>
#include <vector>

#include <nipref/ref/half_space/internal/displacement.hpp>

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
                                        const PeakOfCompliance& peak, const Float& psi, const Float& x,
                                        int digits) {
  std::array<Float, 3> sums{Float(0), Float(0), Float(0)};
  const CentredLines lines(peak);
  const auto add_line = [&](const Float& v, const Float& dv) {
    const Float angle = lines.angle(v), weight = dv * lines.width * cosh(v);
    const WorkingAnswer y = half_space.at(to_exact(Float(angle * 180 / pi())));
    const Float width =
        hypot(Float(on.a * cos(Float(angle - on.major))), Float(on.b * sin(Float(angle - on.major))));
    const Float t = x * cos(Float(angle - psi)) / width, size = abs(t), share = weight / width;
    const Float pressed = size < Float(1) ? Float(share * (1 - t * t)) : Float(0);
    const Float part = 2 / pi() * share * logarithmic_part(size), pulled = t < Float(0) ? part : Float(-part);
    const Float along = y.shear_compliance * pressed + y.coupling * pulled;
    const Float across = y.shear_compliance_across * pressed + y.coupling_across * pulled;
    const Float c = cos(angle), s = sin(angle);
    sums[0] += c * along - s * across;
    sums[1] += s * along + c * across;
    sums[2] += y.compliance * pressed;
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
