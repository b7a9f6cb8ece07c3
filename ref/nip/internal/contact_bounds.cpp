#include <algorithm>
#include <cmath>

#include <nipref/ref/nip/internal/contact_bounds.hpp>

namespace nipref::ref {
namespace {

/// A sinh(tau) that makes C e^{-2n tau} smallest, or nearly so.
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

/// The least eigenvalue is at least the determinant over the trace, (1 - beta)(r + beta) with r = (sinh 2x - 2x)/S, which
/// rises, times S/(2 cosh 2x), which rises and then falls to 1/2.
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

}  // namespace nipref::ref
