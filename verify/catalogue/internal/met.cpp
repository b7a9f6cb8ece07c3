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
