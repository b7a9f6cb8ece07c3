// What relative accuracies are relative to, and what meeting them means.
#include <nlohmann/json.hpp>

#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/support/text.hpp>

#include "support/solved_scene.hpp"
#include "support/stated_contact.hpp"
#include "support/unfolded.hpp"

using namespace nipref;
using data::ResultId;

namespace {

/// The size of a result of a nip with L = 2, R = 4 and the pressure 10 in the middle.
double size_of(ResultId id, double y = 0, double accuracy = 1e-6) {
  StatedContact<fast::Estimate> nip;
  nip.stated_ends = {-1, 1};
  nip.roller_radius = 4;
  nip.numbers[ResultId::pressure] = [](double) { return fast::Estimate{10, 0}; };
  return verify::result_size(nip, id, y, accuracy);
}

/// The size of a result of a contact on a half-space: pressure and span 2, compliance 3, depth at the centre 7.
double size_on_half_space(ResultId id) {
  StatedContact<fast::Estimate> contact;
  contact.stated_ends = {-1, 1};
  for (const auto& [name, value] : {std::pair(ResultId::peak_pressure, 2.0),
                                    {ResultId::span_along, 2},
                                    {ResultId::normal_displacement, 7},
                                    {ResultId::compliance, 3}})
    contact.numbers[name] = [value](double) { return fast::Estimate{value, 0}; };
  return verify::result_size(contact, id, 0, 1e-6);
}

}  // namespace

TEST_CASE("what may be 0 is measured by the size of its kind, everything else by itself") {
  using enum ResultId;
  const std::map<ResultId, double> sizes{{contact_length, 0},
                                         {load, 0},
                                         {indentation, 0},
                                         {peak_pressure, 0},
                                         {leading_length, 1},
                                         {peak_shear, 1},
                                         {edge_displacement, 1. / 8},
                                         {trailing_displacement, 1. / 8},
                                         {normal_displacement, 1. / 8},  // (L/2)^2/(2R)
                                         {creep_ratio, 1. / 8}};         // L/(4R)
  for (const auto& [result, size] : sizes) CHECK(size_of(result) == size);
  CHECK(size_of(tangential_displacement, 0.5) == 0.5 / 8);
  CHECK(size_of(tangential_displacement, -30) == 1.0 / 8);
  CHECK(size_of(rolling_resistance) == doctest::Approx(1e-8 / 4));
  CHECK(size_of(rolling_resistance, 0, 1e-13) == doctest::Approx(0.1 / 4));
  CHECK(size_on_half_space(orientation) * std::acos(-1) == doctest::Approx(180));
  CHECK(size_on_half_space(coupling) == 3);
  CHECK(size_on_half_space(compliance) == 0);
  for (const ResultId displacement : {normal_displacement, tangential_displacement, transverse_displacement})
    CHECK(size_on_half_space(displacement) == 7);
  for (const ResultId two : {pressure, shear, centre_along, centre_across})
    CHECK(size_on_half_space(two) == 2);
}

TEST_CASE("next to an end a traction may be off by what moving that end by the accuracy changes") {
  const double accuracy = 1e-6;
  const auto semicircle = [](double e) { return e > 0 ? 10 * std::sqrt(e * (2 - e)) : 0; };
  for (const double e : {0.0, 1e-9, 1e-6, 1e-4, 1e-2}) {
    CAPTURE(e);
    const double change = semicircle(e + accuracy) - semicircle(e);
    for (const double y : {1 - e, e - 1})
      CHECK(accuracy * size_of(ResultId::pressure, y, accuracy) == doctest::Approx(change).epsilon(0.01));
    CHECK(size_of(ResultId::shear, 1 - e, accuracy) ==
          doctest::Approx(0.1 * size_of(ResultId::pressure, 1 - e, accuracy)));
  }
  CHECK(size_of(ResultId::pressure, 0) == 10);
}

TEST_CASE("a result meets the accuracy if each of its errors is no larger than it allows") {
  auto solution = verify::solve(loaded_example(
      "thin-given-length", {{"wanted", R"(["contact_length", "load", "peak_shear", "pressure"])"},
                            {"profile.positions", "[0.0]"},
                            {"accuracy", "1e-6"}}));
  REQUIRE(solution.results.size() == 4);
  for (const auto& result : solution.results) CHECK(result.met() == true);
  const fast::Estimate load = solution["load"];
  CHECK(solution.results[1].allowed.front() == doctest::Approx(1e-6 * load.value));
  CHECK(!contains(verify::text_of("solve.txt", verify::solution_json(solution)), "missed"));
  solution.results[1].numbers.front().error = 1.001e-6 * load.value;
  CHECK(solution.results[1].met() == false);
  solution.results[3].numbers.front().error = std::nan("");
  CHECK(solution.results[3].met() == false);
  CHECK(contains(unfolded(verify::plain(verify::text_of("solve.txt", verify::solution_json(solution)))),
                 "accuracy 1e-06 is missed by load, pressure: no better accuracy is possible"));
  const auto results = nlohmann::json::parse(verify::solution_json(solution).text()).at("results");
  CHECK(results["contact_length"]["met"] == true);
  CHECK(results["load"]["met"] == false);
}

TEST_CASE("of line loads no accuracy is asked, and every solution says what its errors are the distance to") {
  const auto check = [](const auto& solution, std::optional<bool> met, const std::string& to,
                        const std::string& says) {
    CHECK(solution.met() == met);
    for (const auto& result : solution.results) CHECK(result.met() == met);
    CHECK(nlohmann::json::parse(verify::solution_json(solution).text())["distance_to"] == to);
    CHECK(contains(unfolded(verify::plain(verify::text_of("solve.txt", verify::solution_json(solution)))),
                   says));
  };
  for (const char* name : {"intermediate-full-friction-line-loads", "viscoelastic-thesis-line-loads"}) {
    const auto solution = verify::solve(loaded_example(name));
    check(solution, {}, "continuous contact",
          "line loads have no accuracy to be met errors are the distance to the continuous contact ");
  }
  check(verify::solve_by_ref(loaded_example("thin-frictionless-line-loads")), true, "discrete system",
        "accuracy 1e-30 is met errors are the distance to the discrete system ");
  CHECK(verify::solve(loaded_example("half-space-rolling-sphere")).met() == true);
  auto by_ref = verify::solve_by_ref(loaded_example("thick-frictionless"), 40);
  CHECK(by_ref.met() == true);
  mpfr_set_d(nipref::ref::raw(by_ref.results.front().numbers.front().error), 1e-36, MPFR_RNDU);
  CHECK(by_ref.results.front().met() == false);
  CHECK(by_ref.missed().size() == 1);
}
