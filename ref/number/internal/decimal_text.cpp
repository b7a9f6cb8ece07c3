#include <algorithm>
#include <cmath>
#include <new>

#include <nipref/ref/number/internal/decimal_text.hpp>

namespace nipref::ref {
namespace {

constexpr mpfr_prec_t error_precision = 64;

/// Decimal exponent e with 10^e <= |x| < 10^{e+1}, give or take one; 0 for x = 0.
long decimal_exponent(const Float& x) {
  if (mpfr_zero_p(raw(x))) return 0;
  return static_cast<long>(std::floor(static_cast<double>(mpfr_get_exp(raw(x))) / std::log2(10.0)));
}

int printed_digits(const Float& value, int digits) {
  const auto before_point = std::max(0L, decimal_exponent(value) + 1);
  return digits + 3 + static_cast<int>(before_point);
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

}  // namespace

std::string decimal_text(const Float& value, int digits) {
  return print("%.*RNg", printed_digits(value, digits), value);
}

std::string error_text(const Float& value, const Float& error, int digits) {
  if (mpfr_zero_p(raw(error)) && is_exact(decimal_text(value, digits), value)) return "0";
  if (mpfr_zero_p(raw(value))) return print("%.*RUe", 1, error);  // the text "0" is exact
  Float sum(error);
  Float last_place = zero_of_bits(error_precision);
  mpfr_set_si(raw(last_place), decimal_exponent(value) + 2 - printed_digits(value, digits), MPFR_RNDU);
  mpfr_exp10(raw(last_place), raw(last_place), MPFR_RNDU);
  mpfr_div_2ui(raw(last_place), raw(last_place), 1, MPFR_RNDU);
  mpfr_add(raw(sum), raw(sum), raw(last_place), MPFR_RNDU);
  return print("%.*RUe", 1, sum);
}

double error_of(double x, const Float& value) {
  Float difference = zero_of_bits(error_precision);
  mpfr_d_sub(raw(difference), x, raw(value), MPFR_RNDN);
  return mpfr_get_d(raw(difference), MPFR_RNDN);
}

}  // namespace nipref::ref
