#include <nipref/data/scene/file.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>

#include "support/test.hpp"

using namespace nipref;

TEST_CASE("a drawn scene is the same whenever it is drawn, and another for another seed and number") {
  for (const std::uint64_t index : {0U, 4U, 17U}) {
    const std::string text = verify::draw_scene("a", index).toml();
    CHECK(verify::draw_scene("a", index).toml() == text);
    CHECK(verify::draw_scene("b", index).toml() != text);
    CHECK(verify::draw_scene("a", index + verify::drawn_kinds().size()).toml() != text);
  }
}

TEST_CASE("a drawn scene's text is a scene's file: what it says is read back to the last bit") {
  for (std::uint64_t index = 0; index < verify::drawn_kinds().size(); ++index) {
    const verify::DrawnScene drawn = verify::draw_scene("read back", index);
    CAPTURE(drawn.toml());
    const data::Scene scene = data::parse_scene(drawn.toml(), "drawn");
    CHECK(scene.accuracy == drawn.number("accuracy"));
    CHECK(scene.wanted == drawn.wanted());
    CHECK(scene.title.find(verify::drawn_kinds()[index]) == 0);
    if (const auto* nip = std::get_if<data::ElasticNipProblem>(&scene.system)) {
      CHECK(nip->nip.sheet_thickness == drawn.number("sheet.thickness"));
      CHECK(nip->nip.material.poisson == drawn.number("material.poisson"));
    }
    if (const auto* body = std::get_if<data::HalfSpaceProblem>(&scene.system))
      CHECK(std::get<data::Positions>(*body->profile).y == drawn.numbers("profile.positions"));
  }
}

TEST_CASE("scenes are drawn to the ends of their domains, and few are refused") {
  std::map<std::string, std::vector<double>> drawn_of;
  std::set<std::string> models;
  int refused = 0, loads = 0;
  constexpr std::uint64_t kinds[] = {0, 1, 3, 4, 5, 12};
  constexpr int each = 200, count = each * static_cast<int>(std::size(kinds));
  for (int i = 0; i < each; ++i) {
    for (const std::uint64_t kind : kinds) {
      const auto drawn =
          verify::draw_scene("ends", verify::drawn_kinds().size() * static_cast<std::uint64_t>(i) + kind);
      models.insert(drawn.text("material.model"));
      loads += drawn.has("load.per_length") ? 1 : 0;
      for (const char* key : {"accuracy", "material.poisson", "friction.coefficient"}) {
        if (drawn.has(key)) drawn_of[key].push_back(drawn.number(key));
      }
      if (drawn.has("contact.length")) {
        const double length = drawn.number("contact.length");
        drawn_of["ratio"].push_back(length / drawn.number("sheet.thickness"));
        if (drawn.has("material.relaxation_time"))
          drawn_of["memory"].push_back(drawn.number("material.relaxation_time") *
                                       drawn.number("rolling.speed") / length);
      }
      try {
        static_cast<void>(drawn.scene());
      } catch (const data::BadInput&) {
        ++refused;
      }
    }
  }
  CHECK(models ==
        std::set<std::string>{"elastic", "standard-linear-solid", "thesis-misprint", "prony", "operators"});
  CHECK(refused < count / 40);
  CHECK(loads > count / 3);
  CHECK(loads < count * 2 / 3);
  struct Domain {
    const char* key;
    double least, small, large,
        most;  ///< all from `least` to `most`, some below `small` and some above `large`
  };
  for (const auto& [key, least, small, large, most] : {Domain{"accuracy", 1e-13, 2e-13, 5e-3, 0.1},
                                                       {"ratio", 1e-8, 1e-7, 500, 1e3},
                                                       {"friction.coefficient", 1e-7, 1e-5, 2, 5},
                                                       {"material.poisson", -1, -0.999, 0.49999, 0.5},
                                                       {"memory", 0, 1e-6, 1e6, infinite}}) {
    CAPTURE(key);
    const auto [lowest, highest] = std::ranges::minmax(drawn_of.at(key));
    CHECK(lowest >= least);
    CHECK(lowest < small);
    CHECK(highest > large);
    CHECK(highest <= most);
  }
}
