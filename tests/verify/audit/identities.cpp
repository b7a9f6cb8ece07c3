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
  std::set<std::string> names;
  for (const auto& [name, variant] : variants) names.insert(name);
  return names;
}

/// Every number of every variant is that of the scene itself, to `part` of it or of the largest of its kind.
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

verify::DrawnScene nip() {
  verify::DrawnScene drawn;
  drawn.set("title", std::string("a nip"));
  drawn.set_wanted({data::ResultId::contact_length, data::ResultId::load, data::ResultId::indentation,
                    data::ResultId::creep_ratio, data::ResultId::peak_pressure, data::ResultId::pressure,
                    data::ResultId::shear, data::ResultId::normal_displacement,
                    data::ResultId::tangential_displacement});
  drawn.set("accuracy", 1e-11);
  drawn.set("roller.radius", 6.0);
  drawn.set("sheet.thickness", 0.25);
  drawn.set("contact.length", 0.5);
  drawn.set("friction.model", std::string("none"));
  drawn.set("method.kind", std::string("converged"));
  drawn.set("profile.positions", std::vector<double>{0, 0.125, -0.1875, 0.375});
  drawn.set("material.model", std::string("elastic"));
  drawn.set("material.young", 3.0);
  drawn.set("material.poisson", 0.3);
  return drawn;
}

verify::DrawnScene die() {
  verify::DrawnScene drawn;
  drawn.set("title", std::string("a die"));
  drawn.set_wanted({data::ResultId::span_along, data::ResultId::span_across, data::ResultId::span_ratio,
                    data::ResultId::normal_force, data::ResultId::peak_pressure, data::ResultId::axis_ratio,
                    data::ResultId::orientation, data::ResultId::approach, data::ResultId::critical_speed,
                    data::ResultId::span, data::ResultId::compliance, data::ResultId::coupling});
  drawn.set("half_space.model", std::string("isotropic"));
  drawn.set("half_space.shear", 3.0);
  drawn.set("half_space.poisson", 0.25);
  drawn.set("half_space.density", 2.0);
  drawn.set("die.radius_along", 1.0);
  drawn.set("die.radius_across", 2.5);
  drawn.set("sliding.speed", 0.5);
  drawn.set("sliding.direction", 30.0);
  drawn.set("contact.span_along", 0.125);
  drawn.set("method.kind", std::string("exact"));
  drawn.set("profile.positions", std::vector<double>{0, 30, -30, 75});
  return drawn;
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
  const auto check_material = [&](const std::map<std::string, verify::DrawnScene::Value>& keys) {
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
