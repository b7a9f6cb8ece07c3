#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/internal/met.hpp>

namespace nipref::verify {
namespace {

/// 0 where it is not known.
double known_envelope(const Quantity& quantity, const ParsedArguments& arguments) try {
  const double envelope = quantity.envelope(arguments.nearest(quantity));
  return std::isfinite(envelope) ? envelope : 0;
} catch (const data::BadInput&) {
  return 0;
}

}  // namespace

bool is_met(const Quantity& quantity, const ParsedArguments& arguments, const ref::Estimate& found,
            int digits) {
  constexpr mpfr_prec_t precision = 64;
  ref::Real allowed(precision), envelope(precision), power(precision);
  mpfr_set_d(envelope.get(), known_envelope(quantity, arguments), MPFR_RNDD);
  mpfr_abs(allowed.get(), found.value.get(), MPFR_RNDD);
  mpfr_max(allowed.get(), allowed.get(), envelope.get(), MPFR_RNDD);
  mpfr_ui_pow_ui(power.get(), 10, static_cast<unsigned long>(digits), MPFR_RNDU);
  mpfr_div(allowed.get(), allowed.get(), power.get(), MPFR_RNDD);
  return mpfr_lessequal_p(found.error.get(), allowed.get()) != 0;
}

}  // namespace nipref::verify
