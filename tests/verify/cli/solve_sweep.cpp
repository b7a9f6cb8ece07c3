#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"
#include "support/scratch_folder.hpp"
#include "support/test.hpp"

using nlohmann::json;

namespace {

const std::string swept_nip = R"(title = "a nip"
wanted = ["contact_length", "peak_pressure"]
[roller]
radius = 6
[sheet]
thickness = 1.0
[material]
model = "elastic"
young = 1.45e5
poisson = 0.3
[load]
per_length = 50
[friction]
[method]
kind = "converged"
[sweep]
points = 3
friction.model = ["none", "full"]
load.per_length = "25..100:log"
)";

}  // namespace

TEST_CASE("a scene's sweep solves each combination as solve does") {
  const ScratchFile file(swept_nip);
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
}

TEST_CASE("a sweep by ref has its digits, and names what missed the accuracy") {
  const Outcome by_ref = run(
      "solve thick-frictionless load.per_length=50.0,100.0 'wanted=[\"contact_length\"]' --path ref --digits 30 --json");
  REQUIRE(by_ref.status == 0);
  CHECK(json::parse(by_ref.out).at("columns").at("contact_length")[0].get<std::string>().size() > 30);
  const Outcome missed = run(
      "solve thin-full-friction load.per_length=50.0,100.0 accuracy=1e-13 'wanted=[\"contact_length\",\"creep_ratio\"]' "
      "--json");
  CHECK(missed.status == 1);
  CHECK(contains(json::parse(missed.out).at("columns").at("missed")[1].get<std::string>(), "creep_ratio"));
}

TEST_CASE(
    "profiles and fields of a sweep are lists in JSON, and a row for each number with its place in CSV") {
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
}

TEST_CASE("one contact is CSV, too, if that is asked for") {
  CHECK(run("solve thick-frictionless --csv").out.starts_with("contact_length,contact_length_error,"));
  CHECK(run("solve thick-frictionless --csv --json").err ==
        "nipref: csv = (given): must be left out beside --json\n");
}

TEST_CASE("a scene is read from a pipe, which can be read once only") {
  const ScratchFile file(swept_nip);
  const std::string swept = run("solve " + file.path()).out;
  const ScratchFolder folder;
  const std::string pipe = (folder.path() / "pipe").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  // What would wait for a second writer is ended.
  CHECK(run("solve " + pipe + " & solved=$!; cat " + file.path() + " >" + pipe +
            "; (sleep 30; kill $solved) >/dev/null 2>&1 & wait $solved")
            .out == swept);
}

TEST_CASE("a sweep's rows say what of each nip is beyond linear theory, and which cannot be") {
  // In half of 0.005: the parabola goes in L^2/(8R), 0.0001, 0.0019 and 0.0026.
  const json answer =
                 answer_to("solve thin-given-length contact.length=0.07,0.3,0.35 'wanted=[\"load\"]'", 1),
             warnings = answer.at("columns").at("warnings");
  CHECK(warnings[0].is_null());
  CHECK(warnings[1] == "compressive_strain");
  CHECK(warnings[2].is_null());
  CHECK(answer.at("refused")[1].is_null());
  CHECK(contains(answer.at("refused")[2].get<std::string>(), "the faces of the rollers would meet"));
}

TEST_CASE("sweeps where one contact is asked for are refused") {
  CHECK(run("solve thick-full-friction --points 3").status == 2);
  const ScratchFile file(swept_nip);
  CHECK(run("balance " + file.path()).status == 2);
}
