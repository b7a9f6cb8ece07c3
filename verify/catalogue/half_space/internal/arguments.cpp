#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

// The seed's steel: the decimals 77.2 and sqrt(77.2/7860) as sums of two doubles each.
constexpr double steel_shear = 0x1.34ccccccccccdp+6, steel_shear_low = -0x1.999999999999ap-49;
constexpr fast::SpeedUnit steel_shear_speed{0x1.95ef8ed1dc9eap-4, -0x1.044185d89b02bp-58};

/// If the axis is normal to the surface, waves polarised across the line do not contribute to u3, and the speed may
/// exceed theirs.
ref::ExactStiffness stiffness_of(const ref::ExactTransverse& solid, data::SymmetryAxis axis) {
  return axis == data::SymmetryAxis::normal ? ref::sagittal_stiffness(solid)
                                            : ref::exact_stiffness(solid, axis);
}

}  // namespace

ref::Exact as_written(double constant) { return ref::Exact::parse(fmt::format("{}", constant)); }

data::IsotropicSolid unit_isotropic(double poisson) { return {1, poisson, 1}; }

ref::ExactStiffness exact_isotropic(const ref::Exact& poisson) {
  const ref::Exact unit(1.0);
  return ref::sagittal_stiffness(ref::ExactTransverse::isotropic(unit, poisson, unit));
}

fast::SurfaceResponse isotropic_surface(double poisson, double speed) {
  const data::IsotropicSolid solid = unit_isotropic(poisson);
  return [solid, speed](fast::Direction from_motion) {
    return fast::isotropic_response(solid, speed, from_motion);
  };
}

ref::SurfaceAnswer exact_isotropic_surface(const ref::Exact& poisson, const ref::Exact& speed) {
  const ref::ExactStiffness solid = exact_isotropic(poisson);
  const auto motion = ref::SurfaceDirection::of_degrees(ref::Exact(0.0));
  ref::check_subcritical(solid, speed, motion, motion);
  return [=](const ref::Exact& degrees, int digits) {
    return line_answer(
        ref::line_response(solid, speed, motion, ref::SurfaceDirection::of_degrees(degrees), digits));
  };
}

ref::LineAnswer line_answer(const ref::LineResponse& of) {
  return {of.compliance.value, of.coupling.value, of.coupling_across.value, of.in_line.value};
}

fast::Direction direction_of(const NamedPoint& x, const char* degrees) {
  return fast::Direction::of_degrees(x[degrees]);
}
ref::SurfaceDirection direction_of(const NamedExact& x, const char* degrees) {
  return ref::SurfaceDirection::of_degrees(x[degrees]);
}

data::TransverselyIsotropicSolid transverse_of(const NamedPoint& x) {
  return {x["c11"], x["c33"], x["c13"], x["c44"], x["c66"], x["density"]};
}

fast::TransverselyIsotropicHalfSpace transverse_surface_of(const NamedPoint& x) {
  return {transverse_of(x), symmetry_axis(x), direction_of(x, "theta_deg"), x["speed"], steel_shear_speed};
}

fast::LineResponse in_steel(const fast::LineResponse& line) {
  const auto scaled = [](double answer) { return std::fma(answer, steel_shear, answer * steel_shear_low); };
  return {scaled(line.compliance), scaled(line.coupling), scaled(line.coupling_across)};
}

double speed_in_steel(double speed) { return speed / steel_shear_speed.high; }

double critical_speed_of(const NamedPoint& x) {
  return speed_in_steel(
      fast::critical_speed(transverse_of(x), symmetry_axis(x), direction_of(x, "theta_deg")).speed);
}

ref::ExactStiffness exact_transverse_of(const NamedExact& x, data::SymmetryAxis axis) {
  const ref::ExactTransverse given(x["c11"], x["c33"], x["c13"], x["c44"], x["c66"], x["density"]);
  return stiffness_of(
      given.over(as_written(data::seed::steel.shear).value(), as_written(data::seed::steel.density).value()),
      axis);
}

void check_subcritical(const NamedExact& x) {
  const ref::ExactStiffness solid = exact_transverse_of(x, symmetry_axis(x));
  const auto motion = direction_of(x, "theta_deg");
  // If the axis is normal to the surface, lines differ only in the speed of the load along them, which is largest in
  // the direction of motion.
  if (symmetry_axis(x) == data::SymmetryAxis::normal) {
    ref::check_subcritical(solid, x["speed"], motion, motion);
  } else {
    ref::check_subcritical(solid, x["speed"], motion);
  }
}

// The step is so much smaller than the least distance of a double from the critical speed that the truncation error of
// the difference quotient, step^2 over that distance's square, is below what the digits ask for. The error of ln K over
// the step is below 10^-(digits + guard).
ref::Estimate exact_condition(const ExactLine& line, int digits) {
  constexpr int below_a_rounding = 20, guard = 10, most = 485;
  if (digits < 16 || digits > most) {
    throw data::BadInput("digits", std::to_string(digits),
                         "must be from 16 to " + std::to_string(most) + " for a difference quotient");
  }
  const ref::Exact step = ref::Exact::parse("1e-" + std::to_string(digits + below_a_rounding));
  const auto ln_K = [&](int sign) {
    ExactLine moved = line;
    moved.speed = ref::Exact(mpq_class(line.speed.value() * (1 + sign * step.value())));
    ref::Float value = moved.response(2 * digits + below_a_rounding + guard).compliance.value;
    mpfr_log(ref::raw(value), ref::raw(value), MPFR_RNDN);
    return value;
  };
  ref::Float slope = ln_K(1);
  const ref::Float below = ln_K(-1);
  mpfr_sub(ref::raw(slope), ref::raw(slope), ref::raw(below), MPFR_RNDN);
  ref::Float two_steps = ref::zero_of_bits(ref::bits_of(slope));
  mpfr_set_q(ref::raw(two_steps), mpq_class(2 * step.value()).get_mpq_t(), MPFR_RNDN);
  mpfr_div(ref::raw(slope), ref::raw(slope), ref::raw(two_steps), MPFR_RNDN);
  ref::Float error = ref::zero_of_bits(64);
  mpfr_set_q(ref::raw(error), ref::Exact::parse("1e-" + std::to_string(digits + 2)).value().get_mpq_t(),
             MPFR_RNDU);
  return {slope, error, digits};
}

}  // namespace nipref::verify
