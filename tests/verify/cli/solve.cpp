#include <nlohmann/json.hpp>

#include "support/paths.hpp"
#include "support/run_nipref.hpp"
#include "support/test.hpp"

namespace {

using nlohmann::json;

std::string example(const std::string& name) {
  return "'" + source_directory() + "/data/scenes/" + name + ".toml'";
}

std::set<std::string> keys_of(const json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

}  // namespace

TEST_CASE("solve as JSON: what is wanted with its errors, the work") {
  const json answer = answer_to("solve " + example("intermediate-frictionless"));
  CHECK(keys_of(answer.at("results")) ==
        std::set<std::string>{"contact_length", "indentation", "edge_displacement", "peak_pressure",
                              "creep_ratio", "pressure", "normal_displacement", "tangential_displacement"});
  CHECK(answer["results"]["contact_length"].at("value").is_number());
  CHECK(answer["results"]["contact_length"].at("unit") == "length");
  CHECK(answer["results"]["pressure"].at("value").size() == answer["positions"].size());
  CHECK(answer["results"]["pressure"].at("error").size() == answer["positions"].size());
  CHECK(answer["work"].at("kernel_evaluations").at("I1") > 0);
  CHECK(answer["work"].at("line_responses").is_null());
}

TEST_CASE("a field in JSON is a list for each depth of a number for each position") {
  const json answer =
      answer_to("solve inside-thick-frictionless field.depths=[0,1] field.positions=[0,0.02,0.04]");
  for (const char* part : {"value", "error"}) {
    const json& depths = answer.at("results").at("stress_across").at(part);
    REQUIRE(depths.size() == 2);
    for (const json& depth : depths) CHECK(depth.size() == 3);
  }
  const double middle = answer.at("results").at("stress_across").at("value")[1][0].get<double>();
  CHECK(-middle == doctest::Approx(answer.at("results").at("peak_pressure").at("value").get<double>()));
}

TEST_CASE(
    "solve --full tells the thesis's search for the load: each length by (2.13) from the last, the last load met") {
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
  CHECK(answer_to("solve --full thick-frictionless").at("search").empty());
  CHECK_FALSE(answer_to("solve thick-frictionless-line-loads").contains("search"));
}

TEST_CASE("solve for people names every result with its unit, and the work") {
  const Outcome outcome = run("solve " + example("thick-full-friction"));
  CHECK(outcome.status == 0);
  for (const char* part :
       {"contact_length", "creep_ratio", "peak_shear", "stress", "values of I6", "unknowns"})
    CHECK(contains(outcome.out, part));
}

TEST_CASE("solve by ref gives its numbers as text, with the digits that are asked for") {
  const json answer = answer_to("solve --path ref --digits 40 " + example("thick-frictionless"));
  for (const json& result : answer.at("results")) {
    const auto value = result.at("value").get<std::string>();
    CHECK(value.size() > 40);
    CHECK(std::stod(result.at("error").get<std::string>()) <= 1e-40 * std::stod(value));
    CHECK(result.at("proven") == true);
  }
  const json fast = answer_to("solve " + example("thick-frictionless"));
  CHECK(std::stod(answer["results"]["contact_length"]["value"].get<std::string>()) ==
        doctest::Approx(fast["results"]["contact_length"]["value"].get<double>()).epsilon(1e-12));
}

TEST_CASE("bad calls of solve: status 2, one line, nothing on standard output") {
  const std::string long_name(300, 'a');  // than a file's may be
  check_call_refused("solve " + long_name, "scene = " + long_name);
}

TEST_CASE("a bad scene: status 2, one line with file, line, key and value") {
  const ScratchFile scene("title = \"x\"\n[roller]\nradius = 0\n");
  check_call_refused("solve " + scene.path(), scene.path() + ": wanted = (missing)");
  const ScratchFile two_lines("title = \"x\"\nwanted = [\"load\"]\n\n[material]\nmodel = \"ela\\nstic\"\n");
  check_call_refused("solve " + two_lines.path(), two_lines.path() + ":5: material.model = ela stic: ");
}

TEST_CASE("a load whose contact would be longer than the radius is refused at its line") {
  const ScratchFile scene(
      "title = \"too much\"\nwanted = [\"load\"]\n[roller]\nradius = 1\n[sheet]\nthickness = 1\n[material]\n"
      "model = \"elastic\"\nyoung = 1\npoisson = 0.3\n[load]\nper_length = 10\n[friction]\nmodel = \"none\"\n"
      "[method]\nkind = \"converged\"\n");
  check_call_refused("solve " + scene.path(), scene.path() + ":12: load.per_length = 10: ");
}
