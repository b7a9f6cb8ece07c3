#include <nlohmann/json.hpp>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/report_parts.hpp>
#include <nipref/verify/replay/replay.hpp>

#include "support/json_schema.hpp"
#include "support/paths.hpp"
#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"
#include "support/test.hpp"

namespace {

using namespace nipref;
using nlohmann::json;

const JsonSchema& answer_schema() {
  static const JsonSchema schema(
      json::parse(std::ifstream(source_directory() + "/data/schema/nipref-1.json")));
  return schema;
}

/// An answer, and which of the schema's definitions is about it.
struct Call {
  std::string arguments;
  std::string definition;
};

std::vector<Call> quick_calls(const std::string& with_profile, const std::string& values,
                              const std::string& baseline) {
  const auto scene = [](const char* name) { return "'" + data::example_scene(name).string() + "'"; };
  return {
      {"list", "list"},
      {"eval I1 alpha=0.73", "eval"},
      {"eval ti.coupling speed=0.2", "eval"},
      {"eval I4 eta=0x1p-1 --path ref", "eval"},
      {"eval rolling.span_ratio poisson=0.3 speed=0.6 form=printed", "eval"},
      {"eval I6 alpha=1.0,2.0 eta=0.1..1 --points 2", "eval_sweep"},
      {"eval rolling.span_ratio poisson=0.3 speed=0.1,0.6 form=printed", "eval_sweep"},
      {"solve " + scene("intermediate-frictionless"), "solve_by_fast"},
      {"solve thick-full-friction load.per_length=50.0,100.0", "solve_sweep"},
      {"solve --path ref --digits 16 thick-frictionless load.per_length=50..100 --points 2", "solve_sweep"},
      {"solve " + scene("thick-full-friction"), "solve_by_fast"},
      {"solve " + scene("thick-frictionless-line-loads"), "solve_by_fast"},
      {"solve " + scene("viscoelastic-short-memory"), "solve_by_fast"},
      {"solve " + scene("inside-full-friction"), "solve_by_fast"},
      {"solve " + scene("half-space-rolling-sphere"), "solve_by_fast"},
      {"solve --path ref --digits 20 " + scene("thick-frictionless"), "solve_by_ref"},
      {"solve --path ref --digits 20 " + with_profile, "solve_by_ref"},
      {"balance " + scene("viscoelastic-operators"), "balance"},
      {"audit I3 root.re points=100", "audit"},
      {"audit ti.span_ratio points=1", "audit"},
      {"audit I3 points=100 rtol=1e-6", "audit"},
      {"points I6 eta=1..2 --points 20", "points"},
      {"grade '" + values + "' I1 --promise 1e17", "grade"},
      {"grade '" + plugin_file("kernels") + "' all_sound --points 100 --against '" + plugin_file("kernels") +
           "' --max-slowdown 1e9",
       "grade"},
      {"grade '" + values + "' I1 --promise 1e17 --update-baseline --baseline '" + baseline + "'", "grade"},
      {"golden check I2 --every 100", "golden_check"},
      {"golden list I2", "golden_list"},
      {"limits limit.hertz.load", "limits"},
      {"claims brock2013-no-root", "claims"},
      {"errata", "errata"},
      {"figures thesis-15", "figures"},
      {"figures --list", "figures_list"},
      {"bench I7", "bench"},
      {"bench root.re --against '" + program() + "'", "bench_against"},
      {"tables thesis-VII thesis-XI brock2013-1", "tables"},
      {"tables --list", "tables_list"},
      {"--version", "version"}};
}

/// Whether `is_so` of a name and its value, at any depth.
bool anywhere(const json& value, const auto& is_so) {
  if (!value.is_structured()) return false;
  for (const auto& [name, item] : value.items()) {
    if (is_so(name, item) || anywhere(item, is_so)) return true;
  }
  return false;
}

bool holds_empty_text(const json& answer) {
  return anywhere(answer, [](const std::string&, const json& item) { return item == ""; });
}

bool holds_times(const json& answer) {
  return anywhere(answer, [](const std::string& name, const json&) { return name == "times"; });
}

std::vector<verify::Replay> replayed_and_corrected() {
  std::vector<verify::Replay> replays;
  for (const char* id : {"thesis-VII", "brock2012-1"}) {
    replays.push_back(verify::replay_table(id));
    verify::correct(replays.back());
  }
  return replays;
}

}  // namespace

TEST_CASE("every verb's answer is as the schema has it") {
  const ScratchFile with_profile(
      "title = \"by ref\"\nwanted = [\"load\", \"pressure\"]\n[roller]\nradius = 6\n[sheet]\nthickness = 1\n"
      "[material]\nmodel = \"elastic\"\nyoung = 1.45e5\npoisson = 0.3\n[contact]\nlength = 0.1\n"
      "[friction]\nmodel = \"none\"\n[method]\nkind = \"converged\"\n[profile]\npoints = 3\n");
  const ScratchFile values(
      "alpha,value\n0.5,0.45361862\n");  // any number: graded with a promise that is wide
  const ScratchFile baseline;
  for (const Call& call : quick_calls(with_profile.path(), values.path(), baseline.path())) {
    CAPTURE(call.arguments);
    const Outcome outcome = run(call.arguments + " --json");
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    const json answer = json::parse(outcome.out);
    CHECK(answer_schema().misfit(answer, call.definition) == "");
    CHECK(answer_schema().misfit(answer) == "");
    CHECK_FALSE(holds_empty_text(answer));
  }
}

TEST_CASE("a report's answer is as the schema has it, its parts as the verbs would answer") {
  const verify::AuditResult kept{&verify::find_quantity("I1"), 10, 0, 2, 0.5, 1e-16, 0.25, {0.73}, {}};
  verify::AuditResult broken = kept;
  broken.max_error_ulp = broken.spread.mean = broken.allowance_used = std::numeric_limits<double>::infinity();
  const verify::ContactAudit contact{"converged, full friction", 30, 0.5, 40, {}, 0.01, 1e-8};
  const verify::BenchReport speed{{{"I1", "alpha in [1e-6,1e-3]", "fast full", 12.5, 0.5, 1e-16, 1},
                                   {"half-space", "all", "contour", 9, {}, {}, {}}},
                                  {{"what", 2, 3}}};
  verify::Report all;
  all.command = "nipref report --json";
  all.seed = "1";
  all.quantities = {kept, broken};
  all.hard_cases = {contact};
  all.speed = speed;
  all.witness = {true, {{0.25, true, 1e-6, 1e-6, 1e-5}}};
  all.tables = replayed_and_corrected();
  all.claims = verify::check_all({verify::claims().back()});
  all.limits = {
      {"limit.none", "W = 0", "nobody", "L/B", 2, {{0.1, {1, 1e-9}, 1.1}, {0.05, {1, 1e-9}, 1.025}}}};
  all.errata = verify::settle_all({verify::formula_errata().front()});
  all.golden = {{{}, {.path = "I1.csv", .quantity = "I1", .rows = 3}}};
  const verify::Json report = verify::report_json(all);
  const json answer = json::parse(verify::answer_text("report", report));
  CHECK(answer_schema().misfit(answer, "report") == "");
  CHECK_FALSE(holds_empty_text(answer));
  for (const std::string part : {"audit", "bench", "tables"}) {
    json as_verb = answer.at(part);
    for (const char* head : {"schema", "nipref"}) as_verb[head] = answer.at(head);
    as_verb["verb"] = part;
    CAPTURE(part);
    CHECK(answer_schema().misfit(as_verb, part) == "");
  }
  const json& rows = answer["audit"]["rows"];
  CHECK(rows[0]["passed"] == true);
  CHECK(rows[0]["allowance_used"] == 0.25);
  CHECK(rows[0]["promise_ulp"] == 2);
  CHECK(rows[1]["passed"] == false);
  for (const char* infinite : {"max_error_ulp", "mean_error_ulp", "allowance_used"})
    CHECK(rows[1].at(infinite).is_null());
  CHECK(answer["seed_errors"][0]["table"] == "thesis-VII");
  CHECK(answer["bench"]["error_ratios"].empty());
  CHECK(answer["bench"]["times"]["ratios"][0] ==
        json{{"what", "what"}, {"ratio", 2.0}, {"wanted", 3.0}, {"met", false}});
  const json timeless = json::parse(verify::answer_text("report", report, true));
  CHECK(answer_schema().misfit(timeless, "report") == "");
  CHECK_FALSE(holds_times(timeless));
}

TEST_CASE("without times an answer is the same each time") {
  for (const char* arguments :
       {"eval I1 alpha=0.73", "audit I3 points=100", "bench I7", "tables thesis-VII --list"}) {
    CAPTURE(arguments);
    const Outcome first = run(std::string(arguments) + " --json --no-times");
    CHECK(first.status == 0);
    CHECK_FALSE(holds_times(json::parse(first.out)));
    CHECK(run(std::string(arguments) + " --json --no-times").out == first.out);
  }
  CHECK(holds_times(answer_to("eval I1 alpha=0.73")));
  const Outcome refused = run("eval I1 alpha=0.73 --no-times");
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, "no-times"));
}

TEST_CASE("with --json an error is an answer too, and its line and status are as ever") {
  struct Refused {
    const char* arguments;
    json argument, value;
  };
  const Refused calls[] = {
      {"eval I9 alpha=1", "quantity", "I9"},    {"eval I1 alpha=0", "alpha", "0"},
      {"frobnicate", "verb", "frobnicate"},     {"audit I1 points=0", "points", "0"},
      {"tables thesis-C", "table", "thesis-C"}, {"solve /nowhere.toml", "scene", "/nowhere.toml"}};
  for (const Refused& call : calls) {
    CAPTURE(call.arguments);
    const Outcome plain = run(call.arguments), outcome = run(std::string(call.arguments) + " --json");
    CHECK(plain.out.empty());
    CHECK(outcome.status == 2);
    CHECK(outcome.err == plain.err);
    const json answer = json::parse(outcome.out);
    CHECK(answer_schema().misfit(answer, "error") == "");
    CHECK(answer["error"]["argument"] == call.argument);
    CHECK(answer["error"]["value"] == call.value);
    CHECK("nipref: " + answer["error"]["message"].get<std::string>() + "\n" == outcome.err);
  }
}

TEST_CASE("an error about bytes that are no text is an answer all the same") {
  const Outcome outcome = run("eval I1 alpha=\xff --json");
  CHECK(outcome.status == 2);
  CHECK(answer_schema().misfit(json::parse(outcome.out), "error") == "");
}

TEST_CASE("--version names version, commit, compiler, libraries and instruction set, as every answer does") {
  const Outcome text = run("--version");
  CHECK(text.status == 0);
  const json program = answer_to("--version").at("nipref");
  CHECK(program == answer_to("list").at("nipref"));
  for (const char* name : {"version", "compiler", "instruction_set"})
    CHECK(contains(text.out, program.at(name).get<std::string>()));
  for (const char* name : {"commit", "commit_date"}) {
    if (program.at(name).is_string()) CHECK(contains(text.out, program[name].get<std::string>()));
  }
  for (const char* library : {"Boost", "GMP", "MPFR", "fmt"})
    CHECK(contains(text.out,
                   std::string(library) + " " + program.at("libraries").at(library).get<std::string>()));
}

TEST_CASE("the schema is what it is checked by: a name more, less or of another kind does not fit") {
  const json good = answer_to("eval I1 alpha=0.73");
  const auto misfit_after = [&](const auto& change) {
    json bad = good;
    change(bad);
    return answer_schema().misfit(bad, "eval");
  };
  CHECK(misfit_after([](json&) {}) == "");
  CHECK(misfit_after([](json& bad) { bad["more"] = 1; }) == "answer.more is not expected");
  CHECK(misfit_after([](json& bad) { bad["schema"] = 2; }) == "answer.schema is not 1");
  CHECK(misfit_after([](json& bad) { bad.erase("arguments"); }) == "answer has no arguments");
  CHECK(misfit_after([](json& bad) { bad["results"]["ref"]["value"] = 0.2; }) ==
        "answer.results.ref.value is no \"string\"");
  CHECK(misfit_after([](json& bad) { bad["results"]["fast"]["value"] = "0.2"; }) ==
        "answer.results.fast.value is no [\"number\",\"null\"]");
  CHECK(answer_schema().misfit(json::object()).starts_with("answer fits none"));
  CHECK_THROWS_AS(JsonSchema(json::parse(R"({"properties":{"x":{"minimum":0}}})")), std::invalid_argument);
  CHECK_THROWS_AS(JsonSchema(json::parse(R"({"anyOf":[{"items":{"oneOf":[]}}]})")), std::invalid_argument);
}
