#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/inner_field.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

/// Levels of the double exponential rule; each halves the step. The last has some 6000 nodes, and five suffice where
/// the integrand is smooth.
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
  FloatShares shares;

  /// Adds pi/2 times the displacements due to a traction at |alpha - alpha'| = `gap`, times a weight.
  void add(const PressureAndShear& here, const Float& gap, Side side, const Float& weight,
           Displacements& sum) const {
    const Float u = side == left_of_point ? gap : -gap;
    const Float square = u * u + distance * distance, part = shares.theta1 * distance / square;
    const Float logarithm = log(square) / 2, angle = shares.theta2 * atan2(u, distance), half = weight / 2;
    sum[across] +=
        face * half * (here.pressure * (logarithm - part * distance) - here.shear * (angle + part * u));
    sum[along] += half * (here.pressure * (part * u - angle) - here.shear * (logarithm + part * distance));
  }
  /// Adds pi/2 times the stresses due to such a traction, times a weight.
  void add(const PressureAndShear& here, const Float& gap, Side side, const Float& weight,
           Stresses& sum) const {
    const Float u = side == left_of_point ? gap : -gap;
    const Float square = u * u + distance * distance;
    const Float part = (distance * here.pressure + u * here.shear) * weight / (square * square);
    const Float share = part * distance;
    sum[across] -= share * distance;
    sum[along] -= part * u * u;
    sum[shear] += face * (share * u);
  }
};

const std::vector<UnitPoint>& InnerField::level(int number) const {
  while (std::ssize(levels_) <= number) {
    const auto made = static_cast<int>(levels_.size());
    std::vector<UnitPoint>& nodes = levels_.emplace_back();
    const double step = std::ldexp(1 / fineness_.fineness, -made);
    // This suffices for a point at the contact's end on a face, where the integrand is singular like 1/sqrt.
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

/// Adds the integral over start <= |alpha - alpha'| <= end of the tractions on both sides of the point, or on the one
/// side on which the contact reaches so far. Levels are added until the integral has converged.
template <class Parts>
void InnerField::add_segment(const Float& start, const Float& end, const FacePoint& point, Parts& sum) const {
  // Displacements are smaller than tractions under a short contact.
  const Float scale = are_stresses<Parts> ? Float(1) : std::min(Float(1), source_.half_length);
  const Float enough = scale * fineness_.scale * pow(Float(10), -fineness_.digits), length = end - start;
  Parts total, before;
  for (int number = 0; number < most_levels; ++number) {
    for (const UnitPoint& node : level(number)) {
      const Float from_start = length * node.from_left, to_end = length * node.from_right,
                  weight = node.slope * length;
      for (const Side side : {left_of_point, right_of_point}) {
        const bool is_left = side == left_of_point;
        const Float &here = is_left ? point.from_left : point.from_right,
                    &there = is_left ? point.from_right : point.from_left;
        if (here < end) continue;
        const Float near = here - end + to_end, far = there + start + from_start;
        point.add(is_left ? source_.tractions(near, far) : source_.tractions(far, near), start + from_start,
                  side, weight, total);
      }
    }
    const Float factor = std::ldexp(2 / fineness_.fineness, -number) / pi();
    Float change = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const Float now = factor * total[i];
      change = std::max(change, Float(abs(now - before[i])));
      before[i] = now;
    }
    if (number >= first_judged_level && change <= enough) break;
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += before[i];
}

template <class Parts>
void InnerField::add_half_plane(const SheetPoint& at, int face, const FloatShares& shares, Parts& sum) const {
  const Float from_middle = at.alpha - source_.middle;
  const FacePoint point{source_.half_length + from_middle, source_.half_length - from_middle,
                        1 - face * at.depth, face, shares};
  const Float near = std::min(point.from_left, point.from_right),
              far = std::max(point.from_left, point.from_right);
  if (near > 0) {
    add_segment(0, near, point, sum);
    if constexpr (are_stresses<Parts>) {
      if (point.distance == 0) {
        const PressureAndShear here = source_.tractions(point.from_left, point.from_right);
        sum[across] -= here.pressure;
        sum[along] -= here.pressure;
        sum[shear] += face * here.shear;
      }
    }
  }
  if (far > near) add_segment(abs(near), far, point, sum);
}

/// The weighted tractions at the nodes of the double exponential rule over the contact. With t = tanh((pi/2) sinh x)
/// and |Im x| < 1/2, |Im t| < 0.94. In this strip e^{i z A t} is at most e^{0.94 z A}, in part compensated by e^{-2z}.
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
    const PressureAndShear here = source_.tractions(length * at.from_left, length * at.from_right);
    charges_.push_back({source_.half_length * (at.from_left - at.from_right),
                        {weight * here.pressure, weight * here.shear}});
  }
  return charges_;
}

/// Gauss rules on panels of length 2, up to a z beyond which z^2 e^-2z is negligible. The poles of 1/D at 1.125 +-
/// 2.106 i are on the ellipse whose semi-axes have the sum 4.44, so that n nodes have an error of e^(-2.98 n). On this
/// ellipse, whose height is 2.11, waves of a frequency f are as large as e^(2.11 f), which takes 0.7 f further nodes.
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

/// With a = 2 sinh z/D and b = 2 cosh z/D the symbol is [under_pressure a + by_z z b] C + by_sz s z a E under the
/// pressure and [under_shear b + by_z z a] C + by_sz s z b E under the shear. C is cosh sz, or sinh sz if it is odd in
/// the depth, and E is the other. From each product of a or b with C or E the part of both half-planes is subtracted:
/// 2 e^-z C or 2 e^-z E. The pressure is multiplied by sin or cos of z (alpha - alpha'), the shear then by -cos or sin.
struct InnerField::Form {
  bool sine = false, odd_in_depth = false;
  Float under_pressure = 0, under_shear = 0, by_z = 0, by_sz = 0;
};

template <class Parts>
void InnerField::add_sheet_rest(const SheetPoint& point, const FormsOf<Parts>& forms, Parts& sum) const {
  const auto& [alpha, s] = point;
  for (const Wave& wave : waves(alpha)) {
    const Float &z = wave.z, growth = exp(s * z), inverse = 1 / growth;
    const Float near = wave.fall * growth, far = wave.fall * inverse;
    const std::array<Float, 2> depth{(growth + inverse) / 2, (growth - inverse) / 2},
        planes{near + far, near - far};
    std::array<Float, 2> a, b;  // for an even and for an odd function of the depth
    for (std::size_t i = 0; i < 2; ++i) {
      a[i] = wave.sinh_part * depth[i] - planes[i];
      b[i] = wave.cosh_part * depth[i] - planes[i];
    }
    const SineAndCosine at(z * (alpha - source_.middle));
    const PressureAndShear &c = wave.cosine, &i = wave.sine;
    for (std::size_t part = 0; part < sum.size(); ++part) {
      const Form& form = forms[part];
      const std::size_t C = form.odd_in_depth ? 1 : 0, E = 1 - C;
      const Float by_z = form.by_z * z, by_sz = form.by_sz * s * z,
                  pressed = form.under_pressure * a[C] + by_z * b[C] + by_sz * a[E],
                  sheared = form.under_shear * b[C] + by_z * a[C] + by_sz * b[E];
      const Float waved = form.sine ? pressed * (at.sine * c.pressure - at.cosine * i.pressure) -
                                          sheared * (at.cosine * c.shear + at.sine * i.shear)
                                    : pressed * (at.cosine * c.pressure + at.sine * i.pressure) +
                                          sheared * (at.sine * c.shear - at.cosine * i.shear);
      sum[part] += (are_stresses<Parts> ? wave.weight : Float(wave.weight / z)) * waved;
    }
  }
}

template <class Parts>
Parts InnerField::sums(const SheetPoint& point, const FloatShares& shares,
                       const FormsOf<Parts>& forms) const {
  Parts sum;
  for (const int face : {1, -1}) add_half_plane(point, face, shares, sum);
  add_sheet_rest(point, forms, sum);
  return sum;
}

FloatStresses InnerField::at(const SheetPoint& point) const {
  const Stresses sum =
      sums<Stresses>(point, {},
                     {Form{.under_pressure = -1, .by_z = -1, .by_sz = 1},
                      Form{.under_pressure = -1, .under_shear = -2, .by_z = 1, .by_sz = -1},
                      Form{.sine = true, .odd_in_depth = true, .under_shear = -1, .by_z = 1, .by_sz = -1}});
  return {sum[across], sum[along], sum[shear]};
}

FloatDisplacements InnerField::displacements(const SheetPoint& point, const FloatShares& shares) const {
  const auto& [t1, t2] = shares;
  const Displacements sum = sums<Displacements>(
      point, shares,
      {Form{.odd_in_depth = true, .under_pressure = -1, .under_shear = -t2, .by_z = -t1, .by_sz = t1},
       Form{.sine = true, .under_pressure = -t2, .under_shear = -1, .by_z = t1, .by_sz = -t1}});
  return {sum[across], sum[along]};
}

namespace {

constexpr int rough_digits = 8;
/// Intervals of samples for the greatest shear across the sheet or 2.5 half-lengths, halved about high samples. Maxima
/// nearer to each other than half of one are not told apart.
constexpr int samples_of_reach = 10;
/// A maximum that is smooth over `reach` is at most 0.5 % above the nearest sample, reach/10 (2)^(-1/2) away, as
/// curvatures are at most 2 middle/reach^2 (Cauchy); between samples of this share there are samples at half the
/// distance. Maxima beside an end are sharper, so that the search begins at lower samples, too.
constexpr double high_share = 0.99;
/// Digits of the quadratures beyond those of the contact: the hundredth of the last digit that is added to errors is a
/// hundred times the error of a quadrature.
constexpr int guard = 4;

Float power_of_ten(int exponent) { return pow(Float(10), exponent); }

Float shear_of(const FloatStresses& s) { return hypot((s.across - s.along) / 2, s.shear); }

Float largest_difference(const FloatStresses& a, const FloatStresses& b) {
  return std::max({abs(a.across - b.across), abs(a.along - b.along), abs(a.shear - b.shear)});
}

/// `middles` times the middle plus `radii` times the radius of Mohr's circle.
Estimate of_circle(const InnerStresses& of, long middles, long radii) {
  const Interval across = interval_of(of.across), along = interval_of(of.along);
  const Interval radius = sqrt(square((across - along) / 2) + square(interval_of(of.shear)));
  Estimate result = enclosure_of(middles * (across + along) / 2 + radii * radius, of.across.digits);
  result.proven = of.across.proven && of.along.proven && of.shear.proven;
  return result;
}

}  // namespace

Estimate InnerStresses::maximum_shear() const { return of_circle(*this, 0, 1); }
Estimate InnerStresses::highest() const { return of_circle(*this, 1, 1); }
Estimate InnerStresses::lowest() const { return of_circle(*this, 1, -1); }

/// A point where the gradient is 0.
struct ContactField::Peak {
  SheetPoint point;
  Float point_error;
  Float shear_error;  ///< error of the largest shear if the point is only the best sample
};

ContactField::ContactField(const FieldSource& coarse, const FieldSource& fine, const Float& scale,
                           const Float& uncertainty, int digits)
    : coarse_(coarse, {digits + guard, 1, scale}),
      fine_(fine, {digits + guard, 1.3, scale}),
      rough_(fine, {rough_digits, 1, scale}),
      middle_(fine.middle),
      half_length_(fine.half_length),
      scale_(scale),
      uncertainty_(uncertainty),
      digits_(digits) {}

InnerStresses ContactField::at(const SheetPoint& point, bool symmetric, const Float& unit) const {
  const FloatStresses value = fine_.at(point);
  const Float error =
      2 * largest_difference(value, coarse_.at(point)) + scale_ * power_of_ten(-digits_ - 2) + uncertainty_;
  const auto estimated = [&](const Float& x) -> Estimate { return {unit * x, unit * error, digits_}; };
  const bool no_shear = point.depth == 0 || (symmetric && point.alpha == 0);
  return {estimated(value.across), estimated(value.along),
          no_shear ? Estimate(exact_zero(digits_)) : estimated(value.shear)};
}

InnerDisplacements ContactField::displacements_at(const SheetPoint& point, const FloatShares& share,
                                                  const Float& uncertain, const Float& unit) const {
  const FloatDisplacements value = fine_.displacements(point, share),
                           other = coarse_.displacements(point, share);
  const auto estimated = [&](const Float& x, const Float& y, bool is_zero) -> Estimate {
    if (is_zero) return exact_zero(digits_);
    return {unit * x, unit * (2 * abs(x - y) + uncertain), digits_};
  };
  const int inwards = point.depth < 0 ? 1 : -1;
  return {estimated(inwards * value.across, inwards * other.across, point.depth == 0),
          estimated(value.along, other.along, point.alpha == 0)};
}

/// The distance over which the field is smooth: that to the nearer end, at most the half length and the half-thickness.
Float ContactField::smooth_radius(const SheetPoint& point) const {
  const Float to_end = hypot(half_length_ - abs(point.alpha - middle_), 1 - point.depth);
  return std::min({Float(1), half_length_, to_end});
}

ContactField::Top ContactField::top_near(const SheetPoint& start, bool symmetric) const {
  Top best{start, shear_of(rough_.at(start))};
  const auto moved = [&](const Float& along, const Float& inwards) {
    const Float alpha = best.point.alpha + along, depth = std::min(Float(1), best.point.depth + inwards);
    const SheetPoint point{symmetric ? abs(alpha) : alpha, abs(depth)};
    Float shear = shear_of(rough_.at(point));
    if (!(shear > best.shear)) return false;
    best = {point, std::move(shear)};
    return true;
  };
  const Float reach = std::min(Float(1), half_length_);
  for (Float step = reach / (2 * samples_of_reach);
       step > std::max(smooth_radius(best.point), 1e-6 * reach) / 2000;) {
    if (!(moved(step, 0) || moved(-step, 0) || moved(0, step) || moved(0, -step))) step /= 2;
  }
  return best;
}

Float ContactField::largest_of(const Samples& samples) {
  return std::ranges::max_element(samples, {}, [](const auto& one) { return one.second.shear; })
      ->second.shear;
}

ContactField::Samples ContactField::samples(bool symmetric) const {
  constexpr int across = 2 * samples_of_reach;
  const int steps = across + 4 * static_cast<int>(static_cast<double>(half_length_)),
            first = symmetric ? 0 : -steps;
  const Float deepest = std::min(Float(1), 2.5 * half_length_);
  Samples all;
  const auto add = [&](int i, int j) {
    if (i < first || i > steps || j < 0 || j > across || all.contains({i, j})) return;
    const SheetPoint point{middle_ + half_length_ * sin(pi() * i / (2 * steps)), 1 - deepest * j / across};
    all.emplace(std::pair(i, j), Top{point, shear_of(rough_.at(point))});
  };
  for (int i = first; i <= steps; i += 2)
    for (int j = 0; j <= across; j += 2) add(i, j);
  const Float high = high_share * largest_of(all);
  for (const auto& [at, top] : std::map(all)) {
    if (top.shear < high) continue;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) add(at.first + i, at.second + j);
  }
  return all;
}

std::vector<SheetPoint> ContactField::tops(bool symmetric) const {
  const Samples all = samples(symmetric);
  const Float largest_sample = largest_of(all);
  const auto is_larger_beside = [&](const auto& at, const Float& shear) {
    const int apart = shear >= high_share * largest_sample ? 1 : 2;
    return std::ranges::any_of(all, [&](const auto& other) {
      return std::abs(other.first.first - at.first) <= apart &&
             std::abs(other.first.second - at.second) <= apart && other.second.shear > shear;
    });
  };
  std::vector<Top> tops;
  for (const auto& [at, sample] : all) {
    if (is_larger_beside(at, sample.shear)) continue;
    Top top = top_near(sample.point, symmetric);
    const auto is_near = [&](const Top& other) {
      return hypot(top.point.alpha - other.point.alpha, top.point.depth - other.point.depth) <
             smooth_radius(top.point) / 100;
    };
    if (std::ranges::none_of(tops, is_near)) tops.push_back(std::move(top));
  }
  const Float largest = std::ranges::max_element(tops, {}, &Top::shear)->shear;
  std::erase_if(tops, [&](const Top& top) { return top.shear < (1 - 1e-6) * largest; });
  std::vector<SheetPoint> points;
  for (const Top& top : tops) points.push_back(top.point);
  return points;
}

/// The gradient is computed by central differences of fourth order, with a step that balances their truncation error
/// and the field's error. On a face only the derivative along it is used.
ContactField::Peak ContactField::peak(const InnerField& field, const SheetPoint& near) const {
  const Float reach = smooth_radius(near);
  const bool on_face = near.depth == 1;
  const Float step = reach * pow(Float(10), -(digits_ + guard) / Float(5)) / 4;
  const auto value = [&](const SheetPoint& at) { return shear_of(field.at(at)); };
  SheetPoint at = near;
  // The largest shear, and how far the peak moves for a slope of 1.
  Float change = reach, middle = 0, yielding = 0;
  for (int round = 0; round < 12; ++round) {
    middle = value(at);
    const auto beside = [&](int i, int j) { return value({at.alpha + i * step, at.depth + j * step}); };
    struct Differences {
      Float slope, curvature;
    };
    const auto along = [&](int i, int j) -> Differences {
      const Float a = beside(i, j), b = beside(-i, -j);
      const Float first = a - b, second = beside(2 * i, 2 * j) - beside(-2 * i, -2 * j);
      return {(8 * first - second) / (12 * step), (a + b - 2 * middle) / (step * step)};
    };
    const Differences x = along(1, 0);
    Float to_x = -x.slope / x.curvature, to_y = 0;
    yielding = 1 / abs(x.curvature);
    if (!on_face) {
      const Differences y = along(0, 1);
      const Float mixed = (beside(1, 1) + beside(-1, -1) - beside(1, -1) - beside(-1, 1)) / (4 * step * step);
      const Float determinant = x.curvature * y.curvature - mixed * mixed;
      to_x = (mixed * y.slope - y.curvature * x.slope) / determinant;
      to_y = (mixed * x.slope - x.curvature * y.slope) / determinant;
      const Float straight = std::max(Float(abs(x.curvature)), Float(abs(y.curvature)));
      yielding = (straight + abs(mixed)) / abs(determinant);
    }
    const Float now = hypot(to_x, to_y);
    // The gradient has no zero near the best sample. The search ended where no point at h = reach/1000 had more shear.
    // With curvatures of at most 2 middle/reach^2 (Cauchy) the largest shear on the lines along and across the sheet is
    // then within h/2 and higher by at most 5e-7 middle. Both numbers are upper bounds of these.
    if (!(now < reach / 20) || (!on_face && at.depth + to_y > 1 - 3 * step))
      return {near, reach / 100, middle * 1e-6};
    at = {at.alpha + to_x, at.depth + to_y};
    if (!(now < change / 2) || now < reach * power_of_ten(-digits_)) break;
    change = now;
  }
  // Both fields have the same step, and so the same truncation error of the slope: step^4/30 times the fifth
  // derivative, which is at most 120 middle/reach^5 (Cauchy). 6.4 is an upper bound unless the peak is very flat.
  const Float flatness = std::max(Float(6.4), Float(middle * yielding / (reach * reach)));
  return {at, 4 * pow(Float(step / reach), 4) * flatness * reach, 0};
}

ContactField::Candidate ContactField::candidate(const SheetPoint& near, bool symmetric,
                                                const Float& unit) const {
  const Peak coarse = peak(coarse_, near);
  Peak fine = peak(fine_, near);
  // A maximum whose distance from a line of symmetry is less than its error is put on that line.
  if (symmetric && abs(fine.point.alpha) < fine.point_error) fine.point.alpha = 0;
  if (abs(fine.point.depth) < fine.point_error) fine.point.depth = 0;
  Estimate shear = at(fine.point, symmetric, unit).maximum_shear();
  shear.error = at_working_precision(shear.error) + unit * fine.shear_error;
  const auto error = [&](const Float& by_fine, const Float& by_coarse) -> Float {
    return 2 * abs(by_fine - by_coarse) + fine.point_error + power_of_ten(-digits_ - 2);
  };
  const Float of_alpha = error(fine.point.alpha, coarse.point.alpha),
              of_depth = error(fine.point.depth, coarse.point.depth);
  return {std::move(shear), fine.point, {of_alpha, of_depth}};
}

GreatestShear ContactField::greatest(bool symmetric, const Float& unit, const Float& length) const {
  std::vector<Candidate> all;
  for (const SheetPoint& near : tops(symmetric)) all.push_back(candidate(near, symmetric, unit));
  const Candidate& best =
      *std::ranges::max_element(all, {}, [](const Candidate& one) { return one.shear.value; });
  Estimate shear = best.shear;
  SheetPoint error = best.error;
  for (const Candidate& one : all) {
    const Float above = one.shear.value + one.shear.error - best.shear.value;
    if (above < -best.shear.error) continue;
    shear.error = std::max(shear.error, above);
    error.alpha = std::max(error.alpha, Float(abs(one.point.alpha - best.point.alpha) + one.error.alpha));
    error.depth = std::max(error.depth, Float(abs(one.point.depth - best.point.depth) + one.error.depth));
  }
  return {shear, Estimate{length * best.point.alpha, length * error.alpha, digits_},
          Estimate{best.point.depth, error.depth, digits_}};
}

SheetPoint checked_point(const InnerPoint& point, const Float& length) {
  if (!std::isfinite(point.y) || abs(point.y / length) > farthest_inside)
    throw data::BadInput("y", point.y,
                         "must be within 450 sheet thicknesses of the middle on the reference path");
  if (!(std::fabs(point.depth) <= 1))
    throw data::BadInput("depth", point.depth, "must satisfy -1 <= depth <= 1");
  return {point.y / length, point.depth};
}

}  // namespace nipref::ref
