#include <nipref/data/material/seed_solids.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/seeds/internal/settled_row.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

/// 1/3 to more digits than a result has.
constexpr const char* many_thirds = "0.3333333333333333333333333";

Settlement die_span_ratio() {
  return settled_by_form("die.span_ratio",
                         {{"poisson", "0.3333333333333333"}, {"speed", "0.5"}, {"friction", "0.5"}});
}

Settlement rolling_span_ratio() {
  return settled_by_form("rolling.span_ratio", {{"poisson", "0.3333333333333333"}, {"speed", "0.5"}});
}

Settlement sphere_span_ratio() {
  return settled_by_form("ti.span_ratio", {{"speed", "0.2"}, {"friction", "0.5"}});
}

Settlement in_plane_compliance() {
  return settled_by_form("ti.compliance",
                         {{"axis", "in-plane"}, {"theta_deg", "45"}, {"psi_deg", "10"}, {"speed", "0.3"}});
}

/// cos pi Omega from the exponent of the other equation, (26a), which is right: tan pi (Omega + 1/2) = ratio.
Settlement cosine_of_exponent() {
  const SettledRow row("die.exponent",
                       {{"poisson", many_thirds}, {"speed", "0.5"}, {"friction", "0.5"}, {"psi_deg", "60"}});
  const Propagated cosine = 0.5;
  // gamma S cos psi/sqrt(K^2 + (gamma S cos psi)^2), K and S of the half-space; printed with one cosine more.
  const Assignments line{{"poisson", many_thirds}, {"speed", "0.5"}, {"psi_deg", "60"}};
  const Propagated compliance = SettledRow("halfspace.compliance", line).by_fast,
                   coupling = SettledRow("halfspace.coupling", line).by_fast;
  const Propagated gamma = 0.5 * cosine * coupling, right = gamma / hypot(compliance, gamma);
  return {"cos pi Omega, nu = 1/3, c = 0.5, friction 0.5, psi = 60 degrees", right * cosine, right,
          cos(Propagated::pi() * row.by_ref)};
}

Settlement branch_radicand() {
  const data::TransverselyIsotropicSolid& solid = data::seed::graphite_epoxy;
  const data::IsotropicSolid& steel = data::seed::steel;
  const Propagated speed_scale = sqrt(Propagated(solid.density) / steel.density);
  const ScaledModuli moduli{solid.c11 / steel.shear,
                            solid.c33 / steel.shear,
                            solid.c13 / steel.shear,
                            solid.c44 / steel.shear,
                            solid.c66 / steel.shear,
                            speed_scale.value(),
                            0};
  const SettledRow branch("ti.branch", {{"theta_deg", "45"}, {"which", "minus"}});
  const auto radicand = [&](const Propagated& speed) { return 2 * square(speed * speed_scale); };
  return {"2 c_minus^2 at theta = 45 degrees",
          printed_form(branch_radicand_as_printed(moduli, fast::Direction::of_degrees(45))),
          radicand(branch.by_fast), radicand(branch.by_ref)};
}

/// At rest with friction: the seed gives the limit of no friction.
Settlement die_span_ratio_at_rest() {
  const Assignments at{{"poisson", many_thirds}, {"speed", "0"}, {"friction", "0.3"}};
  const SettledRow row("die.span_ratio", at);
  return {"C2 L2/(C1 L1) at rest, nu = 1/3, friction 0.3", Propagated::exact(1), row.by_fast, row.by_ref};
}

Settlement in_line_response() {
  return settled_by_form("halfspace.in_line",
                         {{"poisson", "0.3333333333333333"}, {"speed", "0.5"}, {"psi_deg", "60"}});
}

Settlement sphere_exponent() {
  return settled_by_form("ti.exponent", {{"speed", "0.2"}, {"friction", "0.5"}});
}

Settlement sphere_force() { return settled_by_form("ti.force", {{"speed", "0.2"}, {"friction", "0.5"}}); }

}  // namespace

Settlements half_space_settlements() {
  return {{"brock2012-26c", cosine_of_exponent},
          {"brock2012-35", die_span_ratio},
          {"brock2012-35-at-rest", die_span_ratio_at_rest},
          {"brock2012-39a", in_line_response},
          {"brock2012-53b", rolling_span_ratio},
          {"brock2013-25c", sphere_exponent},
          {"brock2013-35", sphere_span_ratio},
          {"brock2013-36", sphere_force},
          {"brock2013-43", in_plane_compliance},
          {"brock2013-46d", branch_radicand}};
}

}  // namespace nipref::verify
