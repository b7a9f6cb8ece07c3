#include <nipref/ref/elastic_nip/internal/gripped_coercivity.hpp>

namespace nipref::ref {

/// The least eigenvalue is at least the determinant over the trace, (1 - beta)(r + beta) with r = (sinh 2x - 2x)/S, which
/// rises, times S/(2 cosh 2x), which rises and then falls to 1/2.
Interval least_stiffness(const Interval& x, const Interval& beta) {
  const Interval twice = 2 * x, S = sinh(twice) + twice;
  const Interval over_trace = S / (2 * cosh(twice));
  const Interval least = mpfr_cmp_d(over_trace.lower(), 0.5) < 0 ? over_trace : Interval(0.5, x.precision());
  return (1 - beta) * ((sinh(twice) - twice) / S + beta) * least;
}

Interval gripped_coercivity(const Interval& half_length, const Interval& beta) {
  constexpr long steps = 16;
  Interval best(half_length.precision());
  for (long k = 1; k < steps; ++k) {
    const Interval z = Interval(2 * k, half_length.precision()) / steps;
    const Interval value = least_stiffness(z / half_length, beta) * (1 - square(z) / 4);
    if (mpfr_greater_p(value.lower(), best.lower()) != 0) best = value;
  }
  return best;
}

}  // namespace nipref::ref
