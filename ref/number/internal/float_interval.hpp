#pragma once
#include <algorithm>

#include <nipref/ref/number/internal/float.hpp>
#include <nipref/ref/number/interval.hpp>

// Between Float and Interval, at the working precision of the thread.

namespace nipref::ref {

inline mpfr_prec_t precision_here() { return mpfr_get_prec(Float().get()); }

/// The number itself, where the second precision holds it.
inline Interval interval_of(const Float& x) {
  const Real value = to_real(x);
  return {value, value, value.precision()};
}
inline Interval interval_of(const Float& x, mpfr_prec_t precision) {
  const Real value = to_real(x);
  return {value, value, precision};
}

/// [lower, upper] of two intervals, from one to the other.
inline Interval hull(const Interval& x, const Interval& y) {
  Interval result(std::max(x.precision(), y.precision()));
  mpfi_union(result.get(), x.get(), y.get());
  return result;
}

inline Float middle_of(const Interval& x) {
  Real value(x.precision());
  mpfi_mid(value.get(), x.get());
  return to_float(value);
}

/// A number >= the upper end.
inline Float upper_end(const Interval& x) {
  Float result;
  mpfr_set(result.get(), x.upper(), MPFR_RNDU);
  return result;
}

/// The largest |x|, and the largest distance of x from `centre`, as points.
inline Interval magnitude_of(const Interval& x) {
  Real value(x.precision());
  mpfi_mag(value.get(), x.get());
  return {value, value, x.precision()};
}
inline Interval distance_from(const Float& centre, const Interval& x) {
  return magnitude_of(x - interval_of(centre));
}

/// [-1, 1] times x >= 0.
inline Interval either_side(const Interval& x) { return Interval(0L, x.precision()).widened(x); }

}  // namespace nipref::ref
