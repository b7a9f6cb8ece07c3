// The audit of random scenes sees what is wrong with a solver, and nothing where nothing is.
#include <nipref/verify/audit/internal/scene_tally.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

using Solution = verify::SceneSolution<fast::Estimate>;
using Change = std::function<void(const data::SceneResult& what, fast::Estimate& number)>;

/// Solves, and then changes every number.
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

/// Estimates so large that they cover what the solver itself may still lack: a thousandth of everything.
void overstate(const data::SceneResult& what, fast::Estimate& number) {
  number.error += 1e-3 * std::fabs(number.value) + (what.name == "orientation" ? 180 : 0);
}

verify::SceneFindings audited(std::uint64_t index, const verify::SceneSolvers& solvers) {
  return verify::audit_scene("planted", index, solvers);
}

/// Scenes of this seed: an elastic nip that the reference has too, others with friction, memory and on a half-space.
constexpr std::uint64_t elastic = 36, gripped = 1, rolling_elastic = 2, operators = 5, sphere = 9;

}  // namespace

TEST_CASE("the audit says nothing against estimates that cover everything") {
  for (const std::uint64_t index : {elastic, gripped, rolling_elastic, sphere}) {
    const auto found = audited(index, with(overstate));
    CAPTURE(found.toml);
    CAPTURE(found.where);
    CHECK(found.refused == "");
    CHECK(found.failed == "");
    CHECK(found.numbers > 20);
    CHECK(found.uncovered == 0);
    CHECK(found.largest_ratio < 1);
    CHECK(found.miss_unreported == 0);
  }
}

TEST_CASE(
    "a planted understated estimate is seen, with friction, memory and on half-spaces, and as missed without saying so") {
  for (const std::uint64_t index : {elastic, gripped, operators, sphere}) {
    // Every solution is off in its own way, and says that it is not.
    int calls = 0;
    const auto found = audited(index, with([&calls](const data::SceneResult&, fast::Estimate& number) {
                                 number.value *= 1 + 0.03 * (++calls % 7);
                                 number.error *= 1e-6;
                               }));
    CAPTURE(found.toml);
    CHECK(found.uncovered > 10);
    CHECK(found.largest_ratio > 100);
    CHECK(found.where != "");
    CHECK(found.miss_unreported > 0);
  }
}

TEST_CASE("one wrong result of the solver is seen against the reference although all solutions agree") {
  const auto found = audited(elastic, with([](const data::SceneResult& what, fast::Estimate& number) {
                               overstate(what, number);
                               if (what.name == "peak_pressure")
                                 number = {1.01 * number.value, 1e-9 * number.value};
                             }));
  CHECK(found.uncovered == 1);
  CHECK(found.where.find("peak_pressure") == 0);
  CHECK(contains(found.where, "; ref: "));
  const auto line = audited(sphere, with([](const data::SceneResult& what, fast::Estimate& number) {
                              overstate(what, number);
                              if (what.name == "compliance")
                                number = {1.01 * number.value, 1e-9 * number.value};
                            }));
  CHECK(line.uncovered == 5);
  CHECK(line.where.find("compliance at ") == 0);
}

TEST_CASE("a peak that is not the pressure at its place is seen although all solutions agree") {
  const auto found = audited(operators, with([](const data::SceneResult& what, fast::Estimate& number) {
                               overstate(what, number);
                               if (what.name == "peak_pressure")
                                 number = {0.99 * number.value, 1e-9 * number.value};
                             }));
  CHECK(found.uncovered == 1);
  CHECK(contains(found.where, "; pressure there: "));
}

TEST_CASE("what is no number is not covered, and an estimate of 0 is measured by a rounding") {
  const auto none = audited(elastic, with([](const data::SceneResult& what, fast::Estimate& number) {
                              overstate(what, number);
                              if (what.name == "load") number.value = std::nan("");
                            }));
  CHECK(none.uncovered == 1);
  CHECK(std::isinf(none.largest_ratio));
  const auto zero = audited(elastic, with([](const data::SceneResult& what, fast::Estimate& number) {
                              overstate(what, number);
                              if (what.name == "load") number = {number.value * (1 + 0x1p-36), 0};
                            }));
  CHECK(zero.uncovered == 1);
  CHECK(zero.largest_ratio == doctest::Approx(0x1p17).epsilon(0.01));
}

TEST_CASE("a wrong reference is seen as well, and what is refused or fails is told") {
  verify::SceneSolvers solvers = with(overstate);
  solvers.ref = [](const data::Scene& scene, int digits) {
    auto solution = verify::solve_by_ref(scene, digits);
    mpfr_set_d(nipref::ref::raw(solution.results.front().numbers.front().value), 1e9, MPFR_RNDN);
    return solution;
  };
  CHECK(audited(elastic, solvers).uncovered == 1);
  solvers.fast = [](const data::Scene&) -> Solution {
    throw data::BadInput("key", "value", "must be better");
  };
  const auto refused = audited(elastic, solvers);
  CHECK(contains(refused.refused, "must be better"));
  CHECK(refused.numbers == 0);
  solvers.fast = [](const data::Scene&) -> Solution { throw std::runtime_error("broken"); };
  CHECK(audited(elastic, solvers).failed == "broken");
}

TEST_CASE(
    "how much estimates overstate is known from what is ten times as accurate, and not of what is given") {
  const auto found = audited(elastic, with([](const data::SceneResult&, fast::Estimate& number) {
                               number.value *= 1 + 1e-5;
                               number.error = 1e-4 * std::fabs(number.value);
                             }));
  REQUIRE(found.overestimates.size() > 3);
  for (const double overestimate : found.overestimates)
    CHECK(overestimate == doctest::Approx(10).epsilon(0.01));
}

TEST_CASE("an ellipse that is nearly a circle does not know its orientation at all") {
  // Scene and mirror image were 90 degrees apart, with 36 of error each.
  const auto found = verify::audit_scene("unseen-2", 1293, {});
  CHECK(found.numbers > 0);
  CHECK(found.uncovered == 0);
}

TEST_CASE("a place that the reference does not reach is no failure of the audit") {
  // 510 thicknesses outside.
  const auto found = verify::audit_scene("november-22-fifth-1", 3072, {});
  CHECK(found.failed == "");
  CHECK(found.numbers > 0);
  CHECK(found.uncovered == 0);
}
