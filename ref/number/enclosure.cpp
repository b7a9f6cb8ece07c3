#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

/// Digits computed beyond those asked for; most of them end up in the printed text.
constexpr int spare_digits = 4;
constexpr int most_attempts = 8;
constexpr mpfr_prec_t bound_precision = 64;

/// Decimal exponent e with 10^e <= |x| < 10^{e+1}, give or take one; 0 for x = 0.
long decimal_exponent(const Real& x) {
  if (mpfr_zero_p(x.get())) return 0;
  return static_cast<long>(std::floor(static_cast<double>(mpfr_get_exp(x.get())) / std::log2(10.0)));
}

int printed_digits(const Enclosure& enclosure) {
  const auto before_point = std::max(0L, decimal_exponent(enclosure.value) + 1);
  return enclosure.digits + 3 + static_cast<int>(before_point);
}

std::string print(const char* format, int digits, const Real& x) {
  char* text = nullptr;
  if (mpfr_asprintf(&text, format, digits, x.get()) < 0) throw std::bad_alloc();
  std::string result(text);
  mpfr_free_str(text);
  return result;
}

Enclosure centre_and_radius(const Interval& interval, int digits) {
  Enclosure result{Real(interval.precision()), Real(bound_precision), digits};
  mpfi_mid(result.value.get(), interval.get());
  Real above(bound_precision);
  mpfr_sub(result.error_bound.get(), result.value.get(), interval.lower(), MPFR_RNDU);
  mpfr_sub(above.get(), interval.upper(), result.value.get(), MPFR_RNDU);
  mpfr_max(result.error_bound.get(), result.error_bound.get(), above.get(), MPFR_RNDU);
  return result;
}

double log2_magnitude(mpfr_srcptr x) {
  long exponent = 0;
  const double fraction = mpfr_get_d_2exp(&exponent, x, MPFR_RNDN);
  return std::log2(std::abs(fraction)) + static_cast<double>(exponent);
}

/// ln of how much the bound exceeds 10^-(digits+2) min(1, |value|); infinite where 0 is not excluded.
double shortfall(const Enclosure& result) {
  if (mpfr_zero_p(result.error_bound.get())) return -1;
  if (mpfr_cmpabs(result.value.get(), result.error_bound.get()) <= 0) return INFINITY;
  const double size = std::min(0.0, log2_magnitude(result.value.get()));
  return (log2_magnitude(result.error_bound.get()) - size) * std::numbers::ln2 +
         (result.digits + 2) * std::numbers::ln10;
}

}  // namespace

std::string Enclosure::value_text() const { return print("%.*RNg", printed_digits(*this), value); }

std::string Enclosure::bound_text() const {
  if (mpfr_zero_p(error_bound.get())) return "0";
  Real bound(error_bound);
  Real last_place(bound_precision);
  mpfr_set_si(last_place.get(), decimal_exponent(value) + 2 - printed_digits(*this), MPFR_RNDU);
  mpfr_exp10(last_place.get(), last_place.get(), MPFR_RNDU);
  mpfr_div_2ui(last_place.get(), last_place.get(), 1, MPFR_RNDU);
  mpfr_add(bound.get(), bound.get(), last_place.get(), MPFR_RNDU);
  return print("%.*RUe", 1, bound);
}

double Enclosure::to_double() const { return mpfr_get_d(value.get(), MPFR_RNDN); }

double Enclosure::error_of(double x) const {
  Real difference(64);
  mpfr_d_sub(difference.get(), x, value.get(), MPFR_RNDN);
  return mpfr_get_d(difference.get(), MPFR_RNDN);
}

void check_digits(int digits) {
  if (digits < 16 || digits > 1000) {
    throw data::BadInput("digits", std::to_string(digits), "must be a whole number from 16 to 1000");
  }
}

Enclosure exact_zero(int digits) {
  check_digits(digits);
  return {Real(bound_precision), Real(bound_precision), digits};
}

Enclosure enclose(int digits, double first_nats, const std::function<Interval(double nats)>& interval_at) {
  check_digits(digits);
  double nats = first_nats + (digits + spare_digits) * std::numbers::ln10;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    Enclosure result = centre_and_radius(interval_at(nats), digits);
    const double lacking = shortfall(result);
    if (lacking <= 0) return result;
    nats = std::isfinite(lacking) ? nats + lacking + 2 * std::numbers::ln10 : 2 * nats;
  }
  throw std::logic_error("no enclosure excludes zero");
}

}  // namespace nipref::ref
