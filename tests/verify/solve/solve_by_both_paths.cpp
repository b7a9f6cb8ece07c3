// Scenes that both paths solve: fast is within the errors of the reference, which has the digits that it was asked for.
#include <nipref/data/scene/file.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/covered.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

struct Example {
  const char* name;
  data::SceneOverrides overrides;
  std::vector<double> profile = {};  ///< empty: the example's
};

data::Scene scene_of(const Example& example) {
  data::Scene scene = data::load_scene(data::example_scene(example.name), example.overrides);
  if (!example.profile.empty())
    std::visit([&](auto& problem) { problem.profile = data::Positions{example.profile}; }, scene.system);
  return scene;
}

const std::string nip_results =
    R"(["contact_length", "leading_length", "trailing_length", "load", "indentation", "edge_displacement",
    "trailing_displacement", "rolling_resistance", "eccentricity", "resistance_force", "power_loss", "creep_ratio",
    "peak_pressure", "peak_pressure_position", "peak_shear", "pressure", "shear", "normal_displacement",
    "tangential_displacement", "surface_strain", "slip"])";
const std::string shear_places = R"(["peak_pressure_position", "peak_shear_position", "shear_zeros"])";
const std::string inside =
    R"(["stress_across", "stress_along", "stress_shear", "highest_stress", "maximum_shear"])";

/// A contact of L/B = `length` that grips; its places of the shear.
Example gripped(const char* length) {
  return {"thin-given-length",
          {{"wanted", shear_places},
           {"roller.radius", "1e3"},
           {"sheet.thickness", "1"},
           {"material.young", "1"},
           {"friction.model", "full"},
           {"contact.length", length}}};
}

/// Beside an end, and on the faces.
Example stressed(const char* name, const char* friction, const char* thickness) {
  return {name,
          {{"wanted", inside},
           {"friction.model", friction},
           {"sheet.thickness", thickness},
           {"field.positions", "[0.067, -0.2]"},
           {"field.depths", "[-0.99999, 1]"}}};
}

void check(const std::vector<Example>& examples) {
  for (const Example& example : examples) {
    CAPTURE(example.name);
    const auto by_ref = by_both_paths(scene_of(example)).ref;
    CHECK(by_ref.missed().empty());
    CHECK((by_ref.work.unknowns > 0 || std::string(example.name).starts_with("half-space")));
  }
}

}  // namespace

TEST_CASE("both paths: every example that takes the reference less than about a second") {
  for (const char* name :
       {"half-space-near-critical", "half-space-rolling-sphere", "half-space-sliding-die",
        "half-space-sliding-die-exact", "half-space-sphere-in-plane-axis", "half-space-sphere-normal-axis",
        "intermediate-frictionless", "intermediate-full-friction", "intermediate-full-friction-line-loads",
        "thick-frictionless", "thick-frictionless-line-loads", "thick-full-friction",
        "thin-frictionless-line-loads"})
    check({{name, {}}});
}

TEST_CASE(
    "both paths: all results of nips, and places of the shear, which has a reversal more on thinner sheets") {
  check({{"intermediate-frictionless",
          {{"wanted", nip_results}, {"sheet.thickness", "1"}},
          {-0.02, 0, 0.01, 0.5}},
         {"intermediate-frictionless", {{"wanted", nip_results}}, {-0.3, -0.02, 0.0, 0.01, 0.05, 0.5}},
         {"intermediate-full-friction", {{"wanted", nip_results}}, {-0.3, -0.02, 0.0, 0.01, 0.05, 0.5}},
         {"viscoelastic-comparable-memory", {{"wanted", nip_results}}, {-0.3, -0.2, -0.03, 0.02, 0.05, 0.1}},
         gripped("0.3"),
         gripped("1.5"),
         gripped("6")});
  for (const auto& [length, zeros] : {std::pair("0.3", 1U), std::pair("1.5", 2U), std::pair("6", 2U)})
    CHECK(verify::solve(scene_of(gripped(length))).profile(data::ResultId::shear_zeros).size() == zeros);
}

TEST_CASE("both paths: stresses inside the sheet, beside the ends and on the faces too") {
  check({stressed("inside-full-friction", "none", "0.1"), stressed("inside-full-friction", "full", "0.1"),
         stressed("inside-full-friction", "full", "5"), stressed("inside-viscoelastic", "none", "0.25")});
}

TEST_CASE("both paths: a contact similar to the body's contours") {
  check(
      {{"half-space-sliding-die-similar",
        {{"wanted",
          R"(["span_along", "span_ratio", "normal_force", "centre_along", "span", "leading_end", "compliance"])"}}}});
}
