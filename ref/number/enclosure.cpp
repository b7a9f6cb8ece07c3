#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
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

/// The estimate for an interval that is computed from a and b.
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

namespace {

/// Digits computed beyond those asked for. value_text() prints most of them.
constexpr int spare_digits = 4;
constexpr int most_attempts = 16;
/// The largest increase of the precision for a small value, in nats. Arguments have at most 5000 digits, so that values
/// other than 0 are expected above e^-15000.
constexpr double most_further_nats = 30'000;
constexpr mpfr_prec_t bound_precision = 64;

/// The natural logarithm of error/(10^-(digits+2) min(1, |value|)). It is positive if the error is too large, and
/// infinite if the interval contains 0.
double shortfall(const Enclosure& result) {
  if (mpfr_zero_p(raw(result.error))) return -1;
  if (mpfr_cmpabs(raw(result.value), raw(result.error)) <= 0) return HUGE_VAL;
  const double size = std::min(0.0, log2_magnitude(result.value));
  return (log2_magnitude(result.error) - size) * std::numbers::ln2 + (result.digits + 2) * std::numbers::ln10;
}

}  // namespace

Enclosure::Enclosure(Float the_value, Float bound, int the_digits)
    : Estimate(std::move(the_value), std::move(bound), the_digits) {
  proven = true;
}

Interval interval_of(const Estimate& number) {
  constexpr mpfr_prec_t spare_bits = 64;
  const mpfr_prec_t precision = bits_of(number.value) + spare_bits;
  const Interval middle(number.value, number.value, precision);
  return middle.widened(Interval(number.error, number.error, precision));
}

Enclosure enclosure_of(const Interval& interval, int digits) {
  Enclosure result{zero_of_bits(interval.precision()), zero_of_bits(bound_precision), digits};
  mpfi_mid(raw(result.value), interval.get());
  Float above = zero_of_bits(bound_precision);
  mpfr_sub(raw(result.error), raw(result.value), interval.lower(), MPFR_RNDU);
  mpfr_sub(raw(above), interval.upper(), raw(result.value), MPFR_RNDU);
  mpfr_max(raw(result.error), raw(result.error), raw(above), MPFR_RNDU);
  return result;
}

void check_digits(int digits) {
  if (digits < 16 || digits > 1000) {
    throw data::BadInput("digits", std::to_string(digits), "must be a whole number from 16 to 1000");
  }
}

Enclosure exact_zero(int digits) {
  check_digits(digits);
  return {zero_of_bits(bound_precision), zero_of_bits(bound_precision), digits};
}

Enclosure exactly(const mpq_class& value, int digits) {
  if (value == 0) return exact_zero(digits);
  return enclose(digits, 0, [&](double nats) {
    return Interval(value, static_cast<mpfr_prec_t>(64 + nats / std::numbers::ln2));
  });
}

Enclosure enclose(int digits, double first_nats, const std::function<Interval(double nats)>& interval_at) {
  check_digits(digits);
  const double first = first_nats + (digits + spare_digits) * std::numbers::ln10;
  double nats = first;
  bool is_large = false;
  for (int attempt = 0; attempt < most_attempts && nats < first + most_further_nats; ++attempt) {
    Enclosure result = enclosure_of(interval_at(nats), digits);
    const double lacking = shortfall(result);
    if (lacking <= 0) return result;
    is_large = std::isfinite(lacking) && mpfr_cmpabs_ui(raw(result.value), 1) > 0;
    nats = std::isfinite(lacking) ? nats + lacking + 2 * std::numbers::ln10 : 2 * nats;
  }
  throw data::BadInput("arguments", "(as given)",
                       (is_large ? "must not make the quantity so large that "
                                 : "must not be so near to a zero of the quantity that ") +
                           std::to_string(digits) + " digits of it cannot be proven");
}

}  // namespace nipref::ref
