#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/line_entry.hpp>

namespace nipref::verify {

using ref::Exact;
using ref::SurfaceDirection;

Quantity half_space_entry(std::string name, std::string definition, std::string source) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = std::move(source);
  entry.scale = "the value";
  entry.promise = 4;
  entry.envelope = [](Doubles) { return 0.0; };
  entry.audit_points = 200;
  entry.is_costly = true;
  return entry;
}

Quantity condition_entry(std::string name, std::string source) {
  Quantity entry = half_space_entry(
      std::move(name), "d ln K/d ln speed: how much of a relative error of the speed comes out in K",
      std::move(source));
  entry.scale = "1 or the value";
  entry.envelope = [](Doubles) { return 1.0; };
  return entry;
}

// The step so far below any distance from the critical speed that a double can have, that the next term of the
// difference, step^2 over that distance's square, is below what the digits ask for.
ref::Estimate exact_condition(const ref::ExactStiffness& solid, const Exact& speed,
                              const SurfaceDirection& motion, const SurfaceDirection& psi, int digits) {
  constexpr int below_a_rounding = 20, guard = 10, most = 485;
  if (digits < 16 || digits > most) {
    throw data::BadInput("digits", std::to_string(digits),
                         "must be from 16 to " + std::to_string(most) + " for a difference quotient");
  }
  const Exact step = Exact::parse("1e-" + std::to_string(digits + below_a_rounding));
  const auto ln_K = [&](int sign) {
    const Exact moved(mpq_class(speed.value() * (1 + sign * step.value())));
    ref::Real value =
        ref::line_response(solid, moved, motion, psi, 2 * digits + below_a_rounding + guard).compliance.value;
    mpfr_log(value.get(), value.get(), MPFR_RNDN);
    return value;
  };
  ref::Real slope = ln_K(1);
  const ref::Real below = ln_K(-1);
  mpfr_sub(slope.get(), slope.get(), below.get(), MPFR_RNDN);
  ref::Real two_steps(slope.precision());
  mpfr_set_q(two_steps.get(), mpq_class(2 * step.value()).get_mpq_t(), MPFR_RNDN);
  mpfr_div(slope.get(), slope.get(), two_steps.get(), MPFR_RNDN);
  ref::Real error(64);
  mpfr_set_q(error.get(), Exact::parse("1e-" + std::to_string(digits)).value().get_mpq_t(), MPFR_RNDU);
  return {slope, error, digits};
}

double draw_share(Random& random) {
  switch (random.index(4)) {
    case 0:
      return random.log_uniform(1e-8, 1);
    case 1:
      return 1 - random.log_uniform(1e-9, 1e-3);
    default:
      return random.uniform(0, 0.999);
  }
}

double draw_degrees(Random& random) {
  const double sign = random.chance(0.5) ? 1 : -1;
  switch (random.index(4)) {
    case 0:
      return sign * (90 - random.log_uniform(1e-12, 1));
    case 1:
      return sign * random.log_uniform(1e-6, 1);
    default:
      return random.uniform(-90, 90);
  }
}

}  // namespace nipref::verify
