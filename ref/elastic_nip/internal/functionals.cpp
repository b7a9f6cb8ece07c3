#include <algorithm>
#include <utility>

#include <nipref/ref/elastic_nip/internal/functionals.hpp>
#include <nipref/ref/number/internal/cosines.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

constexpr mpfr_prec_t coarse = 64;
constexpr long most_cells = 1 << 16;

bool is_inside(const SurfacePoint& place) { return mpfr_sgn(place.before_end.lower()) >= 0; }
bool is_outside(const SurfacePoint& place) { return mpfr_sgn(place.before_end.upper()) < 0; }

/// x cut off at 0, on one side.
Interval not_below_zero(const Interval& x) {
  Interval result = x;
  if (mpfr_sgn(result.lower()) < 0) mpfr_set_zero(&result.get()->left, 1);
  return result;
}
Interval not_above_zero(const Interval& x) { return -not_below_zero(-x); }

/// `inside` or `outside`, or both where the place may be either.
template <class Inside, class Outside>
Interval by_side(const SurfacePoint& place, const Inside& inside, const Outside& outside) {
  if (is_inside(place)) return inside(place);
  if (is_outside(place)) return outside(place);
  return hull(inside({not_below_zero(place.before_end)}), outside({not_above_zero(place.before_end)}));
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

/// I3 on all of an interval; |I3'| <= int 2x/S dx <= 2.
Interval I3_over(const Interval& alpha, double nats) {
  const Float near = middle_of(alpha);
  const Interval value = near == 0 ? Interval(working_bits()) : I3_interval(to_exact(near), nats);
  return value.widened(2 * distance_from(near, alpha));
}

/// sqrt(1 - s^2) p(s)/(2A) at the nodes.
std::vector<Interval> pressures_at_nodes(const std::vector<Float>& coefficients, const Cosines& cosines) {
  const long n = static_cast<long>(coefficients.size());
  std::vector<Interval> result;
  for (long j = 0; j < n; ++j) {
    const auto sine = [&](long m) -> const Interval& { return cosines(2 * n - (2 * m + 1) * (2 * j + 1)); };
    Interval sum(working_bits());
    for (long m = 0; m < n; ++m) sum = sum + interval_of(coefficients[static_cast<std::size_t>(m)]) * sine(m);
    result.push_back(sum * sine(0));
  }
  return result;
}

/// d(p/(2A))/dtheta at the nodes.
std::vector<Interval> slopes_at_nodes(const std::vector<Float>& coefficients, const Cosines& cosines) {
  const long n = static_cast<long>(coefficients.size());
  std::vector<Interval> result;
  for (long j = 0; j < n; ++j) {
    Interval sum(working_bits());
    for (long m = 0; m < n; ++m) {
      const long mu = 2 * m + 1;
      sum = sum + mu * (interval_of(coefficients[static_cast<std::size_t>(m)]) * cosines(mu * (2 * j + 1)));
    }
    result.push_back(sum);
  }
  return result;
}

}  // namespace

ContactFunctionals::ContactFunctionals(ProvenExpansion expansion, SmoothKernel& kernel, double nats)
    : expansion_(std::move(expansion)), kernel_(kernel), nats_(nats) {
  const Cosines cosines(2 * size(), working_bits());
  for (long j = 0; j < size(); ++j) nodes_.push_back(cosines(2 * j + 1));
  node_pressures_ = pressures_at_nodes(expansion_.coefficients, cosines);
  node_slopes_ = slopes_at_nodes(expansion_.coefficients, cosines);
}

Interval ContactFunctionals::coefficient(long m) const {
  return interval_of(expansion_.coefficients[static_cast<std::size_t>(m)]);
}

Interval ContactFunctionals::load() const {
  const Interval first = coefficient(0).widened(expansion_.energy_radius);
  return Interval::pi(working_bits()) * square(half_length()) * first;
}

Interval ContactFunctionals::pressure(const SurfacePoint& place) const {
  return by_side(
      place, [&](const SurfacePoint& p) { return pressure_between(p); },
      [&](const SurfacePoint&) { return Interval(working_bits()); });
}

/// |dp|/(2A) <= sum |dc_m sin(mu theta)| <= sin(theta) radius.
Interval ContactFunctionals::pressure_between(const SurfacePoint& place) const {
  const Interval theta = angle(place);
  Interval sum(working_bits());
  for (long m = 0; m < size(); ++m) sum = sum + coefficient(m) * sin((2 * m + 1) * theta);
  const Interval sine = sqrt(place.before_end * (2 - place.before_end));
  return 2 * (half_length() * sum.widened(sine * expansion_.radius));
}

/// p(s)/(2A) is off by at most radius sqrt(1 - s^2), whose integral is pi/2 of radius.
template <class Kernel>
Interval ContactFunctionals::smooth_integral(const SurfacePoint& place, const Kernel& kernel,
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

/// u pi/(2 A^2): -ln|t - s| acts on sin(mu theta) in closed form, cosines inside, powers outside. On what the
/// coefficients miss it is at most int |ln|t - s|| ds <= 3 + 2t, and |J| <= 1 + 2|alpha|.
Interval ContactFunctionals::normal_by_pressure(const SurfacePoint& place) const {
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
    sum = sum + coefficient(m) * (lower - upper);
    lower = upper;
  }
  const Interval pi = Interval::pi(precision);
  sum = pi * (sum - log(A) * coefficient(0)) / 2;
  const Interval missed = (2 * magnitude_of(log(A)) + magnitude_of(2 * t + 3)) * expansion_.radius;
  const Interval smooth = smooth_integral(
      place, [&](const Interval& alpha) { return kernel_.over(alpha); }, 2 * (A * (t + 1)) + 1);
  return sum.widened(missed) + smooth;
}

/// v pi/(2 A^2).
Interval ContactFunctionals::tangential_by_pressure(const SurfacePoint& place, const Interval& beta) const {
  const mpfr_prec_t precision = working_bits();
  const Interval pi = Interval::pi(precision);
  const bool inside = is_inside(place);
  // Half of what the load is between 0 and t, by sin(mu theta) sin(theta) = [cos(2m theta) - cos((2m + 2)
  // theta)]/2.
  Interval between = pi * coefficient(0) / 4;
  if (inside) {
    const Interval theta = angle(place);
    Interval lower = pi / 2 - theta;
    between = Interval(precision);
    for (long m = 0; m < size(); ++m) {
      const Interval upper = -(sin((2 * m + 2) * theta) / (2 * m + 2));
      between = between + coefficient(m) * (lower - upper) / 2;
      lower = upper;
    }
  }
  between = between.widened(pi * expansion_.radius / 4);
  coupling_values_ += 2 * size();
  const Interval smooth = smooth_integral(
      place, [&](const Interval& alpha) { return I3_over(alpha, nats_); },
      2 * (half_length() * (position(place) + 1)));
  return smooth - pi * beta * between;
}

Interval ContactFunctionals::indentation() const {
  if (!indentation_) {
    const Interval scale = 2 * square(half_length()) / Interval::pi(working_bits());
    indentation_ = scale * normal_by_pressure({Interval(1L, working_bits())});
  }
  return *indentation_;
}

Interval ContactFunctionals::normal_displacement(const SurfacePoint& place) const {
  const Interval scale = 2 * square(half_length()) / Interval::pi(working_bits());
  return by_side(
      place, [&](const SurfacePoint& p) { return indentation() - square(half_length() * position(p)); },
      [&](const SurfacePoint& p) { return scale * normal_by_pressure(p); });
}

Interval ContactFunctionals::tangential_displacement(const SurfacePoint& place, const Interval& beta) const {
  const Interval scale = 2 * square(half_length()) / Interval::pi(working_bits());
  const auto displacement = [&](const SurfacePoint& p) { return scale * tangential_by_pressure(p, beta); };
  return by_side(place, displacement, displacement);
}

Interval ContactFunctionals::strain(const SurfacePoint& place, const Interval& beta) const {
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
  return 2 * half_length() * by_parts / pi - beta * pressure(place);
}

bool ContactFunctionals::falls_outwards() const {
  // F = sum_k w_k cos(2 k phi), as sin(mu phi)/sin(phi) = 1 + 2 cos(2 phi) + .. + 2 cos(2m phi).
  std::vector<Interval> weights(static_cast<std::size_t>(size()), Interval(coarse));
  Interval sum(coarse);
  Interval slope(coarse);
  for (long m = size() - 1; m >= 0; --m) {
    Interval term(coarse);
    mpfi_set(term.get(), ((2 * m + 1) * coefficient(m)).get());
    sum = m % 2 == 0 ? sum + term : sum - term;
    weights[static_cast<std::size_t>(m)] = m == 0 ? sum : 2 * sum;
    slope = slope + 2 * m * magnitude_of(weights[static_cast<std::size_t>(m)]);
  }
  const auto falls_on = [&](long cells) {
    const Cosines cosines(cells, coarse);
    const Interval variation = slope * Interval::pi(coarse) / (4 * cells);
    for (long i = 0; i < cells; ++i) {
      Interval value(coarse);
      for (long k = 0; k < size(); ++k) {
        value = value + weights[static_cast<std::size_t>(k)] * cosines(k * (2 * i + 1));
      }
      if (mpfr_greater_p(value.lower(), variation.upper()) == 0) return false;
    }
    return true;
  };
  for (long cells = 16; cells <= most_cells; cells *= 4) {
    if (falls_on(cells)) return true;
  }
  return false;
}

}  // namespace nipref::ref
