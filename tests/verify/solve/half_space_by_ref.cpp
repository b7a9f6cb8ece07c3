#include <nipref/data/scene/file.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/reference_values.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

data::Scene example(const char* name, const data::SceneOverrides& overrides = {}) {
  return data::load_scene(data::example_scene(name), overrides);
}

}  // namespace

TEST_CASE("a sphere whose patch moves in it has its critical speed at rest too") {
  const auto of_sphere = [](const char* speed) {
    auto scene =
        example("half-space-sphere-normal-axis", {{"sphere.shear", "7.72e9"}, {"sliding.speed", speed}});
    scene.wanted = {data::ResultId::critical_speed};
    return std::stod(verify::solve_by_ref(scene, 16).results[0].numbers[0].value_text());
  };
  const double shear_waves = std::sqrt(7.72e9 / 7860);
  CHECK(of_sphere("0.0") == of_sphere("500.0"));
  CHECK(of_sphere("0.0") < shear_waves);
}

TEST_CASE("the reference solves for the user's degrees: a direction of 30 is exactly that") {
  // Off by a rounding of 30 degrees in radians the orientation could not be known to 20 digits.
  auto scene = example("half-space-sliding-die-exact", {{"sliding.direction", "30"}});
  scene.wanted = {data::ResultId::orientation};
  const auto ref = verify::solve_by_ref(scene, 20);
  CHECK(std::fabs(std::strtold(ref["orientation"].value_text().c_str(), nullptr) - 30) <= 1e-18L);
}

TEST_CASE("the reference repeats what is given exactly, and proves no critical speed where lines differ") {
  const auto solved = verify::solve_by_ref(example("half-space-sliding-die"), 20);
  CHECK(error(solved["normal_force"]) == 0);
  // 0.3 is not the decimal.
  CHECK(solved["friction_force"].value_text().substr(0, 20) == "299.9999999999999888");
  // Which of the lines is critical first is found by estimates.
  auto anisotropic = example("half-space-anisotropic");
  anisotropic.wanted = {data::ResultId::critical_speed};
  CHECK_FALSE(verify::solve_by_ref(anisotropic, 16)["critical_speed"].proven);
}
