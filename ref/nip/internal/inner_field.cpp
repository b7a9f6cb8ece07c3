#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/nip/internal/inner_field.hpp>

namespace nipref::ref {
namespace {

/// Halvings of the double exponential rule's step: the last has some 6000 nodes, five do where nothing is singular.
constexpr int first_judged_level = 3, most_levels = 10;

struct SineAndCosine {
  Float sine, cosine;

  explicit SineAndCosine(const Float& x) { mpfr_sin_cos(raw(sine), raw(cosine), raw(x), MPFR_RNDN); }
};

double nats_of(int digits) { return digits * std::numbers::ln10; }

/// The sign of u = alpha - alpha' for a traction on the left or the right of the point.
enum Side { left_of_point = 1, right_of_point = -1 };

}  // namespace

struct InnerField::FacePoint {
  Float from_left, from_right;  ///< distances from the contact's ends, negative outside
  Float distance;               ///< d >= 0
  int face;                     ///< x = 1 or -1
  bool is_inside;
  FloatShares shares;

  /// Adds half of pi times the displacements of a traction at |alpha - alpha'| = `gap`, times a weight.
  void add(const FaceTraction& here, const Float& gap, Side side, const Float& weight,
           Displacements& sum) const {
    const Float u = side == left_of_point ? gap : -gap;
    const Float square = u * u + distance * distance, part = shares.theta1 * distance / square;
    const Float logarithm = log(square) / 2, angle = shares.theta2 * atan2(u, distance), half = weight / 2;
    sum[0] += face * half * (here.pressure * (logarithm - part * distance) - here.shear * (angle + part * u));
    sum[1] += half * (here.pressure * (part * u - angle) - here.shear * (logarithm + part * distance));
  }
  /// Adds the stresses of a traction at |alpha - alpha'| = `gap`, times a weight.
  void add(const FaceTraction& here, const Float& gap, Side side, const Float& weight, Stresses& sum) const {
    const Float u = side == left_of_point ? gap : -gap;
    const Float square = u * u + distance * distance;
    const Float along = (distance * here.pressure + u * here.shear) * weight / (square * square);
    const Float share = along * distance;
    sum[0] -= share * distance;
    sum[1] -= along * u * u;
    sum[2] += face * (share * u);
  }
};

struct InnerField::Segment {
  Float start, length;
  bool left, right;                 ///< on which sides of the point there are tractions
  Float beyond_left, beyond_right;  ///< length of the contact beyond the segment on each side
};

const std::vector<UnitPoint>& InnerField::level(int number) const {
  while (std::ssize(levels_) <= number) {
    const auto made = static_cast<int>(levels_.size());
    std::vector<UnitPoint>& nodes = levels_.emplace_back();
    const double step = std::ldexp(1 / fineness_.fineness, -made);
    // Enough for a point at the contact's end on a face, where the integrand is singular like 1/sqrt.
    const double last = std::asinh(2 * (nats_of(fineness_.digits) + 4) / std::numbers::pi);
    const int stride = made == 0 ? 1 : 2;
    for (int i = made == 0 ? 0 : 1; i * step < last; i += stride) {
      const UnitPoint at(Float(step) * i);
      nodes.push_back(at);
      if (i == 0) continue;
      nodes.push_back(at);
      std::swap(nodes.back().from_left, nodes.back().from_right);
    }
  }
  return levels_[static_cast<std::size_t>(number)];
}

/// Adds the integral over a segment, with finer and finer levels until it has converged.
template <std::size_t Parts>
void InnerField::add_segment(const Segment& segment, const FacePoint& point,
                             std::array<Float, Parts>& sum) const {
  // Displacements are smaller than tractions under a short contact.
  const Float scale = Parts == 2 ? std::min(Float(1), source_.half_length) : Float(1);
  const Float enough = scale * fineness_.scale * pow(Float(10), -fineness_.digits);
  std::array<Float, Parts> total, before;
  for (int number = 0; number < most_levels; ++number) {
    for (const UnitPoint& node : level(number)) {
      const Float from_start = segment.length * node.from_left, to_end = segment.length * node.from_right;
      const Float gap = segment.start + from_start, weight = node.slope * segment.length;
      if (segment.left) {
        const Float from_end = segment.beyond_left + to_end;
        const Float other = point.is_inside ? point.from_right + gap : from_start;
        point.add(source_.tractions(from_end, other), gap, left_of_point, weight, total);
      }
      if (segment.right) {
        const Float from_end = segment.beyond_right + to_end;
        const Float other = point.is_inside ? point.from_left + gap : from_start;
        point.add(source_.tractions(other, from_end), gap, right_of_point, weight, total);
      }
    }
    const Float factor = std::ldexp(2 / fineness_.fineness, -number) / pi();
    Float change = 0;
    for (std::size_t i = 0; i < Parts; ++i) {
      const Float now = factor * total[i];
      change = std::max(change, Float(abs(now - before[i])));
      before[i] = now;
    }
    if (number >= first_judged_level && change <= enough) break;
  }
  for (std::size_t i = 0; i < Parts; ++i) sum[i] += before[i];
}

template <std::size_t Parts>
void InnerField::add_half_plane(const SheetPoint& at, int face, const FloatShares& shares,
                                std::array<Float, Parts>& sum) const {
  const Float from_middle = at.alpha - source_.middle;
  FacePoint point{source_.half_length + from_middle,
                  source_.half_length - from_middle,
                  1 - face * at.depth,
                  face,
                  false,
                  shares};
  const Float near = std::min(point.from_left, point.from_right),
              far = std::max(point.from_left, point.from_right);
  const bool more_right = point.from_right > point.from_left;
  point.is_inside = near >= 0;
  if (!point.is_inside) {
    add_segment({-near, far + near, !more_right, more_right, 0, 0}, point, sum);
    return;
  }
  if (near > 0) {
    add_segment({0, near, true, true, point.from_left - near, point.from_right - near}, point, sum);
    if (Parts == 3 && point.distance == 0) {
      const FaceTraction here = source_.tractions(point.from_left, point.from_right);
      sum[0] -= here.pressure;
      sum[1] -= here.pressure;
      sum.back() += face * here.shear;
    }
  }
  if (far > near) add_segment({near, far - near, !more_right, more_right, 0, 0}, point, sum);
}

/// The tractions at the nodes of the double exponential rule over the contact. With t = tanh((pi/2) sinh x) and |Im
/// x| < 1/2, |Im t| < 0.94. In this strip e^{i z A t} is at most e^{0.94 z A}, which the factor e^{-2z} compensates
/// in part.
const std::vector<InnerField::Charge>& InnerField::charges() const {
  if (!charges_.empty()) return charges_;
  const double nats = nats_of(fineness_.digits + 2), A = static_cast<double>(source_.half_length);
  const double growth = std::max(0.0, 0.94 * A - 2) * nats / 2;
  const double step = std::numbers::pi / ((nats + growth) * fineness_.fineness);
  const double last = std::asinh((nats + 8) / std::numbers::pi);
  const int half = static_cast<int>(std::ceil(last / step));
  for (int i = -half; i <= half; ++i) {
    const UnitPoint at(Float(step) * i);
    const Float length = 2 * source_.half_length, weight = length * at.slope * step;
    const FaceTraction here = source_.tractions(length * at.from_left, length * at.from_right);
    charges_.push_back({source_.half_length * (at.from_left - at.from_right),
                        {weight * here.pressure, weight * here.shear}});
  }
  return charges_;
}

/// Gauss rules on panels of length 2. Once it resolves the waves, each further node reduces the error by a factor of
/// 4.45, because of the poles of 1/D at 1.125 +- 2.106 i.
const std::vector<InnerField::Wave>& InnerField::waves(const Float& alpha) const {
  const double A = static_cast<double>(source_.half_length),
               off = std::fabs(static_cast<double>(alpha - source_.middle));
  const int doublings = std::max(0, static_cast<int>(std::ceil(std::log2(off / (A + 0.5)))));
  const auto found = waves_.find(doublings);
  if (found != waves_.end()) return found->second;
  const double nats = nats_of(fineness_.digits + 2);
  const double frequency = A + std::ldexp(A + 0.5, doublings);
  const int panels = static_cast<int>(std::ceil((nats + 12) / 4));
  const UnitRule rule =
      gauss_rule(4 + static_cast<int>(std::ceil(fineness_.fineness * (nats / 2.98 + 0.7 * frequency))));
  std::vector<Wave>& made = waves_[doublings];
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t i = 0; i < rule.size(); ++i) {
      Wave wave;
      wave.z = 2 * (panel + rule.from_left[i]);
      wave.weight = 2 * rule.weight[i] / pi();
      wave.fall = exp(-wave.z);
      const Float s = sinh(wave.z), c = cosh(wave.z), over = 1 / (s * c + wave.z);
      wave.sinh_part = s * over;
      wave.cosh_part = c * over;
      for (const Charge& charge : charges()) {
        const SineAndCosine at(wave.z * charge.from_middle);
        wave.cosine.pressure += at.cosine * charge.weighted.pressure;
        wave.sine.pressure += at.sine * charge.weighted.pressure;
        wave.cosine.shear += at.cosine * charge.weighted.shear;
        wave.sine.shear += at.sine * charge.weighted.shear;
      }
      made.push_back(std::move(wave));
    }
  }
  return made;
}

/// With a = 2 sinh z/D and b = 2 cosh z/D the rest is [first a + second z b] C + third s z a E under the pressure, and
/// [first b + second z a] C + third s z b E under the shear, where C is cosh sz, or sinh sz where it is odd in the depth, and E
/// the other, each product less what it is far from the middle plane, by both half-planes. The pressure has its sine or cosine
/// of z (alpha - alpha'), the shear its cosine, the sign changed, or sine.
struct InnerField::Form {
  bool sine, odd_in_depth;
  Float first_pressure, first_shear, second, third;
};

template <std::size_t Parts>
void InnerField::add_sheet_rest(const SheetPoint& point, const std::array<Form, Parts>& forms,
                                std::array<Float, Parts>& sum) const {
  const auto& [alpha, s] = point;
  for (const Wave& wave : waves(alpha)) {
    const Float &z = wave.z, growth = exp(s * z), inverse = 1 / growth;
    const Float near = wave.fall * growth, far = wave.fall * inverse;
    const std::array<Float, 2> depth{(growth + inverse) / 2, (growth - inverse) / 2},
        planes{near + far, near - far};
    std::array<Float, 2> a, b;  // of even and of odd functions of the depth
    for (std::size_t i = 0; i < 2; ++i) {
      a[i] = wave.sinh_part * depth[i] - planes[i];
      b[i] = wave.cosh_part * depth[i] - planes[i];
    }
    const SineAndCosine at(z * (alpha - source_.middle));
    const FaceTraction &c = wave.cosine, &i = wave.sine;
    for (std::size_t part = 0; part < Parts; ++part) {
      const auto& [sine, odd_in_depth, first_pressure, first_shear, second, third] = forms[part];
      const std::size_t C = odd_in_depth ? 1 : 0, E = 1 - C;
      const Float second_z = second * z, third_z = third * s * z,
                  pressed = first_pressure * a[C] + second_z * b[C] + third_z * a[E],
                  sheared = first_shear * b[C] + second_z * a[C] + third_z * b[E];
      const Float waved = sine ? pressed * (at.sine * c.pressure - at.cosine * i.pressure) -
                                     sheared * (at.cosine * c.shear + at.sine * i.shear)
                               : pressed * (at.cosine * c.pressure + at.sine * i.pressure) +
                                     sheared * (at.sine * c.shear - at.cosine * i.shear);
      sum[part] += (Parts == 3 ? wave.weight : Float(wave.weight / z)) * waved;
    }
  }
}

template <std::size_t Parts>
std::array<Float, Parts> InnerField::sums(const SheetPoint& point, const FloatShares& shares,
                                          const std::array<Form, Parts>& forms) const {
  std::array<Float, Parts> sum;
  for (const int face : {1, -1}) add_half_plane(point, face, shares, sum);
  add_sheet_rest(point, forms, sum);
  return sum;
}

FloatStresses InnerField::at(const SheetPoint& point) const {
  const auto [across, along, shear] = sums<3>(
      point, {}, {{{false, false, -1, 0, -1, 1}, {false, false, -1, -2, 1, -1}, {true, true, 0, -1, 1, -1}}});
  return {across, along, shear};
}

FloatDisplacements InnerField::displacements(const SheetPoint& point, const FloatShares& shares) const {
  const auto& [t1, t2] = shares;
  const auto [across, along] =
      sums<2>(point, shares, {{{false, true, -1, -t2, -t1, t1}, {true, false, -t2, -1, t1, -t1}}});
  return {across, along};
}

}  // namespace nipref::ref
