#include <ranges>

#include <nipref/verify/audit/internal/scene_audit.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

using Solution = verify::SceneSolution<fast::Estimate>;

std::map<std::string, verify::Variant> variants_of(const verify::DrawnScene& drawn, const Solution& solved) {
  verify::Random random("a test");
  std::map<std::string, verify::Variant> variants;
  for (auto& variant : verify::variants_of(drawn, solved, random)) variants.emplace(variant.name, variant);
  return variants;
}

std::set<std::string> names_of(const std::map<std::string, verify::Variant>& variants) {
  const auto names = std::views::keys(variants);
  return {names.begin(), names.end()};
}

/// Checks that every number of every variant is that of the scene itself, up to `part` of the largest of its kind.
void check_agree(const verify::DrawnScene& drawn, double part) {
  const Solution solved = verify::solve(drawn.scene());
  for (const auto& [name, variant] : variants_of(drawn, solved)) {
    CAPTURE(name);
    for (const auto& result : verify::solve(variant.scene.scene()).results) {
      CAPTURE(result.what->name);
      const auto& mine = solved.profile(result.what->id);
      double size = 0;
      for (const fast::Estimate& number : mine) size = std::max(size, std::fabs(number.value));
      for (std::size_t i = 0; i < mine.size(); ++i) {
        double difference = variant.back(*result.what, result.numbers[i]).value - mine[i].value;
        if (result.what->id == data::ResultId::orientation) difference = std::remainder(difference, 180);
        CHECK(std::fabs(difference) <= part * size + 1e-300);
      }
    }
  }
}

using Keys = std::map<std::string, verify::DrawnScene::Value>;

verify::DrawnScene drawn_of(const std::vector<data::ResultId>& wanted, const Keys& keys) {
  verify::DrawnScene drawn;
  drawn.set("title", std::string("a test"));
  drawn.set_wanted(wanted);
  for (const auto& [key, value] : keys) drawn.set(key, value);
  return drawn;
}

verify::DrawnScene nip() {
  using enum data::ResultId;
  return drawn_of({contact_length, load, indentation, creep_ratio, peak_pressure, pressure, shear,
                   normal_displacement, tangential_displacement},
                  {{"accuracy", 1e-11},
                   {"roller.radius", 6.0},
                   {"sheet.thickness", 0.25},
                   {"contact.length", 0.5},
                   {"friction.model", "none"},
                   {"method.kind", "converged"},
                   {"material.model", "elastic"},
                   {"material.young", 3.0},
                   {"material.poisson", 0.3},
                   {"profile.positions", std::vector<double>{0, 0.125, -0.1875, 0.375}}});
}

verify::DrawnScene die() {
  using enum data::ResultId;
  return drawn_of({span_along, span_across, span_ratio, normal_force, peak_pressure, axis_ratio, orientation,
                   approach, critical_speed, span, compliance, coupling},
                  {{"half_space.model", "isotropic"},
                   {"half_space.shear", 3.0},
                   {"half_space.poisson", 0.25},
                   {"half_space.density", 2.0},
                   {"die.radius_along", 1.0},
                   {"die.radius_across", 2.5},
                   {"sliding.speed", 0.5},
                   {"sliding.direction", 30.0},
                   {"contact.span_along", 0.125},
                   {"method.kind", "exact"},
                   {"profile.positions", std::vector<double>{0, 30, -30, 75}}});
}

}  // namespace

TEST_CASE("every variant of an elastic nip, with and without friction, is the same contact") {
  verify::DrawnScene drawn = nip();
  CHECK(names_of(variants_of(drawn, verify::solve(drawn.scene()))) ==
        std::set<std::string>{"units", "given back", "mirror"});
  check_agree(drawn, 1e-10);
  drawn.set("friction.model", std::string("full"));
  check_agree(drawn, 1e-9);
  drawn.remove("contact.length");
  drawn.set("load.per_length", 0.0625);
  check_agree(drawn, 1e-9);
}

TEST_CASE("every variant of a rolling nip is the same contact, in each material's own units") {
  verify::DrawnScene drawn = nip();
  drawn.set("rolling.speed", 0.5);
  CHECK(names_of(variants_of(drawn, verify::solve(drawn.scene()))) ==
        std::set<std::string>{"units", "given back", "elastic limit"});
  check_agree(drawn, 1e-9);
  drawn.remove("material.young");
  drawn.remove("material.poisson");
  const auto check_material = [&](const Keys& keys) {
    verify::DrawnScene with_material = drawn;
    for (const auto& [key, value] : keys) with_material.set("material." + key, value);
    CAPTURE(with_material.text("material.model"));
    CHECK(names_of(variants_of(with_material, verify::solve(with_material.scene()))) ==
          std::set<std::string>{"units", "given back"});
    check_agree(with_material, 1e-9);
  };
  check_material(
      {{"model", "standard-linear-solid"}, {"bulk", 3.0}, {"shear", 1.5}, {"relaxation_time", 0.75}});
  check_material({{"model", "prony"},
                  {"theta1_instantaneous", 0.5},
                  {"theta1_amplitudes", std::vector<double>{0.5, 0.25}},
                  {"theta1_rates", std::vector<double>{2, 0.5}},
                  {"theta2_instantaneous", 0.25},
                  {"theta2_amplitudes", std::vector<double>{0.25, 0.125}},
                  {"theta2_rates", std::vector<double>{2, 0.5}}});
  check_material({{"model", "operators"},
                  {"P", std::vector<double>{2, 0.5}},
                  {"Q", std::vector<double>{1, 0.5}},
                  {"P_dilatation", std::vector<double>{1}},
                  {"Q_dilatation", std::vector<double>{3}}});
}

TEST_CASE("every variant of a body on a half-space is the same contact") {
  verify::DrawnScene drawn = die();
  CHECK(names_of(variants_of(drawn, verify::solve(drawn.scene()))) ==
        std::set<std::string>{"units", "given back", "mirror", "turned", "isotropic limit"});
  check_agree(drawn, 1e-10);
  drawn.remove("contact.span_along");
  drawn.set("load.normal_force", 0.0625);
  check_agree(drawn, 1e-10);
}

TEST_CASE("units are changed only where no product is rounded, and by no powers of two") {
  verify::DrawnScene drawn = nip();
  drawn.set("roller.radius", 6.1);
  CHECK_FALSE(variants_of(drawn, verify::solve(drawn.scene())).contains("units"));
  const verify::DrawnScene scaled = variants_of(nip(), verify::solve(nip().scene())).at("units").scene;
  for (const char* key : {"roller.radius", "sheet.thickness", "contact.length"}) {
    const double factor = scaled.number(key) / nip().number(key);
    CHECK(factor >= 9);
    CHECK(std::fmod(factor, 2) == 1);
  }
  CHECK(scaled.number("material.young") / 3 >= 3);
  CHECK(scaled.number("material.poisson") == 0.3);
}
