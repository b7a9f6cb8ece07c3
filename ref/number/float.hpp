#pragma once
#include <mpfr.h>

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>

namespace nipref::ref {

/// A floating-point number of MPFR with the arithmetic of a built-in type. A copy is exact and has the precision of the
/// original. A result is rounded once, to nearest, to the precision of its operands or the working precision of the
/// thread, see WorkingDigits, whichever is larger; but where an operand is a temporary, Boost 1.81 computes in its
/// place, with its bits. Boost counts in decimal digits (its member precision() does too), so that a result has up to
/// two bits less than an operand that has bits of its own. Code that needs more than the working precision therefore
/// calls MPFR's functions.
using Float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                            boost::multiprecision::et_off>;

/// The number as MPFR's own functions take it, where the bits and the direction of rounding are chosen.
inline mpfr_ptr raw(Float& x) { return x.backend().data(); }
inline mpfr_srcptr raw(const Float& x) { return x.backend().data(); }

inline mpfr_prec_t bits_of(const Float& x) { return mpfr_get_prec(raw(x)); }

/// Of x not 0, also where the double under- or overflows.
inline double log2_magnitude(const Float& x) {
  long exponent = 0;
  const double fraction = mpfr_get_d_2exp(&exponent, raw(x), MPFR_RNDN);
  return std::log2(std::abs(fraction)) + static_cast<double>(exponent);
}

/// 0 with bits of its own, whatever the working precision is.
inline Float zero_of_bits(mpfr_prec_t bits) {
  Float zero;
  mpfr_set_prec(raw(zero), bits);
  mpfr_set_zero(raw(zero), 1);
  return zero;
}

/// Sets the decimal digits of new numbers of this thread, until its destructor restores the previous ones.
class WorkingDigits {
 public:
  explicit WorkingDigits(int digits) : before_(Float::thread_default_precision()) {
    Float::thread_default_precision(static_cast<unsigned>(digits));
  }
  WorkingDigits(const WorkingDigits&) = delete;
  WorkingDigits& operator=(const WorkingDigits&) = delete;
  ~WorkingDigits() { Float::thread_default_precision(before_); }

 private:
  unsigned before_;
};

/// The bits of new numbers of this thread.
inline mpfr_prec_t working_bits() { return bits_of(Float()); }
/// Decimal digits that hold so many bits.
inline int digits_of(mpfr_prec_t bits) { return static_cast<int>(static_cast<double>(bits) * 0.30103) + 1; }
/// The number rounded to the working precision.
inline Float at_working_precision(const Float& x) {
  Float result;
  mpfr_set(raw(result), raw(x), MPFR_RNDN);
  return result;
}

/// sum += x y by a scratch number, so that none is allocated.
inline void add_product(Float& sum, Float& scratch, const Float& x, const Float& y) {
  mpfr_mul(raw(scratch), raw(x), raw(y), MPFR_RNDN);
  mpfr_add(raw(sum), raw(sum), raw(scratch), MPFR_RNDN);
}

inline Float pi() {
  Float result;
  mpfr_const_pi(raw(result), MPFR_RNDN);
  return result;
}
/// The root of the sum of the squares, without overflow and rounded once.
inline Float hypot(const Float& x, const Float& y) {
  Float result = zero_of_bits(std::max({bits_of(x), bits_of(y), working_bits()}));
  mpfr_hypot(raw(result), raw(x), raw(y), MPFR_RNDN);
  return result;
}

}  // namespace nipref::ref
