#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

/// The A sinh(tau) for which C e^{-2n tau} is smallest, or nearly so.
double strip_height(double half_length, int size) { return std::max(1.0, 2 - half_length / size); }

}  // namespace

Interval coercivity(const Interval& half_length, const Stiffness& stiffness) {
  constexpr long steps = 16;
  Interval best(half_length.precision());
  for (long k = 1; k < steps; ++k) {
    const Interval z = Interval(2 * k, half_length.precision()) / steps;
    const Interval value = stiffness(z / half_length) * (1 - square(z) / 4);
    if (mpfr_greater_p(value.lower(), best.lower()) != 0) best = value;
  }
  return best;
}

Interval frictionless_stiffness(const Interval& x) {
  const Interval twice = 2 * x;
  return (cosh(twice) - 1) / (sinh(twice) + twice);
}

/// The least eigenvalue is at least the determinant over the trace: (1 - beta)(r + beta) times S/(2 cosh 2x). Here
/// r = (sinh 2x - 2x)/S rises, and S/(2 cosh 2x) rises and then falls to 1/2.
Interval gripped_stiffness(const Interval& x, const Interval& beta) {
  const Interval twice = 2 * x, S = sinh(twice) + twice;
  const Interval over_trace = S / (2 * cosh(twice));
  const Interval least = mpfr_cmp_d(over_trace.lower(), 0.5) < 0 ? over_trace : Interval(0.5, x.precision());
  return (1 - beta) * ((sinh(twice) - twice) / S + beta) * least;
}

EntryBounds entry_bounds(const Interval& half_length, int size) {
  const Interval bound = interval_of(upper_end(half_length));
  const Interval height(strip_height(mpfr_get_d(bound.upper(), MPFR_RNDU), size), half_length.precision());
  const Interval slope = height / bound;
  const Interval cosh_tau = sqrt(square(slope) + 1), left = 2 - height;
  return {2 * (bound * cosh_tau * (2 / left + 4 / square(left))), log(slope + cosh_tau)};
}

Interval folded_entries(const EntryBounds& decay, long points, long first) {
  return 8 * (decay.amplitude * decay.power(first)) / square(1 - decay.power(points));
}

Interval tail(const Interval& rate, long first) {
  const Interval gap = -expm1(-(2 * rate));
  return exp(-(first * rate)) * (first / gap + 2 / square(gap));
}

/// With m = first + j: (1 - q) sum q^j = 1, (1 - q)^2 sum j q^j = q, (1 - q)^3 sum j^2 q^j = q (1 + q).
Interval square_tail(const Interval& rate, long first) {
  const Interval gap = -expm1(-rate), q = 1 - gap;
  return exp(-(first * rate)) *
         (first * first / gap + 2 * first * q / square(gap) + q * (q + 1) / (square(gap) * gap));
}

int size_for(double half_length, int digits) {
  const Interval A(half_length, 64), wanted = exp(-(digits * log(Interval(10L, 64))));
  for (int n = 3;; n += 1 + n / 64) {
    // lambda is about 1/(1 + 3 A), the sum of the unknowns about 1 + A.
    const Interval left = n * ((3 * A + 1) * (A + 1)) * sqrt(Interval(long{n}, 64)) *
                          folded_entries(entry_bounds(A, n), 2L * n, 2L * n);
    if (sign_of(wanted - left) > 0) return n;
  }
}

namespace {

bool is_inside(const SurfacePoint& place) { return mpfr_sgn(place.before_end.lower()) >= 0; }
bool is_outside(const SurfacePoint& place) { return mpfr_sgn(place.before_end.upper()) < 0; }

/// x without its part below 0.
Interval not_below_zero(const Interval& x) {
  Interval result = x;
  if (mpfr_sgn(result.lower()) < 0) mpfr_set_zero(&result.get()->left, 1);
  return result;
}
Interval not_above_zero(const Interval& x) { return -not_below_zero(-x); }

/// `inside` or `outside`, or the hull of both if the place may be either.
template <class Inside, class Outside>
Interval by_side(const SurfacePoint& place, const Inside& inside, const Outside& outside) {
  if (is_inside(place)) return inside(place);
  if (is_outside(place)) return outside(place);
  return hull(inside({not_below_zero(place.before_end), place.is_trailing}),
              outside({not_above_zero(place.before_end), place.is_trailing}));
}

Interval position(const SurfacePoint& place) { return 1 - place.before_end; }

/// acos t.
Interval angle(const SurfacePoint& place) {
  return 2 * atan(sqrt(place.before_end / (2 - place.before_end)));
}

/// t - sqrt(t^2 - 1), t >= 1: e^{-eta} where t = cosh(eta).
Interval image_ratio(const SurfacePoint& place) {
  const Interval t = position(place);
  return 1 / (t + sqrt(-place.before_end * (2 - place.before_end)));
}

/// Encloses I3 on an interval, as |I3'| <= int 2x/S dx <= 2.
Interval I3_over(const Interval& alpha, double nats) {
  const Float near = middle_of(alpha);
  const Interval value = near == 0 ? Interval(working_bits()) : I3_interval(to_exact(near), nats);
  return value.widened(2 * distance_from(near, alpha));
}

}  // namespace

ProvenContact::ProvenContact(ProvenExpansion expansion, const Exact& beta,
                             std::shared_ptr<SmoothKernel> kernel, double nats)
    : expansion_(std::move(expansion)),
      offset_(working_bits()),
      beta_(beta, working_bits()),
      kernel_(std::move(kernel)),
      nats_(nats) {
  const Cosines cosines(2 * size(), working_bits());
  for (long j = 0; j < size(); ++j) {
    const auto sine = [&](long mu) -> const Interval& { return cosines(2 * size() - mu * (2 * j + 1)); };
    Interval pressure(working_bits()), slope(working_bits());
    for (long m = 0; m < size(); ++m) {
      const long mu = 2 * m + 1;
      pressure = pressure + odd(m) * sine(mu);
      slope = slope + mu * (odd(m) * cosines(mu * (2 * j + 1)));
    }
    nodes_.push_back(cosines(2 * j + 1));
    node_pressures_.push_back(pressure * sine(1));
    node_slopes_.push_back(slope);
  }
}

ProvenContact::ProvenContact(ProvenExpansion expansion, Interval offset, Interval edge_displacement)
    : expansion_(std::move(expansion)),
      offset_(std::move(offset)),
      edge_displacement_(std::move(edge_displacement)) {}

const Interval& ProvenContact::odd(long m) const {
  return expansion_.coefficients[static_cast<std::size_t>(2 * m + 1)];
}

Interval ProvenContact::first() const { return odd(0).widened(expansion_.energy_radius); }

Interval ProvenContact::load() const {
  return Interval::pi(working_bits()) * square(half_length()) * first();
}

Interval ProvenContact::lever() const {
  if (!remembers()) return offset_;
  const Interval second = expansion_.coefficients[2].widened(expansion_.energy_radius);
  return offset_ + half_length() * second / (2 * first());
}

Interval ProvenContact::pressure(const SurfacePoint& place) const {
  return by_side(
      place, [&](const SurfacePoint& p) { return pressure_between(p); },
      [&](const SurfacePoint&) { return Interval(working_bits()); });
}

/// |dp|/(2A) <= sum |dc_m sin(m theta)| <= sin(theta) radius. From the trailing end terms of even m change their sign.
Interval ProvenContact::pressure_between(const SurfacePoint& place) const {
  const Interval theta = angle(place);
  const auto& c = expansion_.coefficients;
  const std::size_t step = remembers() ? 1 : 2;
  Interval sum(working_bits());
  for (std::size_t m = 1; m < c.size(); m += step) {
    const Interval term = c[m] * sin(static_cast<long>(m) * theta);
    sum = m % 2 == 0 && place.is_trailing ? sum - term : sum + term;
  }
  const Interval sine = sqrt(place.before_end * (2 - place.before_end));
  return 2 * (half_length() * sum.widened(sine * expansion_.radius));
}

/// The error of p(s)/(2A) is at most radius sqrt(1 - s^2), whose integral is pi/2 times radius.
template <class Kernel>
Interval ProvenContact::smooth_integral(const SurfacePoint& place, const Kernel& kernel,
                                        const Interval& largest) const {
  const Interval t = position(place);
  Interval sum(working_bits());
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const Interval both = kernel(half_length() * (t - nodes_[j])) + kernel(half_length() * (t + nodes_[j]));
    sum = sum + both * node_pressures_[j];
  }
  const Interval pi = Interval::pi(working_bits());
  return (pi * sum / (2 * size()))
      .widened(expansion_.quadrature_error + pi * magnitude_of(largest) * expansion_.radius / 2);
}

/// Returns u pi/(2 A^2). -ln|t - s| acts on sin(mu theta) in closed form: by cosines inside, by powers outside. The
/// errors of the coefficients are multiplied by at most int |ln|t - s|| ds <= 3 + 2t and by |J| <= 1 + 2|alpha|.
Interval ProvenContact::normal_by_pressure(const SurfacePoint& place) const {
  const mpfr_prec_t precision = working_bits();
  const Interval& A = half_length();
  const Interval t = position(place);
  const Interval two(2L, precision);
  const bool inside = is_inside(place);
  const Interval ratio = inside ? Interval(precision) : image_ratio(place);
  const Interval theta = inside ? angle(place) : Interval(precision);
  const Interval log_ratio = inside ? Interval(precision) : log(ratio);
  const auto wave = [&](long k) { return inside ? cos(k * theta) : exp(k * log_ratio); };
  Interval lower = log(two) + log_ratio;
  Interval sum(precision);
  for (long m = 0; m < size(); ++m) {
    const Interval upper = wave(2 * m + 2) / (2 * m + 2);
    sum = sum + odd(m) * (lower - upper);
    lower = upper;
  }
  const Interval pi = Interval::pi(precision);
  sum = pi * (sum - log(A) * odd(0)) / 2;
  const Interval missed = (2 * magnitude_of(log(A)) + magnitude_of(2 * t + 3)) * expansion_.radius;
  const Interval smooth = smooth_integral(
      place, [&](const Interval& alpha) { return kernel_->over(alpha); }, 2 * (A * (t + 1)) + 1);
  return sum.widened(missed) + smooth;
}

/// Returns v pi/(2 A^2).
Interval ProvenContact::tangential_by_pressure(const SurfacePoint& place) const {
  const mpfr_prec_t precision = working_bits();
  const Interval pi = Interval::pi(precision);
  const bool inside = is_inside(place);
  // int_0^t p(s)/(2A) ds, by sin(mu theta) sin(theta) = [cos(2m theta) - cos((2m + 2) theta)]/2.
  Interval between = pi * odd(0) / 4;
  if (inside) {
    const Interval theta = angle(place);
    Interval lower = pi / 2 - theta;
    between = Interval(precision);
    for (long m = 0; m < size(); ++m) {
      const Interval upper = -(sin((2 * m + 2) * theta) / (2 * m + 2));
      between = between + odd(m) * (lower - upper) / 2;
      lower = upper;
    }
  }
  between = between.widened(pi * expansion_.radius / 4);
  coupling_values_ += 2 * size();
  const Interval smooth = smooth_integral(
      place, [&](const Interval& alpha) { return I3_over(alpha, nats_); },
      2 * (half_length() * (position(place) + 1)));
  return smooth - pi * beta_ * between;
}

Interval ProvenContact::edge_displacement() const {
  if (!edge_displacement_) {
    const Interval scale = 2 * square(half_length()) / Interval::pi(working_bits());
    const SurfacePoint middle{Interval(1L, working_bits())};
    edge_displacement_ = scale * normal_by_pressure(middle) - square(half_length());
  }
  return *edge_displacement_;
}

bool ProvenContact::reaches(const SurfacePoint& place) const {
  constexpr long farthest_of_kernels = 1000;
  return !remembers() && upper_end(half_length() * (position(place) + 1)) <= farthest_of_kernels;
}

std::optional<Interval> ProvenContact::normal(const SurfacePoint& place) const {
  if (!is_inside(place) && !reaches(place)) return std::nullopt;
  const Interval scale = 2 * square(half_length()) / Interval::pi(working_bits());
  const auto on_roller = [&](const SurfacePoint& p) {
    const Interval y = half_length() * position(p), leading = half_length() + offset_;
    return edge_displacement() + square(leading) - square(p.is_trailing ? offset_ - y : offset_ + y);
  };
  return by_side(place, on_roller, [&](const SurfacePoint& p) { return scale * normal_by_pressure(p); });
}

std::optional<Interval> ProvenContact::tangential(const SurfacePoint& place) const {
  if (!reaches(place)) return std::nullopt;
  const Interval scale = 2 * square(half_length()) / Interval::pi(working_bits());
  const auto displacement = [&](const SurfacePoint& p) { return scale * tangential_by_pressure(p); };
  const Interval away = by_side(place, displacement, displacement);
  return place.is_trailing ? -away : away;
}

std::optional<Interval> ProvenContact::strain(const SurfacePoint& place) const {
  if (!reaches(place)) return std::nullopt;
  const Interval t = position(place), pi = Interval::pi(working_bits());
  Interval sum(working_bits());
  // P is even: its slopes are opposite at opposite nodes.
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const Interval both =
        I3_over(half_length() * (t - nodes_[j]), nats_) - I3_over(half_length() * (t + nodes_[j]), nats_);
    sum = sum + both * node_slopes_[j];
  }
  coupling_values_ += 2 * size();
  const Interval by_parts =
      (-(pi * sum) / (2 * size())).widened(expansion_.quadrature_error + pi * expansion_.radius);
  return 2 * half_length() * by_parts / pi - beta_ * pressure(place);
}

/// As functions of theta, p/(2A) and its slope have errors of at most sum m |dc_m|.
std::optional<LargestValue> ProvenContact::peak() const {
  const auto& c = expansion_.coefficients;
  const auto pressure = [&](const Interval& theta) {
    FunctionOver sum{Interval(working_bits()), Interval(working_bits()), Interval(working_bits())};
    for (std::size_t m = 1; m < c.size(); m += remembers() ? 1U : 2U) {
      const auto k = static_cast<long>(m);
      const Interval wave = c[m] * sin(k * theta);
      sum.value = sum.value + wave;
      sum.slope = sum.slope + k * (c[m] * cos(k * theta));
      sum.curvature = sum.curvature - k * k * wave;
    }
    return sum;
  };
  const Interval contact = hull(Interval(working_bits()), Interval::pi(working_bits()));
  return largest_value(pressure, contact, expansion_.radius, expansion_.radius);
}

std::optional<Interval> ProvenContact::peak_pressure() const {
  const auto found = peak();
  return found ? std::optional(2 * half_length() * found->value) : std::nullopt;
}

std::optional<Interval> ProvenContact::peak_pressure_position() const {
  const auto found = peak();
  if (!found) return std::nullopt;
  const Interval from_middle = half_length() * cos(found->place);
  return remembers() ? offset_ + from_middle
                     : either_side(magnitude_of(from_middle));  // the mirror image is a peak, too
}

bool ProvenContact::is_good_to(int digits) const {
  const Float part = pow(Float(10), -digits), A = middle_of(half_length()), W = middle_of(load());
  const auto is_known = [&](const Interval& x, const Float& size) {
    return upper_end(distance_from(middle_of(x), x)) <= part * size;
  };
  return is_known(half_length(), A) && is_known(offset(), A) && is_known(lever(), A) && is_known(load(), W) &&
         is_known(edge_displacement(), middle_of(edge_displacement())) &&
         upper_end(expansion_.radius) * 2 * A <= part * W / A;
}

}  // namespace nipref::ref
