#include <nipref/data/scene/file.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/covered.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

data::Scene example(const char* name, const data::SceneOverrides& overrides = {}) {
  return data::load_scene(data::example_scene(name), overrides);
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// Differences are within fast's estimates, the reference's errors beyond them.
void compare_both_paths(const data::Scene& scene) {
  const auto [fast, by_ref] = by_both_paths(scene);
  for (std::size_t k = 0; k < fast.results.size(); ++k) {
    CAPTURE(fast.results[k].what->name);
    CHECK(by_ref.results[k].met().value_or(false));
    for (std::size_t i = 0; i < fast.results[k].numbers.size(); ++i) {
      const fast::Estimate& mine = fast.results[k].numbers[i];
      CHECK(error(by_ref.results[k].numbers[i]) <=
            1e-15 * std::max(std::fabs(mine.value), 0.01 * mine.error * 0x1p52));
    }
  }
}

/// Everything that the example can want, by both paths.
void check_both_paths(data::Scene scene) {
  auto& problem = std::get<data::HalfSpaceProblem>(scene.system);
  problem.profile = data::Positions{{-60, 0, 20, 90}};
  using enum data::ResultId;
  scene.wanted = {span_along,    span_across,    span_ratio,  normal_force, friction_force,
                  peak_pressure, critical_speed, span,        compliance,   coupling,
                  centre_along,  centre_across,  leading_end, trailing_end, peak_on_line};
  if (problem.rule == data::ContourRule::exact)
    scene.wanted.insert(scene.wanted.end(), {axis_ratio, approach, orientation});
  if (std::holds_alternative<data::RigidRollingSphere>(problem.body))
    scene.wanted.insert(scene.wanted.end(), {creep, compressed_radius});
  compare_both_paths(scene);
  // Along a line, where the positions are lengths.
  const double end = verify::solve(scene).profile("leading_end")[2].value;
  problem.line = 20;
  problem.profile = data::Positions{{-2 * end, -0.7 * end, 0, 0.5 * end, 0.99999 * end}};
  scene.wanted = {data::ResultId::pressure, data::ResultId::shear};
  compare_both_paths(scene);
}

}  // namespace

TEST_CASE(
    "the reference solves contacts with a half-space that the examples do not have: a rolling force, an ellipse of given span") {
  auto rolling = example("half-space-rolling-sphere");
  std::get<data::HalfSpaceProblem>(rolling.system).given = data::GivenNormalForce{100};
  check_both_paths(rolling);
  auto exact = example("half-space-near-critical", {{"sliding.direction", "-30"}});
  std::get<data::HalfSpaceProblem>(exact.system).given = data::GivenSpan{1e-4};
  check_both_paths(exact);
}

TEST_CASE("the reference solves contacts with a half-space 1e-9 below its critical speed") {
  auto scene = example("half-space-near-critical");
  auto& problem = std::get<data::HalfSpaceProblem>(scene.system);
  problem.speed = 2922.52532135133 * (1 - 1e-9);
  check_both_paths(scene);
}

TEST_CASE("a sphere whose patch moves in it has its critical speed at rest too") {
  const auto of_sphere = [](const char* speed) {
    auto scene =
        example("half-space-sphere-normal-axis", {{"sphere.shear", "7.72e9"}, {"sliding.speed", speed}});
    scene.wanted = {data::ResultId::critical_speed};
    return number(verify::solve_by_ref(scene, 16).results[0].numbers[0].value_text());
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

TEST_CASE("the reference refuses a half-space's supercritical speed, naming the scene's key") {
  const data::Scene scene = example("half-space-sliding-die", {{"sliding.speed", "2923"}});
  CHECK_THROWS_WITH_AS((void)verify::solve_by_ref(scene, 20), doctest::Contains("sliding.speed = "),
                       data::BadInput);
}
