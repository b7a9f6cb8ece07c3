#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

constexpr mpfr_prec_t error_precision = 64;

/// Decimal exponent e with 10^e <= |x| < 10^{e+1}, give or take one; 0 for x = 0.
long decimal_exponent(const Float& x) {
  if (mpfr_zero_p(raw(x))) return 0;
  return static_cast<long>(std::floor(static_cast<double>(mpfr_get_exp(raw(x))) / std::log2(10.0)));
}

int printed_digits(const Estimate& x) {
  const auto before_point = std::max(0L, decimal_exponent(x.value) + 1);
  return x.digits + 3 + static_cast<int>(before_point);
}

std::string print(const char* format, int digits, const Float& x) {
  char* text = nullptr;
  if (mpfr_asprintf(&text, format, digits, raw(x)) < 0) throw std::bad_alloc();
  std::string result(text);
  mpfr_free_str(text);
  return result;
}

bool is_exact(const std::string& text, const Float& value) {
  Float read = zero_of_bits(bits_of(value));
  const int rounded = mpfr_strtofr(raw(read), text.c_str(), nullptr, 10, MPFR_RNDN);
  return rounded == 0 && mpfr_equal_p(raw(read), raw(value)) != 0;
}

/// A number that is computed from two others.
Estimate computed(const Interval& number, const Estimate& a, const Estimate& b) {
  Estimate result = enclosure_of(number, std::max(a.digits, b.digits));
  result.proven = a.proven && b.proven;
  return result;
}

bool is_exactly_zero(const Estimate& x) {
  return x.proven && mpfr_zero_p(raw(x.value)) != 0 && mpfr_zero_p(raw(x.error)) != 0;
}

}  // namespace

Estimate::Estimate(Float the_value, Float the_error, int the_digits)
    : WithError{std::move(the_value), std::move(the_error)}, digits(the_digits) {}

std::string Estimate::value_text() const { return print("%.*RNg", printed_digits(*this), value); }

std::string Estimate::error_text() const {
  if (mpfr_zero_p(raw(error)) && is_exact(value_text(), value)) return "0";
  if (mpfr_zero_p(raw(value))) return print("%.*RUe", 1, error);  // the text "0" is exact
  Float sum(error);
  Float last_place = zero_of_bits(error_precision);
  mpfr_set_si(raw(last_place), decimal_exponent(value) + 2 - printed_digits(*this), MPFR_RNDU);
  mpfr_exp10(raw(last_place), raw(last_place), MPFR_RNDU);
  mpfr_div_2ui(raw(last_place), raw(last_place), 1, MPFR_RNDU);
  mpfr_add(raw(sum), raw(sum), raw(last_place), MPFR_RNDU);
  return print("%.*RUe", 1, sum);
}

double Estimate::to_double() const { return mpfr_get_d(raw(value), MPFR_RNDN); }

double Estimate::error_of(double x) const {
  Float difference = zero_of_bits(error_precision);
  mpfr_d_sub(raw(difference), x, raw(value), MPFR_RNDN);
  return mpfr_get_d(raw(difference), MPFR_RNDN);
}

Estimate operator*(const Estimate& a, const Estimate& b) {
  Estimate product = computed(interval_of(a) * interval_of(b), a, b);
  product.proven = product.proven || is_exactly_zero(a) || is_exactly_zero(b);
  return product;
}

Estimate operator-(const Estimate& a, const Estimate& b) {
  return computed(interval_of(a) - interval_of(b), a, b);
}

Estimate operator*(double factor, Estimate number) {
  mpfr_mul_d(raw(number.value), raw(number.value), factor, MPFR_RNDN);
  if (mpfr_zero_p(raw(number.value)) != 0) mpfr_set_zero(raw(number.value), 1);  // no -0
  mpfr_mul_d(raw(number.error), raw(number.error), std::fabs(factor), MPFR_RNDU);
  return number;
}

}  // namespace nipref::ref
