#pragma once
#include <algorithm>
#include <vector>

#include <nipref/ref/number/interval.hpp>

// Conversions between Float and Interval.

namespace nipref::ref {

/// The number as an interval, of width 0 if the precision suffices for it, which is by default its own.
inline Interval interval_of(const Float& x, mpfr_prec_t precision) { return {x, x, precision}; }
inline Interval interval_of(const Float& x) { return {x, x, bits_of(x)}; }

/// The smallest interval that contains both.
inline Interval hull(const Interval& x, const Interval& y) {
  Interval result(std::max(x.precision(), y.precision()));
  mpfi_union(result.get(), x.get(), y.get());
  return result;
}

/// Contains the larger of any number of x and any of y.
inline Interval larger_of(const Interval& x, const Interval& y) {
  Interval result = x;
  if (mpfr_greater_p(y.lower(), x.lower()) != 0) mpfr_set(&result.get()->left, y.lower(), MPFR_RNDD);
  if (mpfr_greater_p(y.upper(), x.upper()) != 0) mpfr_set(&result.get()->right, y.upper(), MPFR_RNDU);
  return result;
}

/// Rounded to the working precision.
inline Float middle_of(const Interval& x) {
  Float value = zero_of_bits(x.precision());
  mpfi_mid(raw(value), x.get());
  return at_working_precision(value);
}

/// A number of the working precision >= the upper end.
inline Float upper_end(const Interval& x) {
  Float result;
  mpfr_set(raw(result), x.upper(), MPFR_RNDU);
  return result;
}

/// The largest |x|, the sum of those of several, and the largest distance of x from `centre`, as points.
inline Interval magnitude_of(const Interval& x) {
  Float value = zero_of_bits(x.precision());
  mpfi_mag(raw(value), x.get());
  return interval_of(value);
}
inline Interval sum_of_magnitudes(const std::vector<Interval>& x) {
  Interval sum(x.front().precision());
  for (const Interval& value : x) sum = sum + magnitude_of(value);
  return sum;
}
inline Interval distance_from(const Float& centre, const Interval& x) {
  return magnitude_of(x - interval_of(centre));
}

/// [-1, 1] times x >= 0.
inline Interval either_side(const Interval& x) { return Interval(0L, x.precision()).widened(x); }

}  // namespace nipref::ref
