#include <nipref/data/scene/file.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>

#include "support/scratch_file.hpp"
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
    const ScratchFile file(drawn.toml());
    const data::Scene scene = data::load_scene(file.path());
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

TEST_CASE("scenes are drawn to the ends of their domains, and few are none") {
  double least_ratio = 1, largest_ratio = 1, least_accuracy = 1, largest_accuracy = 0;
  double least_poisson = 0, largest_poisson = 0, shortest_memory = 1, longest_memory = 1;
  std::set<std::string> models;
  int refused = 0, loads = 0;
  constexpr int count = 200;
  for (int i = 0; i < count; ++i) {
    for (const std::uint64_t kind : {0U, 1U, 3U, 4U, 5U}) {
      const auto drawn =
          verify::draw_scene("ends", verify::drawn_kinds().size() * static_cast<std::uint64_t>(i) + kind);
      models.insert(drawn.text("material.model"));
      least_accuracy = std::min(least_accuracy, drawn.number("accuracy"));
      largest_accuracy = std::max(largest_accuracy, drawn.number("accuracy"));
      loads += drawn.has("load.per_length") ? 1 : 0;
      if (drawn.has("contact.length")) {
        const double ratio = drawn.number("contact.length") / drawn.number("sheet.thickness");
        least_ratio = std::min(least_ratio, ratio);
        largest_ratio = std::max(largest_ratio, ratio);
        if (drawn.has("material.relaxation_time")) {
          const double length = drawn.number("material.relaxation_time") * drawn.number("rolling.speed") /
                                drawn.number("contact.length");
          shortest_memory = std::min(shortest_memory, length);
          longest_memory = std::max(longest_memory, length);
        }
      }
      if (drawn.has("material.poisson")) {
        least_poisson = std::min(least_poisson, drawn.number("material.poisson"));
        largest_poisson = std::max(largest_poisson, drawn.number("material.poisson"));
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
  CHECK(refused < 5 * count / 40);
  CHECK(loads > 5 * count / 3);
  CHECK(loads < 5 * count * 2 / 3);
  CHECK(least_ratio < 2e-4);
  CHECK(least_ratio >= 1e-4);
  CHECK(largest_ratio > 500);
  CHECK(largest_ratio <= 1e3);
  CHECK(least_accuracy >= 1e-13);
  CHECK(least_accuracy < 2e-13);
  CHECK(largest_accuracy > 5e-3);
  CHECK(least_poisson < -0.88);
  CHECK(largest_poisson > 0.499);
  CHECK(largest_poisson < 0.4999 + 1e-9);
  CHECK(shortest_memory < 1e-6);
  CHECK(longest_memory > 1e6);
}
