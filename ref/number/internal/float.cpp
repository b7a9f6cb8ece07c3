#include <algorithm>
#include <utility>

#include <nipref/ref/number/internal/float.hpp>

namespace nipref::ref {
namespace {

/// At least as many as hold the digits.
mpfr_prec_t bits_of(int digits) {
  const mpfr_prec_t thousandths = mpfr_prec_t{1000} * digits;
  return thousandths / 301 + (thousandths % 301 != 0 ? 2 : 1);
}

thread_local mpfr_prec_t working_bits = bits_of(50);

/// 0 to the precision of a result.
Float result_of(const Float& x) {
  Float result;
  if (mpfr_get_prec(x.get()) > working_bits) mpfr_set_prec(result.get(), mpfr_get_prec(x.get()));
  return result;
}

Float result_of(const Float& x, const Float& y) {
  return result_of(mpfr_get_prec(x.get()) > mpfr_get_prec(y.get()) ? x : y);
}

template <auto function>
Float apply(const Float& x) {
  Float result = result_of(x);
  function(result.get(), x.get(), MPFR_RNDN);
  return result;
}

template <auto function>
Float apply(const Float& x, const Float& y) {
  Float result = result_of(x, y);
  function(result.get(), x.get(), y.get(), MPFR_RNDN);
  return result;
}

}  // namespace

Float::Float() {
  mpfr_init2(value_, working_bits);
  mpfr_set_zero(value_, 1);
}

Float::Float(double value) {
  mpfr_init2(value_, working_bits);
  mpfr_set_d(value_, value, MPFR_RNDN);
}

Float::Float(long value, Whole) {
  mpfr_init2(value_, working_bits);
  mpfr_set_si(value_, value, MPFR_RNDN);
}

Float::Float(const Float& other) {
  mpfr_init2(value_, mpfr_get_prec(other.value_));
  mpfr_set(value_, other.value_, MPFR_RNDN);
}

Float& Float::operator=(const Float& other) {
  if (this != &other) *this = Float(other);
  return *this;
}

Float& Float::operator=(Float&& other) noexcept {
  std::swap(value_[0], other.value_[0]);
  return *this;
}

Float Float::at_working_precision() const {
  Float result;
  mpfr_set(result.value_, value_, MPFR_RNDN);
  return result;
}

std::partial_ordering operator<=>(const Float& x, const Float& y) {
  if (mpfr_unordered_p(x.value_, y.value_) != 0) return std::partial_ordering::unordered;
  return mpfr_cmp(x.value_, y.value_) <=> 0;
}

Float operator-(const Float& x) { return apply<mpfr_neg>(x); }
Float operator+(const Float& x, const Float& y) { return apply<mpfr_add>(x, y); }
Float operator-(const Float& x, const Float& y) { return apply<mpfr_sub>(x, y); }
Float operator*(const Float& x, const Float& y) { return apply<mpfr_mul>(x, y); }
Float operator/(const Float& x, const Float& y) { return apply<mpfr_div>(x, y); }

Float abs(const Float& x) { return apply<mpfr_abs>(x); }
Float sqrt(const Float& x) { return apply<mpfr_sqrt>(x); }
Float exp(const Float& x) { return apply<mpfr_exp>(x); }
Float log(const Float& x) { return apply<mpfr_log>(x); }
Float sin(const Float& x) { return apply<mpfr_sin>(x); }
Float cos(const Float& x) { return apply<mpfr_cos>(x); }
Float acos(const Float& x) { return apply<mpfr_acos>(x); }
Float atan(const Float& x) { return apply<mpfr_atan>(x); }
Float sinh(const Float& x) { return apply<mpfr_sinh>(x); }
Float cosh(const Float& x) { return apply<mpfr_cosh>(x); }
Float asinh(const Float& x) { return apply<mpfr_asinh>(x); }
Float atanh(const Float& x) { return apply<mpfr_atanh>(x); }
Float hypot(const Float& x, const Float& y) { return apply<mpfr_hypot>(x, y); }
Float pow(const Float& x, const Float& y) { return apply<mpfr_pow>(x, y); }

Float ldexp(const Float& x, long exponent) {
  Float result = result_of(x);
  mpfr_mul_2si(result.get(), x.get(), exponent, MPFR_RNDN);
  return result;
}

Float pi() {
  Float result;
  mpfr_const_pi(result.get(), MPFR_RNDN);
  return result;
}

WorkingDigits::WorkingDigits(int digits) : before_(std::exchange(working_bits, bits_of(digits))) {}
WorkingDigits::~WorkingDigits() { working_bits = before_; }

Float to_float(const Real& real) {
  Float value;
  mpfr_set(value.get(), real.get(), MPFR_RNDN);
  return value;
}

Float to_float(const Exact& exact) {
  Float value;
  mpfr_set_q(value.get(), exact.value().get_mpq_t(), MPFR_RNDN);
  return value;
}

Real to_real(const Float& value) {
  Real real(mpfr_get_prec(value.get()));
  mpfr_set(real.get(), value.get(), MPFR_RNDN);
  return real;
}

Exact to_exact(const Float& value) {
  mpq_class exact;
  mpfr_get_q(exact.get_mpq_t(), value.get());
  return Exact(exact);
}

}  // namespace nipref::ref

nipref::ref::Float std::numeric_limits<nipref::ref::Float>::epsilon() {
  return ldexp(nipref::ref::Float(1), 1 - nipref::ref::working_bits);
}

nipref::ref::Float std::numeric_limits<nipref::ref::Float>::min() {
  nipref::ref::Float result;
  mpfr_nextabove(result.get());
  return result;
}
