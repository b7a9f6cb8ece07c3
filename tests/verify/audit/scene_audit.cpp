// The audit of random scenes finds the errors of a solver, and none in a solver without errors.
#include <utility>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

using Solution = verify::SceneSolution<fast::Estimate>;
using Change = std::function<void(const data::SceneResult& what, fast::Estimate& number)>;

/// Solvers whose path fast changes every number of its solution.
verify::SceneSolvers with(const Change& change) {
  verify::SceneSolvers solvers;
  solvers.fast = [change](const data::Scene& scene) {
    Solution solution = verify::solve(scene);
    for (auto& result : solution.results) {
      for (fast::Estimate& number : result.numbers) change(*result.what, number);
    }
    return solution;
  };
  return solvers;
}

/// Raises an error estimate by a thousandth of the number, so that it covers every error of the solver itself.
void overstate(const data::SceneResult& what, fast::Estimate& number) {
  number.error += 1e-3 * std::fabs(number.value) + (what.name == "orientation" ? 180 : 0);
}

verify::SceneTally audited(std::uint64_t index, const verify::SceneSolvers& solvers) {
  return verify::audit_scene("planted", index, solvers);
}

bool wants(const data::Scene& scene, data::ResultId id) {
  return std::ranges::find(scene.wanted, id) != scene.wanted.end();
}

/// Scenes of this seed: an elastic nip, which the reference solves too; others with friction, memory, on a half-space.
constexpr std::uint64_t elastic = 39, gripped = 1, rolling_elastic = 2, operators = 31, sphere = 9;

}  // namespace

TEST_CASE("the audit says nothing against estimates that cover everything") {
  for (const std::uint64_t index : {elastic, gripped, rolling_elastic, sphere}) {
    const auto found = audited(index, with(overstate));
    CAPTURE(found.worst.toml, found.worst.where);
    CHECK(found.refused == 0);
    CHECK(found.failed == 0);
    CHECK(found.numbers > 20);
    CHECK(found.uncovered == 0);
    CHECK(found.worst.largest_ratio < 1);
    CHECK(found.miss_unreported == 0);
  }
}

TEST_CASE("an understated estimate is seen, and as missed without saying so, of every kind of contact") {
  for (const std::uint64_t index : {elastic, gripped, operators, sphere}) {
    // Every solution has errors of its own, and understates them.
    int calls = 0;
    const auto found = audited(index, with([&calls](const data::SceneResult&, fast::Estimate& number) {
                                 number.value *= 1 + 0.03 * (++calls % 7);
                                 number.error *= 1e-6;
                               }));
    CAPTURE(found.worst.toml);
    CHECK(found.uncovered > 10);
    CHECK(found.worst.largest_ratio > 100);
    CHECK(found.worst.where != "");
    CHECK(found.miss_unreported > 0);
  }
}

TEST_CASE("one wrong result is seen though all solutions agree: by ref, by the pressure at the peak") {
  struct Planted {
    std::uint64_t scene;
    std::string result;
    double factor, error;  ///< relative to the value
    std::size_t uncovered;
    std::string begins, says;
    double ratio;  ///< 0: any
  };
  for (const Planted& planted :
       {Planted{elastic, "peak_pressure", 1.01, 1e-9, 1, "peak_pressure", "; ref: ", 0},
        {sphere, "compliance", 1.01, 1e-9, 5, "compliance at ", "; ref: ", 0},
        {operators, "peak_pressure", 0.99, 1e-9, 1, "peak_pressure", "; pressure there: ", 0},
        // A NaN is not covered. With an estimate of 0 the error is measured in rounding errors.
        {elastic, "load", std::nan(""), 0, 1, "load", "", infinite},
        {elastic, "load", 1 + 0x1p-36, 0, 1, "load", "", 0x1p17}}) {
    const auto found =
        audited(planted.scene, with([&](const data::SceneResult& what, fast::Estimate& number) {
                  overstate(what, number);
                  if (what.name == planted.result)
                    number = {planted.factor * number.value, planted.error * number.value};
                }));
    CAPTURE(found.worst.where);
    CHECK(found.uncovered == planted.uncovered);
    CHECK(found.worst.where.starts_with(planted.begins));
    CHECK(contains(found.worst.where, planted.says));
    const bool is_so = found.worst.largest_ratio == planted.ratio ||
                       found.worst.largest_ratio == approx(planted.ratio, 0.01);
    CHECK((planted.ratio == 0 || is_so));
  }
}

TEST_CASE("a wrong reference is seen as well, and what is refused or fails is told") {
  verify::SceneSolvers solvers = with(overstate);
  solvers.ref = [](const data::Scene& scene, int digits) {
    auto solution = verify::solve_by_ref(scene, digits);
    mpfr_set_d(nipref::ref::raw(solution.results.front().numbers.front().value), 1e9, MPFR_RNDN);
    return solution;
  };
  CHECK(audited(elastic, solvers).uncovered == 1);
  // A refusal by the reference, for example of a place that it does not reach, is no failure.
  solvers.ref = [](const data::Scene&, int) -> verify::SceneSolution<ref::Estimate> {
    throw data::BadInput("y", "1", "must be nearer");
  };
  const auto alone = audited(elastic, solvers);
  CHECK(alone.failed == 0);
  CHECK(alone.numbers > 0);
  CHECK(alone.uncovered == 0);
  solvers.fast = [](const data::Scene&) -> Solution {
    throw data::BadInput("key", "value", "must be better");
  };
  const auto refused = audited(elastic, solvers);
  CHECK(contains(refused.refusal.refused, "must be better"));
  CHECK(refused.numbers == 0);
  solvers.fast = [](const data::Scene&) -> Solution { throw std::runtime_error("broken"); };
  CHECK(audited(elastic, solvers).failure.failed == "broken");
}

TEST_CASE("a share of the contacts with friction or with a memory is compared with the reference") {
  std::size_t asked = 0;
  for (std::uint64_t n = 0; n < 40; ++n) {
    for (const std::uint64_t kind : {gripped, operators}) {
      verify::SceneSolvers solvers;
      solvers.ref = [&](const data::Scene& scene, int digits) {
        ++asked;
        CHECK(!wants(scene, data::ResultId::greatest_shear));
        return verify::solve_by_ref(scene, digits + 1000);  // refused
      };
      bool solved = false;
      solvers.fast = [&](data::Scene scene) {
        if (std::exchange(solved, true)) throw std::runtime_error("enough");
        scene.accuracy = 1e-2;
        return verify::solve(scene);
      };
      const auto found = verify::audit_scene("share", kind + n * verify::drawn_kinds().size(), solvers);
      CHECK((found.failure.failed == "enough" || found.refused == 1));
    }
  }
  CHECK(asked > 0);
  CHECK(asked < 20);
}

TEST_CASE("how much estimates overstate is known from what is ten times as accurate, not of what is given") {
  // Shears inside that should be 0 are rounding errors, whose relative error is 1.
  const auto found = audited(elastic, with([](const data::SceneResult& what, fast::Estimate& number) {
                               number.value *= 1 + 1e-5;
                               number.error = (what.is_inside() ? 0 : 1e-4) * std::fabs(number.value);
                             }));
  REQUIRE(found.overestimates.count() > 3);
  CHECK(found.overestimates.mean() == doctest::Approx(10).epsilon(0.01));
  CHECK(found.overestimates.percentile(1) == doctest::Approx(10).epsilon(0.01));
}

TEST_CASE("an ellipse that is nearly a circle does not know its orientation at all") {
  // Estimates of 36 degrees each would not cover the 90 degrees between the scene and its mirror image.
  const auto found = verify::audit_scene("ash", 9, {});
  CHECK(verify::solve(data::parse_scene(found.worst.toml, "ash"))[data::ResultId::orientation].error > 45);
  CHECK(found.numbers > 0);
  CHECK(found.uncovered == 0);
}
