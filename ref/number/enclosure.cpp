#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

/// Digits computed beyond those asked for; most of them end up in the printed text.
constexpr int spare_digits = 4;
constexpr int most_attempts = 16;
/// How many nats the precision is raised at most for a small value. Arguments have at most 5000 digits, so that a value
/// that is not 0 is expected above the square root of e^-30000.
constexpr double most_further_nats = 30'000;
constexpr mpfr_prec_t bound_precision = 64;

/// The logarithm of the bound over 10^-(digits+2) min(1, |value|): positive if the bound is too large, infinite if the
/// interval contains 0.
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
