#include <nipref/data/directory.hpp>

#include "support/run_nipref.hpp"
#include "support/table_rows.hpp"

using nlohmann::json;

namespace {

std::string example() { return text_of_file(nipref::data::example_scene("thick-frictionless")); }

}  // namespace

TEST_CASE("solve --full tells the thesis's search: each length by (2.13), the last load met") {
  struct Search {
    const char* scene;
    double load, tolerance;
  };
  for (const auto& [scene, load, tolerance] :
       {Search{"thick-frictionless-line-loads load.per_length=100", 100, 2e-3},
        Search{"intermediate-full-friction-line-loads", 100, 2e-3},
        Search{"viscoelastic-thesis-line-loads load.per_length=50", 50, 1e-2}}) {
    CAPTURE(scene);
    const json steps = answer_to(std::string("solve --full ") + scene).at("search");
    REQUIRE(steps.size() > 1);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const double excess = steps[i].at("load").get<double>() / load;
      CHECK((std::fabs(excess - 1) <= tolerance) == (i + 1 == steps.size()));
      if (i + 1 == steps.size()) break;
      const double next = steps[i].at("contact_length").get<double>() / std::cbrt(excess);
      CHECK(steps[i + 1].at("contact_length").get<double>() == doctest::Approx(next).epsilon(1e-14));
    }
  }
}

TEST_CASE("a scene's sweep solves each combination as solve does, and no other verb goes through it") {
  const ScratchFile file(example() +
                         "[sweep]\npoints = 3\nfriction.model = [\"none\", \"full\"]\n"
                         "load.per_length = \"25..100:log\"\n");
  const json answer = answer_to("solve " + file.path() + " material.poisson=0.3,0.6", 1),
             columns = answer.at("columns");
  REQUIRE(answer.at("refused").size() == 12);
  for (std::size_t row = 0; row < 12; ++row) {
    CAPTURE(row);
    CHECK(answer["refused"][row].is_null() == (row % 2 == 0));
    CHECK(columns.at("peak_pressure")[row].is_null() == (row % 2 == 1));
    CHECK(columns.at("friction.model")[row] == (row < 6 ? "none" : "full"));
  }
  CHECK(std::stod(columns.at("load.per_length")[4].get<std::string>()) == 100);
  const json length =
      answer_to("solve " + file.path() + " friction.model=full load.per_length=25 material.poisson=0.3")
          .at("results")
          .at("contact_length");
  CHECK(columns.at("contact_length")[6].get<double>() ==
        doctest::Approx(length.at("value").get<double>()).epsilon(1e-14));
  CHECK(run("balance " + file.path()).status == 2);
}

TEST_CASE("profiles and fields of a sweep are lists in JSON, and a row for each number in CSV, not both") {
  const std::string words =
      "solve inside-thick-frictionless load.per_length=50.0,100.0 profile.points=3 "
      "'wanted=[\"contact_length\", \"pressure\", \"stress_across\"]'";
  const json columns = answer_to(words).at("columns");
  const json places = columns.at("field.positions")[1];
  const std::size_t depths = columns.at("field.depths")[1].size();
  REQUIRE(columns.at("stress_across")[1].size() == depths);
  CHECK(columns.at("stress_across_error")[1][0].size() == places.size());
  CHECK(columns.at("pressure")[1].size() == columns.at("positions")[1].size());
  CHECK(columns.at("contact_length")[1].is_number());
  const std::string csv = run(words).out;
  CHECK(contains(csv, "result,depth,position,value,error,missed,warnings,refused\n50.0,"));
  CHECK(std::ranges::count(csv, '\n') == static_cast<long>(1 + 2 * (1 + 3 + depths * places.size())));
  CHECK(contains(csv, ",stress_across,0.999," + places.back().dump() + ","));
  CHECK(run(words + " --csv --json").err == "nipref: csv = (given): must be left out beside --json\n");
}
