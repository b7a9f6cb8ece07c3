#pragma once
#include <mpfr.h>

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>

namespace nipref::ref {

/// A floating-point number of MPFR with the arithmetic of a built-in type. A copy is exact and has the precision of the
/// original. A result is rounded once, to nearest. The precision of a result is the largest of the precisions of its
/// operands and the working precision of the thread, see WorkingDigits. There are two exceptions. If an operand is a
/// temporary, Boost 1.81 stores the result in it, with its precision. Boost counts in decimal digits, as its member
/// precision() does, so that a result may have up to two bits less than an operand whose precision was set in bits.
/// Code that needs more than the working precision therefore calls MPFR's functions.
using Float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                            boost::multiprecision::et_off>;

/// The number as an argument of MPFR's functions, where the caller chooses the precision and the direction of rounding.
inline mpfr_ptr raw(Float& x) { return x.backend().data(); }
inline mpfr_srcptr raw(const Float& x) { return x.backend().data(); }

inline mpfr_prec_t bits_of(const Float& x) { return mpfr_get_prec(raw(x)); }

/// log2 |x| of x != 0, also where the nearest double under- or overflows.
inline double log2_magnitude(const Float& x) {
  long exponent = 0;
  const double fraction = mpfr_get_d_2exp(&exponent, raw(x), MPFR_RNDN);
  return std::log2(std::abs(fraction)) + static_cast<double>(exponent);
}

/// 0 with a precision of `bits` bits, whatever the working precision is.
inline Float zero_of_bits(mpfr_prec_t bits) {
  Float zero;
  mpfr_set_prec(raw(zero), bits);
  mpfr_set_zero(raw(zero), 1);
  return zero;
}

/// Sets the working precision of this thread, in decimal digits. The destructor restores the previous precision.
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

/// The working precision of this thread in bits.
inline mpfr_prec_t working_bits() { return bits_of(Float()); }
/// A number of decimal digits that holds `bits` bits.
inline int digits_of(mpfr_prec_t bits) { return static_cast<int>(static_cast<double>(bits) * 0.30103) + 1; }
/// The number rounded to the working precision.
inline Float at_working_precision(const Float& x) {
  Float result;
  mpfr_set(raw(result), raw(x), MPFR_RNDN);
  return result;
}

/// sum += x y. The caller provides the number for the product, so that none is allocated.
inline void add_product(Float& sum, Float& scratch, const Float& x, const Float& y) {
  mpfr_mul(raw(scratch), raw(x), raw(y), MPFR_RNDN);
  mpfr_add(raw(sum), raw(sum), raw(scratch), MPFR_RNDN);
}

inline Float pi() {
  Float result;
  mpfr_const_pi(raw(result), MPFR_RNDN);
  return result;
}
/// sqrt(x^2 + y^2), without overflow and rounded once.
inline Float hypot(const Float& x, const Float& y) {
  Float result = zero_of_bits(std::max({bits_of(x), bits_of(y), working_bits()}));
  mpfr_hypot(raw(result), raw(x), raw(y), MPFR_RNDN);
  return result;
}

}  // namespace nipref::ref
