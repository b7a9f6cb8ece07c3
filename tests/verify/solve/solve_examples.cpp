#include <nipref/data/scene/file.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/paths.hpp"
#include "support/test.hpp"

using namespace nipref;
namespace fs = std::filesystem;

TEST_CASE("the scene in the README is read and solved") {
  const std::string text = text_of_file(source_directory() + "/README.md"), fence = "```toml\n";
  const std::size_t first = text.find(fence) + fence.size();
  const auto solution =
      verify::solve(data::parse_scene(text.substr(first, text.find("```", first) - first), "README"));
  CHECK(solution.profile("pressure").size() == 11);
  CHECK(solution.profile("pressure").front().value > solution.profile("pressure")[9].value);
}

TEST_CASE(
    "every scene in data/scenes is solved, and gives all that it wants with the accuracy that it asks for") {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(source_directory()) / "data/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path().filename().string());
    const data::Scene scene = data::load_scene(entry.path());
    const auto solution = verify::solve(scene);
    ++scenes;
    CHECK(solution.missed().empty());
    // Only rolling spheres need nothing but closed forms.
    const bool counted = solution.work.systems > 0 || solution.work.line_responses > 0;
    const auto* on_half_space = std::get_if<data::HalfSpaceProblem>(&scene.system);
    const bool rolls =
        on_half_space != nullptr && std::holds_alternative<data::RigidRollingSphere>(on_half_space->body);
    CHECK(counted != rolls);
    REQUIRE(solution.results.size() == scene.wanted.size());
    for (const auto& result : solution.results) {
      CAPTURE(std::string(result.what->name));
      const std::size_t places =
          result.what->shape == data::Shape::field ? solution.field.size() : solution.positions.size();
      const bool has_places =
          result.what->shape == data::Shape::profile || result.what->shape == data::Shape::field;
      if (result.what->shape != data::Shape::list) CHECK(result.numbers.size() == (has_places ? places : 1));
      CHECK_FALSE(result.numbers.empty());
      for (const fast::Estimate& number : result.numbers) {
        CHECK(std::isfinite(number.value));
        CHECK(number.error >= 0);
        CHECK(std::isfinite(number.error));
      }
    }
  }
  CHECK(scenes >= 22);
}
