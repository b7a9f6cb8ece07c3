#include <algorithm>
#include <cmath>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

double log2_magnitude(const Float& x) {
  long exponent = 0;
  const double fraction = mpfr_get_d_2exp(&exponent, raw(x), MPFR_RNDN);
  return std::log2(std::abs(fraction)) + static_cast<double>(exponent);
}

Float zero_of_bits(mpfr_prec_t bits) {
  Float zero;
  mpfr_set_prec(raw(zero), bits);
  mpfr_set_zero(raw(zero), 1);
  return zero;
}

WorkingDigits::WorkingDigits(int digits) : before_(Float::thread_default_precision()) {
  Float::thread_default_precision(static_cast<unsigned>(digits));
}
WorkingDigits::~WorkingDigits() { Float::thread_default_precision(before_); }

mpfr_prec_t working_bits() { return bits_of(Float()); }

Float at_working_precision(const Float& x) {
  Float result;
  mpfr_set(raw(result), raw(x), MPFR_RNDN);
  return result;
}

Float pi() {
  Float result;
  mpfr_const_pi(raw(result), MPFR_RNDN);
  return result;
}

Float hypot(const Float& x, const Float& y) {
  Float result = zero_of_bits(std::max({bits_of(x), bits_of(y), working_bits()}));
  mpfr_hypot(raw(result), raw(x), raw(y), MPFR_RNDN);
  return result;
}

}  // namespace nipref::ref
