#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>

namespace nipref::verify {
namespace {

using data::seed::graphite_epoxy;

// Of the seed's steel in two words: 77.2 and sqrt(77.2/7860), as the decimals stand.
constexpr double steel_shear = 0x1.34ccccccccccdp+6, steel_shear_low = -0x1.999999999999ap-49;
constexpr fast::SpeedUnit steel_shear_speed{0x1.95ef8ed1dc9eap-4, -0x1.044185d89b02bp-58};

/// With the axis normal to the surface, waves polarised across the line have no part in u3 and may be
/// overtaken.
ref::ExactStiffness stiffness_of(const ref::ExactTransverse& solid, data::SymmetryAxis axis) {
  return axis == data::SymmetryAxis::normal ? ref::sagittal_stiffness(solid)
                                            : ref::exact_stiffness(solid, axis);
}

data::SymmetryAxis exact_axis_at(Exacts x, std::size_t at) {
  return x[at].sign() == 0 ? data::SymmetryAxis::normal : data::SymmetryAxis::in_plane;
}

}  // namespace

ref::Exact as_written(double constant) { return ref::Exact::parse(fmt::format("{}", constant)); }

Point with_epoxy(Point x) {
  const auto& [c11, c33, c13, c44, c66, density] = graphite_epoxy;
  x.insert(x.end(), {c11, c33, c13, c44, c66, density});
  return x;
}

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
  return [=](const ref::Exact& degrees, int digits) -> ref::LineAnswer {
    const auto answer =
        ref::line_response(solid, speed, motion, ref::SurfaceDirection::of_degrees(degrees), digits);
    return {answer.compliance.value, answer.coupling.value, answer.coupling_across.value,
            answer.in_line.value};
  };
}

void append_transverse_arguments(std::vector<Argument>& arguments) {
  arguments.push_back({"axis", ArgumentKind::choice, "normal", {}, {"normal", "in-plane"}});
  append_constants(arguments);
}

void append_constants(std::vector<Argument>& arguments) {
  const auto append = [&](const char* name, ArgumentKind kind, double value) {
    arguments.push_back({name, kind, fmt::format("{}", value), {}});
  };
  append("c11", ArgumentKind::positive, graphite_epoxy.c11);
  append("c33", ArgumentKind::positive, graphite_epoxy.c33);
  append("c13", ArgumentKind::amplitude, graphite_epoxy.c13);
  append("c44", ArgumentKind::positive, graphite_epoxy.c44);
  append("c66", ArgumentKind::positive, graphite_epoxy.c66);
  append("density", ArgumentKind::positive, graphite_epoxy.density);
}

data::SymmetryAxis axis_at(Doubles x, std::size_t at) {
  return x[at] < 0.5 ? data::SymmetryAxis::normal : data::SymmetryAxis::in_plane;
}

data::TransverselyIsotropicSolid transverse_at(Doubles x, std::size_t at) {
  return {x[at + 1], x[at + 2], x[at + 3], x[at + 4], x[at + 5], x[at + 6]};
}

fast::TransverselyIsotropicHalfSpace transverse_surface_at(Doubles x, std::size_t at, double theta_deg,
                                                           double speed) {
  return {transverse_at(x, at), axis_at(x, at), fast::Direction::of_degrees(theta_deg), speed,
          steel_shear_speed};
}

fast::LineResponse in_steel(const fast::LineResponse& line) {
  const auto scaled = [](double answer) { return std::fma(answer, steel_shear, answer * steel_shear_low); };
  return {scaled(line.compliance), scaled(line.coupling), scaled(line.coupling_across)};
}

double speed_in_steel(double speed) { return speed / steel_shear_speed.high; }

ScaledModuli scaled_moduli_at(Doubles x, std::size_t at) {
  const auto over_steel = [&](std::size_t i) { return x[at + i] / data::seed::steel.shear; };
  constexpr double nu = data::seed::steel.poisson;
  return {over_steel(1),
          over_steel(2),
          over_steel(3),
          over_steel(4),
          over_steel(5),
          std::sqrt(x[at + 6] / data::seed::steel.density),
          std::sqrt((2 - 2 * nu) / (1 - 2 * nu))};
}

ref::ExactStiffness exact_transverse_at(Exacts x, std::size_t at) {
  return exact_transverse_at(x, at, exact_axis_at(x, at));
}

ref::ExactStiffness exact_transverse_at(Exacts x, std::size_t at, data::SymmetryAxis axis) {
  const ref::ExactTransverse given(x[at + 1], x[at + 2], x[at + 3], x[at + 4], x[at + 5], x[at + 6]);
  return stiffness_of(
      given.over(as_written(data::seed::steel.shear).value(), as_written(data::seed::steel.density).value()),
      axis);
}

void check_subcritical(Exacts x, std::size_t at, const ref::Exact& theta_deg, const ref::Exact& speed) {
  const ref::ExactStiffness solid = exact_transverse_at(x, at);
  const auto motion = ref::SurfaceDirection::of_degrees(theta_deg);
  // About a normal axis all lines are alike but for the speed along them, which is largest along the motion.
  if (exact_axis_at(x, at) == data::SymmetryAxis::normal) {
    ref::check_subcritical(solid, speed, motion, motion);
  } else {
    ref::check_subcritical(solid, speed, motion);
  }
}

}  // namespace nipref::verify
