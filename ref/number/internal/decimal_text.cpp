#include <algorithm>
#include <cmath>
#include <new>

#include <nipref/ref/number/internal/decimal_text.hpp>

namespace nipref::ref {
namespace {

constexpr mpfr_prec_t error_precision = 64;

/// Decimal exponent e with 10^e <= |x| < 10^{e+1}, give or take one; 0 for x = 0.
long decimal_exponent(const Real& x) {
  if (mpfr_zero_p(x.get())) return 0;
  return static_cast<long>(std::floor(static_cast<double>(mpfr_get_exp(x.get())) / std::log2(10.0)));
}

int printed_digits(const Real& value, int digits) {
  const auto before_point = std::max(0L, decimal_exponent(value) + 1);
  return digits + 3 + static_cast<int>(before_point);
}

std::string print(const char* format, int digits, const Real& x) {
  char* text = nullptr;
  if (mpfr_asprintf(&text, format, digits, x.get()) < 0) throw std::bad_alloc();
  std::string result(text);
  mpfr_free_str(text);
  return result;
}

bool is_exact(const std::string& text, const Real& value) {
  Real read(value.precision());
  const int rounded = mpfr_strtofr(read.get(), text.c_str(), nullptr, 10, MPFR_RNDN);
  return rounded == 0 && mpfr_equal_p(read.get(), value.get()) != 0;
}

}  // namespace

std::string decimal_text(const Real& value, int digits) {
  return print("%.*RNg", printed_digits(value, digits), value);
}

std::string error_text(const Real& value, const Real& error, int digits) {
  if (mpfr_zero_p(error.get()) && is_exact(decimal_text(value, digits), value)) return "0";
  if (mpfr_zero_p(value.get())) return print("%.*RUe", 1, error);  // its text is exact
  Real sum(error);
  Real last_place(error_precision);
  mpfr_set_si(last_place.get(), decimal_exponent(value) + 2 - printed_digits(value, digits), MPFR_RNDU);
  mpfr_exp10(last_place.get(), last_place.get(), MPFR_RNDU);
  mpfr_div_2ui(last_place.get(), last_place.get(), 1, MPFR_RNDU);
  mpfr_add(sum.get(), sum.get(), last_place.get(), MPFR_RNDU);
  return print("%.*RUe", 1, sum);
}

double error_of(double x, const Real& value) {
  Real difference(error_precision);
  mpfr_d_sub(difference.get(), x, value.get(), MPFR_RNDN);
  return mpfr_get_d(difference.get(), MPFR_RNDN);
}

}  // namespace nipref::ref
