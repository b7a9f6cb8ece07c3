#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/partial_slip/line_loads.hpp>

#include "support/solved_scene.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using fast::Estimate;
using test::quarter_inch_nip;

namespace {

constexpr double asked_accuracy = 1e-9;

data::ElasticNipProblem line_load_problem(data::Friction friction, int elements) {
  data::ElasticNipProblem problem = quarter_inch_problem(friction);
  problem.method = data::LineLoads{elements, elements};
  return problem;
}

data::Scene scene_of(const auto& problem, const std::vector<data::ResultId>& wanted) {
  return scene_wanting(problem, wanted, asked_accuracy);
}

void check_is(const verify::SceneSolution<Estimate>& solution, const fast::LineLoadNip& expected) {
  check_names(solution, expected, [](const Estimate& found, double value) {
    CHECK(found.value == doctest::Approx(value).epsilon(1e-9));
  });
}

/// The first kernel that the work counts although it is not allowed; 0 if there is none.
int first_kernel_beside(const fast::Work& work, const std::vector<int>& allowed) {
  for (int kernel = 1; kernel <= 7; ++kernel) {
    const bool counted = work.kernel_evaluations[static_cast<std::size_t>(kernel - 1)] > 0;
    if (counted && std::ranges::find(allowed, kernel) == allowed.end()) return kernel;
  }
  return 0;
}

}  // namespace

TEST_CASE("each name of a line-load scene is the solver's result of that name") {
  const fast::LineLoadMethod method(4, 0, fast::Accuracy(asked_accuracy));
  data::ElasticNipProblem problem = line_load_problem(data::Friction::none, 4);
  check_is(verify::solve(scene_of(problem, all_results())),
           fast::line_loads_for_load(quarter_inch_nip, method, 100));
  problem.given = data::GivenLength{0.2};
  check_is(verify::solve(scene_of(problem, all_results())),
           fast::line_loads_for_length(quarter_inch_nip, method, 0.2));

  problem.friction = data::Friction::full;
  problem.creep_ratio = 1e-4;
  const auto friction = data::LineLoadFriction::full(1e-4);
  check_is(verify::solve(scene_of(problem, all_results())),
           fast::line_loads_for_length(quarter_inch_nip, method, 0.2, friction));
  problem.given = data::GivenLoad{100};
  check_is(verify::solve(scene_of(problem, all_results())),
           fast::line_loads_for_load(quarter_inch_nip, method, 100, friction));
}

TEST_CASE("without a creep ratio line loads with friction take the thesis's, and carry the load") {
  using enum data::ResultId;
  const fast::LineLoadMethod method(3, 0, fast::Accuracy(asked_accuracy));
  const auto solution = verify::solve(scene_of(line_load_problem(data::Friction::full, 3), all_results()));
  CHECK(solution[load].value == doctest::Approx(100).epsilon(1e-9));
  check_is(solution, fast::line_loads_for_length(quarter_inch_nip, method, solution[contact_length].value,
                                                 {data::LineLoadFriction::Kind::thesis_creep}));
  const auto range =
      verify::solve(scene_of(line_load_problem(data::Friction::full, 3), {creep_range})).profile(creep_range);
  REQUIRE(range.size() == 3);
  CHECK(range[0].value < range[1].value);
  CHECK(range[2].value == solution[creep_ratio].value);
}

TEST_CASE("each name of a scene of line loads with Coulomb's friction is the solver's result of that name") {
  using enum data::ResultId;
  const data::PartialSlipNip nip{quarter_inch_nip, 0.1, data::GivenTraction{5}};
  const data::PartialSlipProblem problem{.nip = nip,
                                         .given = data::GivenLoad{100},
                                         .method = data::LineLoads{10, 10},
                                         .profile = data::Positions{{-0.2, -0.03, 0.0, 0.01, 0.2}}};
  std::vector<data::ResultId> wanted = all_results();
  std::erase(wanted, power_loss);
  for (const data::ResultId id : {traction, dissipation, zone_boundaries, zone_signs}) wanted.push_back(id);
  const auto solution = verify::solve(scene_of(problem, wanted));
  const auto expected = fast::line_loads_for_load(nip, 10, 100);
  check_is(solution, expected);
  CHECK(solution[traction].value == approx(5, 1e-12));
  CHECK(solution[dissipation].value == expected.dissipation());
  const auto boundaries = solution.profile(zone_boundaries), signs = solution.profile(zone_signs);
  REQUIRE(boundaries.size() == expected.zone_boundaries.size());
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    CHECK(boundaries[k].value == expected.zone_boundaries[k]);
    CHECK(boundaries[k].error < expected.element_width());
  }
  REQUIRE(signs.size() == expected.zone_signs.size());
  for (std::size_t k = 0; k < signs.size(); ++k) CHECK(signs[k].value == expected.zone_signs[k]);
}

TEST_CASE("the error estimate of line loads is their distance to the continuous contact, and at least that") {
  for (const data::Friction friction : {data::Friction::none, data::Friction::full}) {
    const data::ElasticNipProblem problem = line_load_problem(friction, 3);
    const auto loads = verify::solve(scene_of(problem, all_results()));
    const auto truth = verify::solve(scene_of(quarter_inch_problem(friction), all_results()));
    for (std::size_t r = 0; r < loads.results.size(); ++r) {
      CAPTURE(std::string(loads.results[r].what->name));
      for (std::size_t i = 0; i < loads.results[r].numbers.size(); ++i) {
        const Estimate& number = loads.results[r].numbers[i];
        const double distance = std::fabs(number.value - truth.results[r].numbers[i].value);
        CHECK(number.error >= distance * (1 - 1e-6));
        CHECK(number.error <= distance + 1e-3 * std::fabs(truth.results[r].numbers[i].value) + 1e-3);
      }
    }
  }
}

TEST_CASE("line loads evaluate only the kernels that what is wanted needs, and so do their error estimates") {
  const auto work_of = [](data::Friction friction, const std::vector<data::ResultId>& wanted) {
    const auto solution = verify::solve(scene_of(line_load_problem(friction, 3), wanted));
    CHECK(solution.work.kernel_evaluations[0] > 0);
    CHECK(solution.error_work.kernel_evaluations[0] > 0);
    fast::Work both = solution.work;
    both += solution.error_work;
    return both;
  };
  using enum data::ResultId;
  const std::vector normal{contact_length, load,     indentation, edge_displacement,
                           peak_pressure,  pressure, shear,       normal_displacement};
  CHECK(first_kernel_beside(work_of(data::Friction::none, normal), {1}) == 0);
  CHECK(first_kernel_beside(work_of(data::Friction::none, all_results()), {1, 3}) == 0);
  CHECK(first_kernel_beside(work_of(data::Friction::none, {data::ResultId::creep_ratio}), {1}) == 3);
  CHECK(first_kernel_beside(work_of(data::Friction::full, normal), {1, 3, 6}) == 0);
}

TEST_CASE("a displacement wanted at a line load is refused by its position") {
  data::ElasticNipProblem problem = line_load_problem(data::Friction::none, 1);
  problem.given = data::GivenLength{0.5};
  problem.profile = data::Positions{{0.0, 0.125}};
  CHECK_REFUSED(verify::solve(scene_of(problem, {data::ResultId::normal_displacement})),
                "profile.positions[1] = 0.125: must not be the place of a line load");
  CHECK_NOTHROW((void)verify::solve(scene_of(problem, {data::ResultId::pressure})));
}
