#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

double ulp_of(double scale) {
  using Limits = std::numeric_limits<double>;
  constexpr int lowest_exponent = Limits::min_exponent - Limits::digits;  // -1074
  if (!std::isfinite(scale)) throw data::BadInput("scale", scale, "must be a finite number");
  if (scale == 0) return Limits::denorm_min();
  const int exponent = std::ilogb(scale) - (Limits::digits - 1);
  return std::ldexp(1.0, std::max(exponent, lowest_exponent));
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr mpfr_prec_t quotient_precision = 64;

/// |x - value| + error, rounded up.
ref::Float distance(double x, const ref::Estimate& truth) {
  ref::Float difference = ref::zero_of_bits(quotient_precision);
  mpfr_d_sub(ref::raw(difference), x, ref::raw(truth.value), MPFR_RNDA);
  mpfr_abs(ref::raw(difference), ref::raw(difference), MPFR_RNDU);
  mpfr_add(ref::raw(difference), ref::raw(difference), ref::raw(truth.error), MPFR_RNDU);
  return difference;
}

/// distance / unit rounded up, where 0/0 is 0.
double quotient(const ref::Float& distance, mpfr_srcptr unit) {
  if (mpfr_zero_p(ref::raw(distance))) return 0;
  ref::Float result = ref::zero_of_bits(quotient_precision);
  mpfr_div(ref::raw(result), ref::raw(distance), unit, MPFR_RNDU);
  return std::fabs(mpfr_get_d(ref::raw(result), MPFR_RNDU));
}

double quotient(const ref::Float& distance, double unit) {
  ref::Float divisor = ref::zero_of_bits(quotient_precision);
  mpfr_set_d(ref::raw(divisor), unit, MPFR_RNDN);
  return quotient(distance, ref::raw(divisor));
}

/// The envelope at these arguments, or 0 if it is unknown.
double known_envelope(const Quantity& quantity, const ParsedArguments& arguments) {
  const auto envelope = unless_refused([&] { return quantity.envelope(arguments.nearest(quantity)); });
  return envelope && std::isfinite(*envelope) ? *envelope : 0;
}

}  // namespace

Deviation deviation(double approximation, const ref::Estimate& truth, double envelope) {
  const double scale = std::max(std::fabs(truth.to_double()), envelope);
  if (!std::isfinite(approximation)) return {infinity, infinity, infinity, scale};
  const ref::Float error = distance(approximation, truth);
  return {quotient(error, ulp_of(scale)), quotient(error, ref::raw(truth.value)), quotient(error, scale),
          scale};
}

bool is_met(const Quantity& quantity, const ParsedArguments& arguments, const ref::Estimate& found,
            int digits) {
  constexpr mpfr_prec_t precision = 64;
  ref::Float allowed = ref::zero_of_bits(precision), envelope = ref::zero_of_bits(precision),
             power = ref::zero_of_bits(precision);
  mpfr_set_d(ref::raw(envelope), known_envelope(quantity, arguments), MPFR_RNDD);
  mpfr_abs(ref::raw(allowed), ref::raw(found.value), MPFR_RNDD);
  mpfr_max(ref::raw(allowed), ref::raw(allowed), ref::raw(envelope), MPFR_RNDD);
  mpfr_ui_pow_ui(ref::raw(power), 10, static_cast<unsigned long>(digits), MPFR_RNDU);
  mpfr_div(ref::raw(allowed), ref::raw(allowed), ref::raw(power), MPFR_RNDD);
  return mpfr_lessequal_p(ref::raw(found.error), ref::raw(allowed)) != 0;
}

}  // namespace nipref::verify
