#pragma once
#include <mpfi.h>

#include <algorithm>
#include <vector>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// Owner of one MPFI interval. Every operation returns an interval that contains the true result for all points of its
/// operands. The precision of the result is the largest of the operands' precisions.
class Interval {
 public:
  explicit Interval(mpfr_prec_t precision) {
    mpfi_init2(value_, precision);
    mpfi_set_si(value_, 0);
  }
  Interval(long value, mpfr_prec_t precision) : Interval(precision) { mpfi_set_si(value_, value); }
  Interval(double value, mpfr_prec_t precision) : Interval(precision) { mpfi_set_d(value_, value); }
  Interval(const mpq_class& value, mpfr_prec_t precision) : Interval(precision) {
    mpfi_set_q(value_, value.get_mpq_t());
  }
  Interval(const Exact& value, mpfr_prec_t precision) : Interval(value.value(), precision) {}
  /// [lower, upper], rounded outwards.
  Interval(const Float& lower, const Float& upper, mpfr_prec_t precision) : Interval(precision) {
    mpfi_interv_fr(value_, raw(lower), raw(upper));
  }
  Interval(const Interval& other) : Interval(other.precision()) { mpfi_set(value_, other.value_); }
  Interval(Interval&& other) noexcept {
    mpfi_init2(value_, MPFR_PREC_MIN);
    mpfi_swap(value_, other.value_);
  }
  Interval& operator=(Interval other) noexcept {
    mpfi_swap(value_, other.value_);
    return *this;
  }
  ~Interval() { mpfi_clear(value_); }

  static Interval pi(mpfr_prec_t precision) {
    Interval result(precision);
    mpfi_const_pi(result.value_);
    return result;
  }

  [[nodiscard]] mpfi_ptr get() { return value_; }
  [[nodiscard]] mpfi_srcptr get() const { return value_; }
  [[nodiscard]] mpfr_prec_t precision() const { return mpfi_get_prec(value_); }
  [[nodiscard]] mpfr_srcptr lower() const { return &value_->left; }
  [[nodiscard]] mpfr_srcptr upper() const { return &value_->right; }

  /// The interval made wider on both sides by the upper end of `radius` >= 0.
  [[nodiscard]] Interval widened(const Interval& radius) const;

 private:
  mpfi_t value_;
};

/// Applies a function of MPFI to one or two intervals.
template <auto function>
Interval by_mpfi(const Interval& x) {
  Interval result(x.precision());
  function(result.get(), x.get());
  return result;
}
template <auto function>
Interval by_mpfi(const Interval& x, const Interval& y) {
  Interval result(std::max(x.precision(), y.precision()));
  function(result.get(), x.get(), y.get());
  return result;
}

inline Interval operator-(const Interval& x) { return by_mpfi<mpfi_neg>(x); }
inline Interval operator+(const Interval& x, const Interval& y) { return by_mpfi<mpfi_add>(x, y); }
inline Interval operator-(const Interval& x, const Interval& y) { return by_mpfi<mpfi_sub>(x, y); }
inline Interval operator*(const Interval& x, const Interval& y) { return by_mpfi<mpfi_mul>(x, y); }
inline Interval operator/(const Interval& x, const Interval& y) { return by_mpfi<mpfi_div>(x, y); }
inline Interval operator+(const Interval& x, long y) { return x + Interval(y, x.precision()); }
inline Interval operator-(const Interval& x, long y) { return x - Interval(y, x.precision()); }
inline Interval operator-(long x, const Interval& y) { return Interval(x, y.precision()) - y; }
inline Interval operator*(long x, const Interval& y) { return Interval(x, y.precision()) * y; }
inline Interval operator/(const Interval& x, long y) { return x / Interval(y, x.precision()); }
inline Interval operator/(long x, const Interval& y) { return Interval(x, y.precision()) / y; }

inline Interval abs(const Interval& x) { return by_mpfi<mpfi_abs>(x); }
inline Interval exp(const Interval& x) { return by_mpfi<mpfi_exp>(x); }
inline Interval expm1(const Interval& x) { return by_mpfi<mpfi_expm1>(x); }
inline Interval log(const Interval& x) { return by_mpfi<mpfi_log>(x); }
inline Interval log1p(const Interval& x) { return by_mpfi<mpfi_log1p>(x); }
inline Interval sqrt(const Interval& x) { return by_mpfi<mpfi_sqrt>(x); }
inline Interval square(const Interval& x) { return by_mpfi<mpfi_sqr>(x); }
inline Interval cosh(const Interval& x) { return by_mpfi<mpfi_cosh>(x); }
inline Interval sinh(const Interval& x) { return by_mpfi<mpfi_sinh>(x); }
inline Interval sin(const Interval& x) { return by_mpfi<mpfi_sin>(x); }
inline Interval cos(const Interval& x) { return by_mpfi<mpfi_cos>(x); }
inline Interval acos(const Interval& x) { return by_mpfi<mpfi_acos>(x); }
inline Interval atan(const Interval& x) { return by_mpfi<mpfi_atan>(x); }

/// The smallest interval that contains both.
inline Interval hull(const Interval& x, const Interval& y) { return by_mpfi<mpfi_union>(x, y); }

/// 1 or -1 if all numbers of the interval have that sign, otherwise 0.
inline int sign_of(const Interval& x) {
  return mpfr_sgn(x.lower()) > 0 ? 1 : mpfr_sgn(x.upper()) < 0 ? -1 : 0;
}

inline Interval Interval::widened(const Interval& radius) const {
  Interval both(precision());
  Float negative = zero_of_bits(radius.precision());
  mpfr_neg(raw(negative), radius.upper(), MPFR_RNDD);
  mpfi_interv_fr(both.get(), raw(negative), radius.upper());
  return *this + both;
}

/// The number as an interval. Its width is 0 if `precision`, by default that of x, suffices for x.
inline Interval interval_of(const Float& x, mpfr_prec_t precision) { return {x, x, precision}; }
inline Interval interval_of(const Float& x) { return {x, x, bits_of(x)}; }

/// Contains max(a, b) for all a in x and all b in y.
inline Interval larger_of(const Interval& x, const Interval& y) {
  Interval result = x;
  if (mpfr_greater_p(y.lower(), x.lower()) != 0) mpfr_set(&result.get()->left, y.lower(), MPFR_RNDD);
  if (mpfr_greater_p(y.upper(), x.upper()) != 0) mpfr_set(&result.get()->right, y.upper(), MPFR_RNDU);
  return result;
}

/// The middle of x, rounded to the working precision.
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

/// The largest magnitude in x, as an interval of width 0.
inline Interval magnitude_of(const Interval& x) {
  Float value = zero_of_bits(x.precision());
  mpfi_mag(raw(value), x.get());
  return interval_of(value);
}
/// The sum of the largest magnitudes of several intervals.
inline Interval sum_of_magnitudes(const std::vector<Interval>& x) {
  Interval sum(x.front().precision());
  for (const Interval& value : x) sum = sum + magnitude_of(value);
  return sum;
}
/// The largest distance of a point of x from `centre`.
inline Interval distance_from(const Float& centre, const Interval& x) {
  return magnitude_of(x - interval_of(centre));
}

/// The interval [-1, 1] times x >= 0.
inline Interval either_side(const Interval& x) { return Interval(0L, x.precision()).widened(x); }

}  // namespace nipref::ref
