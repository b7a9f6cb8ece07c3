#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <nipref/data/scene/keys.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/support/text.hpp>

#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"
#include "support/test.hpp"
#include "support/unfolded.hpp"

// What is meant is done, and help says what there is.

using nlohmann::json;

TEST_CASE("a quantity's name in the place of a verb means eval") {
  CHECK(answer_to("I1 alpha=0.73").at("arguments") == json{{"alpha", "0.73"}});
}

TEST_CASE("help VERB is VERB --help, and help alone is --help") {
  for (const std::string verb : {"list", "eval", "solve", "balance", "tables", "audit", "bench", "report"}) {
    CAPTURE(verb);
    const Outcome help = run("help " + verb);
    CHECK(help.status == 0);
    CHECK(help.out == run(verb + " --help").out);
    CHECK(contains(help.out, "Usage: nipref " + verb));
  }
  CHECK(run("help").out == run("--help").out);
}

TEST_CASE("each verb's help has what its names are, two examples and the exit statuses") {
  for (const std::string verb : {"list", "eval", "solve", "balance", "tables", "audit", "bench", "report"}) {
    CAPTURE(verb);
    const std::string help = run("help " + verb).out;
    const std::size_t examples = help.find("Examples:\n");
    REQUIRE(examples != std::string::npos);
    const std::string one = "\n  nipref " + verb;
    const std::size_t first = help.find(one, examples);
    REQUIRE(first != std::string::npos);
    CHECK(help.find(one, first + one.size()) != std::string::npos);
    for (const char* status : {"0 all well", "1 a check", "2 bad input", "4 output", "130 interrupted"})
      CHECK(contains(unfolded(help), status));
    if (verb != "report") CHECK(contains(help, "Positionals:"));
  }
}

TEST_CASE("an unknown quantity does not print all names") {
  const std::string message = run("eval I9").err;
  CHECK(contains(message, "quantity = I9: did you mean I1, I2 or I3?"));
  CHECK(contains(message, "nipref list"));
  CHECK_FALSE(contains(message, "ti.span_ratio"));
  CHECK_FALSE(contains(run("eval xyzzyxyzzy").err, "did you mean"));
}

TEST_CASE("a binary file is not shown") {
  const ScratchFile binary(std::string("\x7f\0\x01", 3));
  check_call_refused("solve '" + binary.path() + "'", "syntax = (binary): must be text: this has zero bytes");
}

TEST_CASE(
    "what a row of a sweep is refused for has no comma, which would be one more column to many readers") {
  const Outcome swept = run("solve thick-frictionless 'load.per_length=100, 1e9'");
  CAPTURE(swept.out);
  std::istringstream lines(swept.out);
  std::string header, line;
  std::getline(lines, header);
  CHECK(contains(swept.out, "per_length = 1e9: must give an allowed contact length; not"));
  while (std::getline(lines, line)) CHECK(std::ranges::count(line, ',') == std::ranges::count(header, ','));
}

TEST_CASE("command line: 'help scene' defines every key and every result of scenes") {
  const Outcome text = run("help scene");
  CHECK(text.status == 0);
  const json answer = answer_to("list scene");
  CHECK(answer.at("quantities").empty());
  CHECK(answer.at("keys").size() == nipref::data::scene_keys().size());
  CHECK(answer.at("results").size() == nipref::data::scene_results().size());
  for (const auto* const list : {"keys", "results"}) {
    for (const json& one : answer.at(list)) {
      CAPTURE(one);
      CHECK(contains(text.out, "  " + one.at("name").get<std::string>() + " [" +
                                   one.at("unit").get<std::string>() + "]: "));
      CHECK(!one.at("meaning").get<std::string>().empty());
    }
  }
}

TEST_CASE(
    "list tells what a key of a scene or a result is, and against what the errors of a result are measured") {
  const Outcome length = run("list contact_length");
  CHECK(contains(length.out, "contact_length [length]: full length L of the contact"));
  CHECK_FALSE(contains(length.out, "keys of a scene"));
  CHECK_FALSE(contains(length.out, "I1 ="));
  const json mixed = answer_to("list sheet.thickness creep_ratio I1");
  REQUIRE(mixed.at("keys").size() == 1);
  CHECK(mixed.at("keys")[0].at("meaning") == "full thickness of the sheet");
  REQUIRE(mixed.at("results").size() == 1);
  CHECK(mixed.at("results")[0].at("measured_against") == "L/(4R)");
  CHECK(mixed.at("quantities").size() == 1);
  CHECK(run("list contact_lenght").status == 2);
}

TEST_CASE("list tells all about one quantity, and each quantity's own number of audit points") {
  const Outcome one = run("list I1");
  CHECK(one.status == 0);
  CHECK(contains(one.out, "audit: 20000 points"));
  CHECK(contains(one.out, "alpha must be given: a finite nonzero number"));
  CHECK_FALSE(contains(one.out, "I2 ="));
  CHECK(contains(run("list vs").out, "young ="));
  const json two = answer_to("list I1 ti.span_ratio I1").at("quantities");
  REQUIRE(two.size() == 2);
  CHECK(two[0].at("name") == "I1");
  CHECK(two[0].at("audit_points") == 20000);
  CHECK(two[1].at("audit_points") == nipref::verify::find_quantity("ti.span_ratio").audit_points);
  CHECK(contains(run("list --full").out, "audit: 6 points"));
  CHECK_FALSE(contains(run("list").out, "audit: "));
}

TEST_CASE("the help of audit names the least and the largest number of points of the catalogue") {
  const auto [least, most] =
      std::ranges::minmax(nipref::verify::catalogue(), {}, &nipref::verify::Quantity::audit_points);
  CHECK(contains(run("help audit").out,
                 fmt::format("{} to {}, see list", least.audit_points, most.audit_points)));
}

TEST_CASE("eval tells the scale of its errors, and the unit in the last place of that") {
  const json answer = answer_to("eval I1 alpha=0.73");
  const double scale = answer.at("scale"), ulp = answer.at("ulp_of_scale");
  CHECK(scale >= answer["results"]["fast"]["value"].get<double>());
  CHECK(ulp == std::nextafter(scale, 1e300) - scale);
  const Outcome text = run("eval I1 alpha=0.73 --path ref");
  CHECK(contains(text.out, fmt::format("{}", scale)));
  CHECK(contains(text.out, "one ulp of it is"));
  // Only ref goes where doubles end.
  CHECK(answer_to("eval I1 alpha=1e-400 path=ref").at("scale").is_null());
}

TEST_CASE("tables are found by their numerals, each once, and what could be several is refused with these") {
  const json tables = answer_to("tables --list VII thesis-vii 7 brock2012-1").at("listed");
  REQUIRE(tables.size() == 2);
  CHECK(tables[0].at("id") == "thesis-VII");
  CHECK(tables[1].at("id") == "brock2012-1");
  CHECK(run("tables 3").err == "nipref: table = 3: must be one of thesis-III, brock2013-3\n");
  CHECK(contains(run("tables brock2012").err, "did you mean brock2012-1 or brock2012-2?"));
}

TEST_CASE("an example's name is a scene, unless a file has that name") {
  CHECK(answer_to("solve thick-full-friction").at("results").contains("creep_ratio"));
  const Outcome near = run("solve thick-full-fricton");
  CHECK(near.status == 2);
  CHECK(contains(near.err, "scene = thick-full-fricton: did you mean thick-full-friction"));
}

TEST_CASE("key=value pairs stand for what a scene has, and its title says so") {
  const auto solved = [](const std::string& with) { return answer_to("solve thick-full-friction " + with); };
  const json plain = solved(""), same = solved("load.per_length=100"), more = solved("load.per_length=200");
  const auto length = [](const json& answer) { return answer.at("results").at("contact_length"); };
  CHECK(length(same) == length(plain));
  CHECK(length(more).at("value") > length(plain).at("value"));
  CHECK(contains(more.at("title").get<std::string>(), ", with load.per_length = 200"));
  CHECK(contains(unfolded(run("solve thick-full-friction load.per_length=200").out),
                 ", with load.per_length = 200"));
  CHECK(run("solve thick-full-friction load.per_length=-5e0").err ==
        "nipref: load.per_length = -5e0: must be finite and > 0\n");
}

TEST_CASE("a quantity that is named twice is audited once, and points may be written as 1e2") {
  const json rows = answer_to("audit I3 I3 --points 1e2").at("rows");
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].at("points") > 50);
  CHECK(rows[0].at("points") <= 110);
}

TEST_CASE(
    "a density scales each quantity's own number of points, and the text says what so many points see") {
  const auto points = [](const std::string& options) {
    const json row = answer_to("audit I3 " + options).at("rows").at(0);
    return row.at("points").get<double>();
  };
  CHECK(points("--quick") == points("--points 2000"));
  CHECK(points("--density 0.01") == points("--points 200"));
  CHECK(points("density=1e-6") == 1);
  std::size_t scenes = 0;
  const json contacts = answer_to("audit contacts --density 0.01");
  for (const json& kind : contacts.at("scenes")) scenes += kind.at("scenes").get<std::size_t>();
  CHECK(scenes == 3);
  const std::string few = unfolded(run("audit I3 --points 50").out);
  CHECK(contains(few, "5.3%"));
  CHECK(contains(few, "met with a chance of 95 %"));
}

TEST_CASE("what verbs say to people fits eighty columns, whatever the names, and has no colours in a file") {
  for (const char* words : {"help",
                            "help grade",
                            "help bench",
                            "--version",
                            "list",
                            "list --full",
                            "list Un",
                            "Un t=1 T=0.5",
                            "eval ti.span_ratio speed=0.2 friction=0.1 --digits 16",
                            "solve inside-full-friction --full",
                            "solve half-space-sphere-in-plane-axis",
                            "balance viscoelastic-short-memory",
                            "tables --list",
                            "tables V brock2013-3 --full",
                            "limits limit.hertz.load",
                            "claims brock2012-strip",
                            "errata",
                            "figures --list",
                            "audit ti.span_ratio F1 --quick --quiet",
                            "golden list"}) {
    CAPTURE(words);
    const Outcome outcome = run(words);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == nipref::verify::plain(outcome.out));
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
      if (nipref::verify::width_of(line) > 80) FAIL_CHECK(line);
    }
  }
}
