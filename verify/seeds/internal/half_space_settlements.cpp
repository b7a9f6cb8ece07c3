#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

constexpr int digits = 20;

/// A quantity at arguments, by both paths.
struct Row {
  const Quantity* quantity;
  Point point;
  double by_fast, by_ref, promised;

  Row(const std::string& name, const Assignments& given) : quantity(&find_quantity(name)) {
    const ParsedArguments arguments = parse_arguments(*quantity, given);
    point = arguments.nearest(*quantity);
    by_fast = quantity->by_fast(point, {});
    by_ref = quantity->by_ref(arguments.exact, digits).to_double();
    promised = quantity->promise * ulp_of(std::max(std::fabs(by_fast), quantity->envelope(point)));
  }
};

/// A catalogue's quantity with its printed form; fast has the right one.
Settlement of_form(const std::string& name, const Assignments& given) {
  const Row row(name, given);
  const auto form = std::ranges::find(row.quantity->seed_forms, "printed", &SeedForm::name);
  std::string at = name;
  for (const auto& [argument, text] : given) at += " " + argument + "=" + text;
  return {at, form->value(row.point), row.by_fast, row.by_ref, row.promised};
}

Settlement die_span_ratio() {
  return of_form("die.span_ratio",
                 {{"poisson", "0.3333333333333333"}, {"speed", "0.5"}, {"friction", "0.5"}});
}

Settlement rolling_span_ratio() {
  return of_form("rolling.span_ratio", {{"poisson", "0.3333333333333333"}, {"speed", "0.5"}});
}

Settlement sphere_span_ratio() { return of_form("ti.span_ratio", {{"speed", "0.2"}, {"friction", "0.5"}}); }

Settlement in_plane_compliance() {
  return of_form("ti.compliance",
                 {{"axis", "in-plane"}, {"theta_deg", "45"}, {"psi_deg", "10"}, {"speed", "0.3"}});
}

/// cos pi Omega from the exponent of the other equation, (26a), which is right: tan pi (Omega + 1/2) = ratio.
Settlement cosine_of_exponent() {
  const Row row(
      "die.exponent",
      {{"poisson", "0.3333333333333333"}, {"speed", "0.5"}, {"friction", "0.5"}, {"psi_deg", "60"}});
  const double cosine = std::cos(std::numbers::pi / 3);
  // gamma S cos psi/sqrt(K^2 + (gamma S cos psi)^2), K and S of the half-space; printed with one cosine more.
  const Assignments line{{"poisson", "0.3333333333333333"}, {"speed", "0.5"}, {"psi_deg", "60"}};
  const double compliance = Row("halfspace.compliance", line).by_fast,
               coupling = Row("halfspace.coupling", line).by_fast;
  const double gamma = 0.5 * cosine * coupling, right = gamma / std::hypot(compliance, gamma);
  return {"cos pi Omega, nu = 1/3, c = 0.5, friction 0.5, psi = 60 degrees", right * cosine, right,
          std::cos(std::numbers::pi * row.by_ref), 1e-14};
}

Settlement branch_radicand() {
  const data::TransverselyIsotropicSolid& solid = data::seed::graphite_epoxy;
  const data::IsotropicSolid& steel = data::seed::steel;
  const ScaledModuli moduli{solid.c11 / steel.shear,
                            solid.c33 / steel.shear,
                            solid.c13 / steel.shear,
                            solid.c44 / steel.shear,
                            solid.c66 / steel.shear,
                            std::sqrt(solid.density / steel.density),
                            0};
  const Row branch("ti.branch", {{"theta_deg", "45"}, {"which", "minus"}});
  const auto radicand = [&](double speed) { return 2 * std::pow(speed * moduli.speed_scale, 2); };
  return {"2 c_minus^2 at theta = 45 degrees",
          branch_radicand_as_printed(moduli, fast::Direction::of_degrees(45)), radicand(branch.by_fast),
          radicand(branch.by_ref), 1e-14};
}

}  // namespace

Settlements half_space_settlements() {
  return {{"brock2012-26c", cosine_of_exponent}, {"brock2012-35", die_span_ratio},
          {"brock2012-53b", rolling_span_ratio}, {"brock2013-35", sphere_span_ratio},
          {"brock2013-43", in_plane_compliance}, {"brock2013-46d", branch_radicand}};
}

}  // namespace nipref::verify
