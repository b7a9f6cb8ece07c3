#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/elliptic_displacement.hpp>

namespace nipref::ref {
namespace {

/// A displacement: along the motion or along a line, across it, and into the half-space.
using Moved = std::array<Float, 3>;
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

/// The eigenvalues, which must not all be equal, by Cardano's formula.
ComplexVector eigenvalues(const ComplexRows& g) {
  const ComplexFloat third = (g[0][0] + g[1][1] + g[2][2]) / Float(3);
  ComplexRows h = g;  // its trace is 0: x^3 + 3 p x - 2 q = 0
  for (std::size_t i = 0; i < 3; ++i) h[i][i] = g[i][i] - third;
  const auto minor = [&](std::size_t i, std::size_t k) { return h[i][i] * h[k][k] - h[i][k] * h[k][i]; };
  const ComplexFloat p = (minor(0, 1) + minor(1, 2) + minor(0, 2)) / Float(3);
  const ComplexFloat q = (h[0][0] * minor(1, 2) - h[0][1] * (h[1][0] * h[2][2] - h[1][2] * h[2][0]) +
                          h[0][2] * (h[1][0] * h[2][1] - h[1][1] * h[2][0])) /
                         Float(2);
  const ComplexFloat root = exp(log(q * q + p * p * p) * Float(0.5));
  const ComplexFloat cube = abs(q + root) > abs(q - root) ? q + root : q - root;
  const ComplexFloat third_of_turn(Float(-0.5), sqrt(Float(3)) / 2);
  ComplexFloat one = exp(log(cube) / Float(3));
  ComplexVector result;
  for (ComplexFloat& value : result) {
    value = third + one - p / one;
    one = one * third_of_turn;
  }
  return result;
}

/// int_-1^1 (1 - s^2)/(s - z) ds for Im z > 0, and its limit where z is real.
ComplexFloat parabola_over(const ComplexFloat& z) {
  const ComplexFloat one(Float(1)), rest = one - z * z;
  if (abs(rest) == Float(0)) return z * Float(-2);
  if (abs(z) < Float(100)) return rest * log((z - one) / (z + one)) - z * Float(2);
  // A series in powers of 1/z, because the terms above lose 4 digits and more to cancellation here.
  ComplexFloat sum, power = one / z;
  const ComplexFloat factor = power * power;
  for (long k = 1; k == 1 || abs(power) > std::numeric_limits<Float>::epsilon() * abs(sum);
       k += 2, power = power * factor)
    sum = sum - power * Float(4) / Float(k * (k + 2));
  return sum;
}

/// A part of Y e3 that decays with the depth like e^(-exponent kappa depth). Y e3 is the sum of its parts.
struct FallingPart {
  ComplexFloat exponent;
  ComplexVector pushed;
};

/// The parts of Y e3, by Lagrange's interpolation between the eigenvalues of G. G is changed by about its error, so
/// that its eigenvalues differ by at least 10^-digits. The interpolation divides by two such differences; because of
/// the cancellation it is computed with four times the digits.
std::vector<FallingPart> parts_of(const SmoothLines::Line& line) {
  const ComplexVector at_surface{line[0], line[1], line[2]};
  if (line.size() == at_surface.size()) return {{{}, at_surface}};
  const int digits = static_cast<int>(Float::thread_default_precision());
  const WorkingDigits scope(4 * digits);
  ComplexRows g;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) g[i][k] = line[3 * (i + 1) + k];
    g[i][i] = g[i][i] * (1 + static_cast<long>(i * i + 1) * tolerance(digits));
  }
  const ComplexVector values = eigenvalues(g);
  std::vector<FallingPart> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    const ComplexFloat &own = values[i], &second = values[(i + 1) % 3], &third = values[(i + 2) % 3];
    ComplexVector pushed = product(g, product(g, at_surface, second), third);
    for (ComplexFloat& each : pushed) each = each / ((own - second) * (own - third));
    parts.push_back({own, pushed});
  }
  // From here on, only cancellation between the parts loses digits.
  const auto size = [](const ComplexVector& x) { return std::max({abs(x[0]), abs(x[1]), abs(x[2])}); };
  Float largest = size(at_surface);
  for (const FallingPart& part : parts) largest = std::max(largest, size(part.pushed));
  const Float cancelled = log10(Float(largest / size(at_surface)));
  const WorkingDigits enough(digits + 1 + static_cast<int>(cancelled));
  for (FallingPart& part : parts) {
    for (ComplexFloat* each : {&part.exponent, &part.pushed[0], &part.pushed[1], &part.pushed[2]})
      *each = {at_working_precision(each->re), at_working_precision(each->im)};
  }
  return parts;
}

/// Im(P(t + i G depth)/pi Y e3), P = parabola_over.
Moved moved_by(const std::vector<FallingPart>& parts, const Float& t, const Float& depth) {
  const WorkingDigits scope(digits_of(bits_of(parts[0].pushed[0].re)));
  Moved result;
  for (const auto& [exponent, pushed] : parts) {
    const ComplexFloat factor = parabola_over({t - depth * exponent.im, depth * exponent.re}) / pi();
    for (std::size_t k = 0; k < 3; ++k) result[k] += (factor * pushed[k]).im;
  }
  return result;
}

/// A stretch of v, the integral over it, and the change of the integral by the last halving of the rule's step.
struct Stretch {
  Float left, right;
  Moved integral{}, change{};
  bool is_settled = false;
};

Float largest_of(const Moved& x) { return std::max({Float(abs(x[0])), Float(abs(x[1])), Float(abs(x[2]))}); }

void add(Moved& sum, const Moved& term, const Float& factor) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * term[k];
}

/// The stretches of v. They end at the line across the direction of the place, where t = 0, at the line along the minor
/// axis, at the peak of the compliance, and where |t| = 1 or, for a place inside the ellipse, where |t| is largest.
std::vector<Stretch> stretches_of(const SmoothLines& lines, const EllipticPressure& on,
                                  const PlaceInside& place) {
  const auto& [psi, x, depth] = place;
  const Float right = pi() / 2;
  // The coordinates of the place in units of a and b, in which the ellipse is the unit circle.
  const Float first = x * cos(Float(psi - on.major)) / on.a, second = x * sin(Float(psi - on.major)) / on.b;
  const Float angle = atan2(second, first), distance = hypot(first, second);
  const Float off = distance > Float(1) ? acos(Float(1 / distance)) : Float(0);
  const auto touching = [&](const Float& at) {
    return lines.v(on.major + atan2(Float(sin(at) / on.b), Float(cos(at) / on.a)));
  };
  std::vector<Float> ends{
      -lines.last(),         lines.last(),         0, lines.v(psi + right), lines.v(on.major + right),
      touching(angle - off), touching(angle + off)};
  std::ranges::sort(ends);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i + 1] - ends[i] > std::numeric_limits<Float>::epsilon())
      stretches.push_back({ends[i], ends[i + 1]});
  return stretches;
}

/// The integrand in v: the displacement by one line under a pressure.
Moved moved_by_line(const SmoothLines& lines, const Float& v, const std::vector<FallingPart>& parts,
                    const EllipticPressure& on, const PlaceInside& place) {
  const auto& [psi, x, depth] = place;
  const Float angle = lines.angle(v), c = cos(angle), s = sin(angle);
  const Float width =
      hypot(Float(on.a * cos(Float(angle - on.major))), Float(on.b * sin(Float(angle - on.major))));
  const Float share = lines.slope(v) * on.peak * on.a * on.b / (4 * width);
  const auto [along, across, into] = moved_by(parts, x * cos(Float(angle - psi)) / width, depth / width);
  return {share * (c * along - s * across), share * (s * along + c * across), share * into};
}

Float size_of(std::span<const ComplexFloat> numbers) {
  Float largest;
  for (const ComplexFloat& each : numbers) largest = std::max(largest, abs(each));
  return largest;
}

bool agree(const SmoothLines::Line& found, const SmoothLines::Line& truth, int digits) {
  SmoothLines::Line off;
  for (std::size_t i = 0; i < truth.size(); ++i) off.push_back(found[i] - truth[i]);
  const auto is_small = [&](auto part) {
    return size_of(part(std::span(off))) <= tolerance(digits) * size_of(part(std::span(truth)));
  };
  return is_small([](auto all) { return all.first(3); }) && is_small([](auto all) { return all.subspan(3); });
}

}  // namespace

SmoothLines::SmoothLines(const WorkingSurface& surface, const PeakOfCompliance& peak, bool with_decay,
                         int digits)
    : centre_(peak.degrees * pi() / 180), width_(peak.width), last_(asinh(Float(pi() / 2 / width_))) {
  const auto line = [&](const Float& v) {
    const Exact off = to_exact(Float(width_ * sinh(v) * 180 / pi()));
    const LineAnswer y = surface.at(Exact(mpq_class(Exact(peak.degrees).value() + off.value())));
    Line found{
        {y.shear_compliance, y.coupling}, {y.shear_compliance_across, y.coupling_across}, y.compliance};
    if (!with_decay) return found;
    const Decay& decay = y.decay.value();
    for (std::size_t k = 0; k < 9; ++k) found.emplace_back(decay.re[k], decay.im[k]);
    return found;
  };
  const auto panels = static_cast<long>(ceil(Float(2 * last_)));
  for (long i = 0; i < panels; ++i)
    add_panels((Float(2 * i) / panels - 1) * last_, (Float(2 * i + 2) / panels - 1) * last_, digits, line);
}

template <class Of>
void SmoothLines::add_panels(const Float& left, const Float& right, int digits, const Of& line) {
  // On a panel of length 1 the polynomial converges like (pi + sqrt(pi^2 + 1))^-count = 10^(-0.81 count). It is
  // compared with the line in the middle of every fifth gap between its nodes, the first and the last gap included.
  constexpr int gaps = 5;
  const int count = gaps * static_cast<int>((digits + 4) / (0.75 * gaps)) + 1;
  const Float middle = (left + right) / 2, half = (right - left) / 2;
  if (half < Float(1e-4))
    throw data::BadInput("surface", "(as given)", "must be smooth from line to line, to all its digits");
  const auto place = [&](int twice) -> Float { return middle - half * cos(pi() * twice / (2 * count)); };
  Panel panel{right, {}, {}};
  for (int k = 0; k <= count; ++k) {
    panel.places.push_back(place(2 * k));
    panel.lines.push_back(line(panel.places.back()));
  }
  for (int k = 0; k < count; k += gaps) {
    const Float between = place(2 * k + 1);
    if (agree(panel.at(between), line(between), digits)) continue;
    add_panels(left, middle, digits, line);
    return add_panels(middle, right, digits, line);
  }
  panels_.push_back(std::move(panel));
}

/// The barycentric formula. Its weights at Chebyshev points are 1, at the ends 1/2, with alternating signs.
SmoothLines::Line SmoothLines::Panel::at(const Float& v) const {
  Line sum(lines[0].size());
  Float total, scratch;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Float off = v - places[k];
    if (off == Float(0)) return lines[k];
    const bool is_end = k == 0 || k + 1 == places.size();
    const Float weight = (k % 2 == 0 ? 1 : -1) / (is_end ? Float(2 * off) : off);
    total += weight;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      add_product(sum[i].re, scratch, weight, lines[k][i].re);
      add_product(sum[i].im, scratch, weight, lines[k][i].im);
    }
  }
  for (ComplexFloat& each : sum) each = each / total;
  return sum;
}

Float SmoothLines::v(const Float& angle) const {
  const Float off = angle - centre_;
  return asinh(Float((off - pi() * round(Float(off / pi()))) / width_));
}

SmoothLines::Line SmoothLines::at(const Float& v) const {
  const auto panel = std::ranges::find_if(panels_, [&](const Panel& each) { return v <= each.right; });
  return (panel == panels_.end() ? panels_.back() : *panel).at(v);
}

Displaced displacement_under(const std::array<EllipticPressure, 2>& pressures, const SmoothLines& lines,
                             const PlaceInside& place, const std::vector<UnitPoint>& nodes, int digits) {
  Moved between_pressures;  // the difference between the displacements on the first level
  // The steps of the rule are 32, 16, ... 1 times the step of `nodes`. The nodes that are left out, next to the ends of
  // the at most 6 stretches, contribute less than the rounding error, 10^-(digits + 6).
  constexpr std::size_t widest = 32;
  const auto halve_step = [&](Stretch& on, std::size_t step) {
    const bool is_first = step == widest;
    const Float length = on.right - on.left;
    Moved added;
    for (std::size_t i = is_first ? 0 : step; i < nodes.size(); i += is_first ? step : 2 * step) {
      const auto& [left, right, weight] = nodes[i];
      if (weight < tolerance(digits + 8)) continue;
      const Float v = left < right ? on.left + length * left : on.right - length * right;
      const Float dv = length * weight * step;
      const std::vector<FallingPart> parts = parts_of(lines.at(v));
      const Moved moved = moved_by_line(lines, v, parts, pressures[0], place);
      add(added, moved, dv);
      if (!is_first) continue;
      add(between_pressures, moved, dv);
      add(between_pressures, moved_by_line(lines, v, parts, pressures[1], place), -dv);
    }
    for (std::size_t k = 0; k < added.size(); ++k) {
      const Float finer = on.integral[k] / 2 + added[k];
      on.change[k] = abs(finer - on.integral[k]);
      on.integral[k] = finer;
    }
  };
  std::vector<Stretch> stretches = stretches_of(lines, pressures[0], place);
  for (std::size_t step = widest; step > 0; step /= 2) {
    Float all;
    for (Stretch& each : stretches) {
      if (!each.is_settled) halve_step(each, step);
      all += largest_of(each.integral);
    }
    for (Stretch& each : stretches)
      each.is_settled = step < widest && largest_of(each.change) <= tolerance(digits + 2) * all;
  }
  Displaced result{};
  for (std::size_t k = 0; k < result.error.size(); ++k) result.error[k] = abs(between_pressures[k]);
  for (const Stretch& each : stretches) {
    add(result.value, each.integral, 1);
    add(result.error, each.change, 1);
  }
  return result;
}

}  // namespace nipref::ref
