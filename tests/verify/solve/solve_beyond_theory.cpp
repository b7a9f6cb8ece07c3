// Nips that cannot exist, and nips that are beyond linear theory, by both paths.
#include <nipref/verify/solve/energy_balance.hpp>

#include "support/solved_scene.hpp"

using namespace nipref;

namespace {

/// A nip with R = 6, B = 2b = 1.5. The parabola alone goes L^2/(8R) into the sheet, which is b at L = 6. The ends of
/// the contact also move inwards.
data::Scene nip_of_length(const std::string& example, double length) {
  data::Scene scene = loaded_example(example, {{"sheet.thickness", "1.5"}, {"wanted", R"(["load"])"}});
  if (auto* const elastic = std::get_if<data::ElasticNipProblem>(&scene.system)) {
    elastic->given = data::GivenLength{length};
  } else {
    std::get<data::ViscoelasticNipProblem>(scene.system).given = data::GivenLength{length};
  }
  return scene;
}

std::map<std::string, double> warned_of(const auto& solution) {
  std::map<std::string, double> values;
  for (const verify::BeyondTheory& one : solution.warnings) {
    CHECK(one.limit == 0.1);
    values.emplace(one.quantity, one.value);
  }
  return values;
}

void check_meeting(const std::string& refusal, const std::string& key) {
  CAPTURE(refusal);
  CHECK(contains(refusal, key));
  CHECK(contains(refusal, "the faces of the rollers would meet"));
}

constexpr int ref_digits = 16;

}  // namespace

TEST_CASE("a nip whose faces would meet is refused, of every kind and by both paths") {
  for (const char* example :
       {"intermediate-frictionless", "intermediate-full-friction", "intermediate-full-friction-line-loads",
        "thick-frictionless-line-loads", "viscoelastic-elastic-limit", "viscoelastic-started"}) {
    CAPTURE(std::string(example));
    const data::Scene meeting = nip_of_length(example, 6), apart = nip_of_length(example, 3);
    check_meeting(refusal_of([&] { return verify::solve(meeting); }), "contact.length = 6");
    check_meeting(refusal_of([&] { return verify::solve_by_ref(meeting, ref_digits); }),
                  "contact.length = 6");
    // A = L/B = 2: the strain is L^2/(8 R b) = 1/4 plus the part of the ends, the slope is L/(2R) = 1/4.
    const auto by_fast = warned_of(verify::solve(apart)),
               by_ref = warned_of(verify::solve_by_ref(apart, ref_digits));
    REQUIRE(by_fast.size() == 2);
    CHECK(by_fast.at("compressive_strain") > 0.25);
    CHECK(by_fast.at("compressive_strain") < 0.4);
    CHECK(by_fast.at("roller_slope") == doctest::Approx(0.25).epsilon(0.02));
    REQUIRE(by_ref.size() == 2);
    for (const auto& [quantity, value] : by_fast)
      CHECK(by_ref.at(quantity) == doctest::Approx(value).epsilon(1e-6));
  }
}

TEST_CASE("a nip whose faces would meet is refused where the load is given, and for its energy balance") {
  // B = 0.25: springs p = 2 u/(N b) under the parabola carry 2.7e5 when the roller goes in by half of the sheet.
  const auto loaded = [](const std::string& example, const std::string& load) {
    return loaded_example(
        example, {{"sheet.thickness", "0.25"}, {"load.per_length", load}, {"wanted", R"(["creep_ratio"])"}});
  };
  for (const char* example :
       {"intermediate-full-friction", "viscoelastic-elastic-limit", "viscoelastic-started"}) {
    CAPTURE(std::string(example));
    check_meeting(refusal_of([&] { return verify::solve(loaded(example, "6e5")); }), "load.per_length = 6e5");
    CHECK(warned_of(verify::solve(loaded(example, "1e5"))).contains("compressive_strain"));
    CHECK(warned_of(verify::solve(loaded(example, "100"))).empty());
  }
  const auto balanced = [&](const char* load) {
    return verify::energy_balance(loaded("viscoelastic-elastic-limit", load));
  };
  check_meeting(refusal_of([&] { return balanced("6e5"); }), "load.per_length = 6e5");
  CHECK(warned_of(balanced("1e5")).size() == 2);
}

TEST_CASE("a steep roller is warned of where the sheet is thick, and a half-space of nothing") {
  // A cylinder on a half-space: W = pi L^2/(8 R N), N = 2 (1 - nu^2)/E; L = 1.8 on a sheet of 50.
  const double young = 1.45e5, poisson = 0.3333333333333333;
  const double load = std::numbers::pi * 1.8 * 1.8 / (8 * 6 * 2 * (1 - poisson * poisson) / young);
  const auto values = warned_of(verify::solve(loaded_example(
      "thick-frictionless", {{"sheet.thickness", "50"}, {"load.per_length", std::to_string(load)}})));
  REQUIRE(values.size() == 1);
  CHECK(values.at("roller_slope") == doctest::Approx(1.8 / 12).epsilon(1e-3));
  CHECK(warned_of(verify::solve(loaded_example("half-space-sliding-die"))).empty());
}
