// What relative accuracies are relative to, and what meeting them means.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/text.hpp>

#include "support/run_nipref.hpp"
#include "support/solved_scene.hpp"
#include "support/test.hpp"
#include "support/unfolded.hpp"

using namespace nipref;
using data::ResultId;

namespace {

/// L = 2, R = 4, pressure 10 in the middle.
double size_of(ResultId id, double y = 0, double accuracy = 1e-6) {
  verify::SolvedContact<fast::Estimate> nip;
  nip.ends = [] { return verify::ContactEnds{-1, 1}; };
  nip.roller_radius = 4;
  nip.set(ResultId::pressure, [](double) { return fast::Estimate{10, 0}; });
  return verify::result_size(nip, id, y, accuracy);
}

/// Of a contact on a half-space whose pressure and span are 2, and its compliance 3.
double size_on_half_space(ResultId id) {
  verify::SolvedContact<fast::Estimate> contact;
  contact.ends = [] { return verify::ContactEnds{-1, 1}; };
  for (const ResultId two : {ResultId::peak_pressure, ResultId::span_along})
    contact.set(two, [] { return fast::Estimate{2, 0}; });
  contact.set(ResultId::compliance, [](double) { return fast::Estimate{3, 0}; });
  return verify::result_size(contact, id, 0, 1e-6);
}

std::string scene(const std::string& friction, double length, double accuracy) {
  return "title = \"thin\"\nwanted = [\"contact_length\", \"load\", \"peak_shear\", \"pressure\"]\naccuracy = " +
         std::to_string(accuracy) + "\n[roller]\nradius = 1e4\n[sheet]\nthickness = 1e-4\n[material]\n" +
         "model = \"elastic\"\nyoung = 1.0\npoisson = 0.3\n[contact]\nlength = " + std::to_string(length) +
         "\n[friction]\nmodel = \"" + friction +
         "\"\n[method]\nkind = \"converged\"\n[profile]\npositions = [0.0]\n";
}

}  // namespace

TEST_CASE("what may be 0 is measured by the size of its kind, everything else by itself") {
  for (const ResultId itself :
       {ResultId::contact_length, ResultId::load, ResultId::indentation, ResultId::peak_pressure})
    CHECK(size_of(itself) == 0);
  for (const ResultId displacement :
       {ResultId::edge_displacement, ResultId::trailing_displacement, ResultId::normal_displacement})
    CHECK(size_of(displacement) == 1.0 / 8);  // (L/2)^2/(2R)
  CHECK(size_of(ResultId::leading_length) == 1);
  CHECK(size_of(ResultId::creep_ratio) == 1.0 / 8);  // L/(4R)
  CHECK(size_of(ResultId::tangential_displacement, 0.5) == 0.5 / 8);
  CHECK(size_of(ResultId::tangential_displacement, -30) == 1.0 / 8);
  CHECK(size_of(ResultId::peak_shear) == 1);
  CHECK(size_of(ResultId::rolling_resistance) == doctest::Approx(1e-8 / 4));
  CHECK(size_of(ResultId::rolling_resistance, 0, 1e-13) == doctest::Approx(0.1 / 4));
  CHECK(size_on_half_space(ResultId::orientation) * std::acos(-1) == doctest::Approx(180));
  CHECK(size_on_half_space(ResultId::coupling) == 3);
  CHECK(size_on_half_space(ResultId::compliance) == 0);
  for (const ResultId two :
       {ResultId::pressure, ResultId::shear, ResultId::centre_along, ResultId::centre_across})
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
  auto solution = solved(scene("none", 1e-3, 1e-6));
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
                 "accuracy 1e-06 is missed by load, pressure: the best there is"));
  const auto results = nlohmann::json::parse(verify::solution_json(solution).text()).at("results");
  CHECK(results["contact_length"]["met"] == true);
  CHECK(results["load"]["met"] == false);
}

TEST_CASE(
    "half-spaces say whether they meet the accuracy, ref its digits, and line loads' errors are not about it") {
  for (const char* name : {"half-space-sliding-die-exact", "half-space-rolling-sphere"}) {
    for (const auto& result : verify::solve(data::load_scene(data::example_scene(name))).results)
      CHECK(result.met() == true);
  }
  for (const char* name : {"thick-frictionless-line-loads", "viscoelastic-thesis-line-loads"}) {
    for (const auto& result : verify::solve(data::load_scene(data::example_scene(name))).results)
      CHECK_FALSE(result.met().has_value());
  }
  auto by_ref = verify::solve_by_ref(data::load_scene(data::example_scene("thick-frictionless")), 40);
  for (const auto& result : by_ref.results) CHECK(result.met() == true);
  mpfr_set_d(nipref::ref::raw(by_ref.results.front().numbers.front().error), 1e-36, MPFR_RNDU);
  CHECK(by_ref.results.front().met() == false);
  CHECK(by_ref.missed().size() == 1);
}

TEST_CASE(
    "an accuracy that is not asked of line loads is not called met, and their errors say what they are about") {
  for (const char* name : {"intermediate-full-friction-line-loads", "thick-frictionless-line-loads",
                           "thin-frictionless-line-loads", "viscoelastic-thesis-line-loads"}) {
    CAPTURE(name);
    const auto solution = verify::solve(data::load_scene(data::example_scene(name)));
    CHECK_FALSE(solution.met().has_value());
    const std::string text =
        unfolded(verify::plain(verify::text_of("solve.txt", verify::solution_json(solution))));
    CHECK(!contains(text, "is met"));
    CHECK(contains(text,
                   "no accuracy is asked of line loads errors are the distance to the continuous contact "));
    CHECK(nlohmann::json::parse(verify::solution_json(solution).text())["distance_to"] ==
          "continuous contact");
  }
  const auto by_ref =
      verify::solve_by_ref(data::load_scene(data::example_scene("thin-frictionless-line-loads")));
  CHECK(by_ref.met() == true);
  CHECK(contains(unfolded(verify::plain(verify::text_of("solve.txt", verify::solution_json(by_ref)))),
                 "accuracy 1e-30 is met errors are the distance to the discrete system "));
  CHECK(nlohmann::json::parse(verify::solution_json(by_ref).text())["distance_to"] == "discrete system");
}

TEST_CASE("what double cannot give is given as well as it can, and the status says so") {
  // Rounding of a gripped sheet as thin as this is far more than what is asked.
  std::string text = scene("full", 0.9, 1e-6);
  const std::string asked = "accuracy = " + std::to_string(1e-6);
  text.replace(text.find(asked), asked.size(), "accuracy = 1e-13");
  const ScratchFile file(text);
  const Outcome outcome = run("solve --json " + file.path());
  CHECK(outcome.status == 1);
  const auto results = nlohmann::json::parse(outcome.out).at("results");
  CHECK(results["contact_length"]["value"] == 0.9);
  CHECK(results["load"]["met"] == false);
  CHECK(results["load"]["error"] < 1e-3 * results["load"]["value"].get<double>());
}

TEST_CASE("what misses the accuracy is the best there is: no smaller accuracy meets what was asked") {
  struct Sweep {
    std::string example, accuracy;
    std::vector<double> loads;
  };
  const std::vector<Sweep> sweeps{
      {"thick-frictionless", "1e-10", {20, 100, 500, 670, 685, 700, 1300}},
      {"thin-full-friction", "1e-8", {5, 100, 190, 196.5, 203, 1000}},
      {"thin-full-friction", "1e-12", {100}},  // missed by rounding
      {"viscoelastic-elastic-limit", "1e-7", {100, 580, 590, 600, 610, 1300}},
      {"viscoelastic-operators", "1e-9", {30, 100, 300}},
  };
  for (const auto& [example, accuracy, loads] : sweeps) {
    CAPTURE(example);
    for (const double load : loads) {
      CAPTURE(load);
      data::Scene scene =
          data::load_scene(data::example_scene(example),
                           {{"load.per_length", fmt::format("{}", load)}, {"accuracy", accuracy}});
      const auto asked = verify::solve(scene);
      if (asked.missed().empty()) continue;
      const double first = scene.accuracy;
      for (const double part : {1e-1, 1e-2, 1e-3}) {
        if (part * first < 1e-13) continue;
        CAPTURE(part);
        scene.accuracy = part * first;
        const auto finer = verify::solve(scene);
        for (std::size_t k = 0; k < asked.results.size(); ++k) {
          CAPTURE(asked.results[k].what->name);
          auto by_finer = asked.results[k];
          by_finer.numbers = finer.results[k].numbers;
          CHECK((by_finer.met() == false || asked.results[k].met() == true));
        }
      }
    }
  }
}
