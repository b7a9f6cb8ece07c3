#include <nlohmann/json.hpp>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/number_text.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"
#include "support/unfolded.hpp"

using namespace nipref;

namespace {

using nlohmann::json;

/// Bad input: what is called, and what the message must name.
struct BadCall {
  const char* arguments;
  const char* name;
  const char* value;
};

constexpr BadCall bad_calls[] = {
    {"", "verb", "missing"},
    {"frobnicate", "verb", "frobnicate"},
    {"eval", "quantity", "missing"},
    {"eval I9 alpha=1", "quantity", "I9"},
    {"eval I1", "alpha", "missing"},
    {"eval I6 alpha=1", "eta", "missing"},
    {"eval I1 alpha=abc", "alpha", "abc"},
    {"eval I1 alpha=", "alpha", ""},
    {"eval I1 alpha=nan", "alpha", "nan"},
    {"eval I1 alpha=inf", "alpha", "inf"},
    {"eval I1 alpha=0", "alpha", "0"},
    {"eval I1 alpha=0 --path ref", "alpha", "0"},
    {"eval I1 alpha=0 --path fast", "alpha", "0"},
    {"eval I1 alpha=1 alpha=2", "alpha", "2"},
    {"eval I1 alpha=1 beta=2", "beta", "2"},
    {"eval I1 I2 alpha=1", "argument", "I2"},
    {"eval I1 alpha=1 digits=5", "digits", "5"},
    {"eval I1 alpha=1 --digits 5", "digits", "5"},
    {"eval I1 alpha=1 digits=100000", "digits", "100000"},
    {"eval I1 alpha=1 digits=many", "digits", "many"},
    {"eval I1 alpha=1 digits=99999999999999999999", "digits", "99999999999999999999"},
    {"eval I1 alpha=1 digits=20 --digits 30", "digits", "20"},
    {"eval I1 alpha=1 rtol=0", "rtol", "0"},
    {"eval I1 alpha=1 rtol=1e-20", "rtol", "1e-20"},
    {"eval I1 alpha=1 rtol=nan", "rtol", "nan"},
    {"eval I1 alpha=1 path=sideways", "path", "sideways"},
    {"eval I1 alpha=1e-400", "alpha", "1e-400"},
    {"eval I1 alpha=1 --frobnicate", "--frobnicate", "eval"},
    {"eval I1 alpha=1 --digits", "--digits", "eval"},
    {"eval root.re n=0", "n", "0"},
    {"eval root.re n=1.5", "n", "must be"},
    {"eval F1 eta=1 poisson=0.6", "poisson", "0.6"},
    {"eval un alpha=1 poisson=0.3 young=-1", "young", "-1"},
    {"eval material.creep_bulk t=0x1.3f0a063a105ccp-6 --digits 40 'material=prony("
     "theta1_amplitudes=[0x1.300815c905b5cp+19, 0x1.63fe6885f1b45p-34], "
     "theta1_rates=[0x1.3e1b6c2b697b5p-3, 0x0p+0], theta2_instantaneous=0x0p+0, "
     "theta2_amplitudes=[0x1.e0e8f69b9cdc6p+51, 0x1.11003698cc0b0p+36], "
     "theta2_rates=[0x1.3e2390eb21848p-3, 0x1.3e1b6c6150b45p-3])'",
     "t = 0.01947260482871176", "must be at most 1.63e-12: the material is unstable"},
    {"audit I9", "quantity", "I9"},
    {"audit contact", "quantity = contact: did you mean contacts?", "or one of contacts"},
    {"audit I1 points=0", "points", "0"},
    {"audit contacts alpha=3", "alpha = 3", "quantities that are named only"},
    {"audit I1 F1 alpha=3..4", "alpha = 3..4", "F1 takes eta, poisson"},
    {"audit I1 alpha=4..3", "alpha = 4..3", "lower end first"},
    {"balance", "scene", "(missing)"},
    {"balance a.toml b.toml", "argument = b.toml", "balance takes one scene"},
    {"balance viscoelastic-operators --digits 20", "digits = 20: has no effect", "path=ref"},
    {"bench I9", "quantity", "I9"},
    {"bench contact", "quantity = contact:", "or one of elastic-nip, viscoelastic-nip, half-space"},
    {"bench rolling", "quantity = rolling:", "viscoelastic-nip"},
    {"list I9", "quantity", "I9"},
    {"list alpha=1", "alpha", "1"},
    {"evla I1 alpha=1", "verb = evla: did you mean eval?", "list, eval, solve"},
    {"I11 alpha=1", "verb = I11: did you mean I1", "list, eval, solve"},
    {"help adit", "verb = adit", "did you mean audit?"},
    {"eval halfspace.complaince poisson=0.3", "quantity", "did you mean halfspace.compliance"},
    {"eval I1 alhpa=1", "alhpa = 1: unknown argument", "did you mean alpha?"},
    {"eval I1 alpha=1 --digts 30", "--digts", "did you mean --digits? eval takes"},
    {"golden check pionts=30", "pionts = 30", "did you mean points?"},
    {"eval I1 alpha=1 --path ref --rtol 1e-3", "rtol = 1e-3: has no effect", "path=ref"},
    {"eval I1 alpha=1 path=fast digits=20", "digits = 20: has no effect", "path=fast"},
    {"eval rolling.span_ratio poisson=0.3 speed=0.1 form=table rtol=1e-3", "rtol = 1e-3: has no effect",
     "form=table"},
    {"solve thick-full-friction digits=40", "digits = 40: has no effect", "path=fast"},
    {"audit contacts rtol=1e-3", "rtol = 1e-3", "has no effect on contacts"},
    {"audit --points 200", "points = 200: must be left out without names", "--density"},
    {"report --points 200", "--points", "report takes --help, --output, --against, --density"},
    {"audit I1 points=1.5", "points = 1.5", "whole number"},
    {"audit I1 --density 0", "density = 0", "1e-6 to 1000"},
    {"audit I1 --density 1e9", "density = 1e9", "1e-6 to 1000"},
    {"audit I1 --quick --density 2", "quick", "must be left out beside density"},
    {"audit I1 --quick --thorough", "thorough", "must be left out beside quick"},
    {"audit I1 --quick points=3", "quick", "must be left out beside points"},
    {"report points=none", "points", "none"},
    {"--frobnicate", "verb", "--frobnicate"},
    // Scenes and files.
    {"solve", "scene = (missing)", "must be the name of a TOML file or of an"},
    {"solve nothing", "scene = nothing", "must be one of the files in "},
    {"solve ./nothing.toml", "must be a file that exists", "there is none of that name"},
    {"solve /tmp", "scene = /tmp", "must be a file: this is a folder"},
    {"solve /dev/null", "/dev/null", "wanted = (missing): must be a list of texts"},
    {"solve thick-frictionless thin-full-friction", "argument = thin-full-friction",
     "unexpected: solve takes one scene and"},
    {"solve thick-frictionles", "scene = thick-frictionles", "did you mean inside-thick-frictionless,"},
    {"solve thick-frictionless load.per_length=", "load.per_length = ", "must be a number"},
    {"solve thick-frictionless load.per_length=-1", "load.per_length = -1", "must be finite and > 0"},
    {"solve thick-frictionless load.per_length=1e400", "load.per_length = 1e400", "must be a number"},
    {"solve thick-frictionless load.per_lenght=1", "load.per_lenght = 1",
     "unknown key: did you mean per_length? known"},
    {"solve thick-frictionless material.poisson=0.6", "material.poisson = 0.6",
     "must satisfy -1 < poisson <= 0.5"},
    {"solve thick-frictionless material.model=rubber", "material.model = rubber",
     "must be elastic or standard-linear-solid or"},
    {"solve thick-frictionless 'wanted=[\"lenght\"]'", "wanted[0] = lenght",
     "must be out of contact_length,"},
    {"solve thick-frictionless 'wanted=[]'", "wanted = []", "must be out of contact_length,"},
    {"solve thick-frictionless wanted=pressure", "wanted = pressure", "must be a list of texts in quotes"},
    {"solve thick-frictionless 'wanted=[\"pressure\"]'", "profile = (missing)",
     "must say where the wanted profiles are"},
    {"solve thick-frictionless 'wanted=[\"pressure\"]' profile.points=0", "profile.points = 0",
     "must be a whole number from 2 to 10000"},
    {"solve thick-frictionless accuracy=1e-20", "accuracy = 1e-20", "must be from 1e-13 to 0.1"},
    {"solve thick-frictionless accuracy=2", "accuracy = 2", "must be from 1e-13 to 0.1"},
    {"solve thick-frictionless contact.length=1", "contact = (beside load)",
     "must be left out, or load: one of the two"},
    {"solve thick-frictionless roller.radius=0", "roller.radius = 0", "must be finite and > 0"},
    {"solve thick-frictionless sheet.thickness=nan", "sheet.thickness = nan", "must be finite and > 0"},
    {"solve thick-frictionless method.kind=guess", "method.kind = guess", "must be converged or line-loads"},
    {"solve thick-frictionless friction.model=some", "friction.model = some", "must be none or full"},
    {"solve thick-frictionless load.per_length=5..1", "load.per_length = 5..1",
     "must have its lower end first"},
    {"solve thick-frictionless load.per_length=1..2:cubic", "load.per_length = 1..2:cubic",
     "must have linear, log or bits after the"},
    {"solve thick-frictionless load.per_length=1..2 --points 0", "points = 0",
     "must be a whole number from 1 to 1e8"},
    {"solve thick-frictionless --points 5", "points = 5", "has no effect without a range: must be left"},
    {"solve thick-frictionless --digits 30", "digits = 30", "has no effect with path=fast: must be left"},
    {"solve thick-frictionless --path ref --digits 400", "digits = 400",
     "must be a whole number from 16 to 300"},
    {"solve thick-frictionless --path both", "path = both", "must be ref or fast"},
    {"solve thick-frictionless load.per_length=1e12", "load.per_length = 1e12",
     "must give an allowed contact length, not"},
    {"solve viscoelastic-operators rolling.speed=0", "rolling.speed = 0", "must be finite and > 0"},
    {"solve viscoelastic-operators 'material.P=[]'", "material.P = []",
     "must have a coefficient that is not 0"},
    {"solve half-space-line half_space.poisson=0.6", "half_space.poisson = 0.6",
     "must satisfy -1 < poisson < 0.5"},
    {"solve half-space-sliding-die sliding.speed=1e9", "sliding.speed = 1e9",
     "must be below 2922.53, where the line along"},
    {"balance thick-frictionless", "rolling = (missing)", "must be there: only a sheet that rolls"},
    {"balance viscoelastic-operators load.per_length=1,2", "load.per_length = 1,2", "must be a number"},
    {"tables XXX", "table = XXX", "must be an id that 'tables --list' shows"},
    {"limits limit.x", "limit = limit.x", "must be one of those that are listed"},
    {"figures thesis-99", "figure = thesis-99", "did you mean thesis-9? must be one of those"},
    {"merge /nonexistent", "run = /nonexistent", "must be a folder with a run.json, as --out"},
    {"points I1 beta=1", "beta = 1", "unknown argument: I1 takes alpha"},
    {"points I1 alpha=2..1", "alpha = 2..1", "must have its lower end first"},
    {"grade /nonexistent.csv", "file = /nonexistent.csv", "must be a file that exists: there is none"},
    {"grade /tmp", "file = /tmp", "must be a file: this is a folder"},
    {"grade - I1 </dev/null", "file = /dev/stdin:1:1", "must name its columns"},
    {"grade ./nothing.so", "plugin = ./nothing.so", "cannot open shared object file: No such"},
    {"grade /bin/ls", "plugin = /bin/ls", "cannot dynamically load"},
    {"grade - I1 --promise 0 </dev/null", "promise = 0", "must be a number > 0"},
    {"golden mkae", "golden = mkae", "must be make, check, update, list or export"},
    {"golden check nothing.csv", "file = nothing.csv", "must be a file that exists: there is none"},
    {"bench I1 --max-slowdown 10%", "max-slowdown = 10%", "must be given with --against"},
    {"bench I1 --against /nonexistent", "against = /nonexistent",
     "must be a nipref whose bench takes the same"},
    {"report extra", "argument = extra", "unexpected: report takes no names"},
    {"report -o /dev/null", "output = /dev/null", "must be a folder, or one that can be made"},
    {"report --against /nonexistent.json", "against = /nonexistent.json",
     "must be a file that exists: there is none"},
    {"I1", "alpha = (missing)", "I1 needs it: must be a finite nonzero number"},
    {"I1 0.73", "argument = 0.73", "unexpected: eval takes one quantity and"},
    {"I1 alpha=1..2:bit", "alpha = 1..2:bit", "must have linear, log or bits after the"},
    {"I1 alpha=1..2 --form table", "form = table", "must be corrected of I1"},
    {"eval Un t=1 T=2 material=rubber", "material = rubber", "must be standard-linear-solid or"},
    {"eval Un t=1 T=2 'material=prony(bulk=1)'", "material = prony(bulk=1)",
     "must be prony(theta1_instantaneous=...,"},
    {"eval Un t=1 T=2 'material=standard-linear-solid(bulk=1'", "material = standard-linear-solid(bulk=1",
     "must be standard-linear-solid(bulk=...,"},
    {"eval Un t=1 T=2 bulk=1", "bulk = 1", "is part of the material:"},
};

}  // namespace

TEST_CASE("bad input: status 2, one line that names it, nothing on standard output") {
  for (const BadCall& call : bad_calls) {
    CAPTURE(call.arguments);
    const Outcome outcome = run(call.arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CAPTURE(outcome.err);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(outcome.err.find(call.name) != std::string::npos);
    CHECK(outcome.err.find(call.value) != std::string::npos);
  }
}

TEST_CASE("a line break in bad input does not break the message") {
  const Outcome outcome = run("eval I1 \"alpha=1\n2\"");
  CHECK(outcome.status == 2);
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
}

TEST_CASE("help is no error") {
  for (const char* arguments : {"--help", "eval --help", "audit --help"}) {
    CAPTURE(arguments);
    const Outcome outcome = run(arguments);
    CHECK(outcome.status == 0);
    CHECK_FALSE(outcome.out.empty());
    CHECK(outcome.err.empty());
  }
}

TEST_CASE("list names the whole catalogue, as text and as JSON") {
  const Outcome text = run("list");
  const json listed = json::parse(run("list --json").out).at("quantities");
  CHECK(text.status == 0);
  CHECK(listed.size() == nipref::verify::catalogue().size());
  for (const auto& quantity : nipref::verify::catalogue())
    CHECK(text.out.find(quantity.name) != std::string::npos);
}

TEST_CASE("eval as JSON gives both paths, each with its error") {
  const Outcome outcome = run("eval I1 alpha=0.73 --digits 50 --json");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const json answer = json::parse(outcome.out);
  CHECK(answer.at("quantity") == "I1");
  CHECK(answer.at("arguments") == json{{"alpha", "0.73"}});
  REQUIRE(answer.at("results").size() == 2);
  const json &ref = answer["results"].at("ref"), &fast = answer["results"].at("fast");
  CHECK(ref.at("proven") == true);
  CHECK(fast.at("proven") == false);
  CHECK(ref.at("digits") == 50);
  CHECK(std::stod(ref.at("error").get<std::string>()) <= 1e-50);
  // The double nearest to 0.73 differs from 0.73 by up to 2^-54, and the slope of I1 there is about -1.
  CHECK(fast.at("value").get<double>() ==
        doctest::Approx(std::stod(ref.at("value").get<std::string>())).epsilon(1e-15));
}

TEST_CASE("eval says, to people and machines, that fast answers for the doubles nearest to its arguments") {
  const auto caveat = [](const std::string& options) {
    return json::parse(run("eval I1 alpha=0.73 " + options + " --json").out).at("caveat");
  };
  CHECK(caveat("").get<std::string>().find("nearest double") != std::string::npos);
  CHECK(caveat("path=fast") == caveat(""));
  CHECK(caveat("path=ref").is_null());
  CHECK(unfolded(run("eval I1 alpha=0.73").out).find(caveat("").get<std::string>()) != std::string::npos);
}

TEST_CASE("an audit looks at the ranges that it is given, in the grammar of sweeps and of grade") {
  const json row =
      json::parse(run("audit I6 alpha=3..4:bits eta=2 --points 300 --quiet --json").out)["rows"][0];
  CHECK(row.at("points") > 250);
  const double alpha = std::strtod(row["worst"]["alpha"].get<std::string>().c_str(), nullptr);
  CHECK(alpha >= 3);
  CHECK(alpha <= 4);
  CHECK(row["worst"]["eta"] == "0x1p+1");
}

TEST_CASE("an audit's random scenes are asked for with contacts only, and counted in whole numbers") {
  check_call_refused("audit I1 scenes=5", "scenes = 5: has an effect on contacts only");
  check_call_refused("audit contacts --scenes 0", "scenes = 0: must be a whole number from 1 to 1000000");
  check_call_refused("audit contacts --scenes 1.5", "scenes = 1.5: must be a whole number");
  check_call_refused("report --scenes 2000000", "scenes = 2000000: must be a whole number");
}

TEST_CASE("options may be written as name=value") {
  const json answer = json::parse(run("eval I4 eta=0x1p-1 digits=40 path=ref --json").out);
  REQUIRE(answer.at("results").size() == 1);
  CHECK(answer["results"].at("ref").at("digits") == 40);
}

TEST_CASE("ref takes the text exactly: 0.1 is not the double nearest to it") {
  const auto value = [](const std::string& alpha) {
    return json::parse(
        run("eval I1 alpha=" + alpha + " path=ref digits=40 --json").out)["results"]["ref"]["value"];
  };
  CHECK(value("0.1") == value("1e-1"));
  CHECK(value("0.1") != value("0x1.999999999999ap-4"));
  CHECK(value("0.5") == value("0x1p-1"));
}

TEST_CASE("eval calls a bound what is proven, and an estimate what is not") {
  const auto ref_says = [](const std::string& arguments) { return run("eval " + arguments + " --path ref"); };
  const std::string kernel = "I1 alpha=0.73",
                    load = "Un t=3 T=2 'material=standard-linear-solid(relaxation_time=0.5)' digits=20",
                    die = "die.exponent poisson=0.3 friction=0.1 speed=0.3 psi_deg=20 digits=20";
  for (const std::string& proven : {kernel, load}) {
    CHECK(ref_says(proven).out.find("error bound") != std::string::npos);
    CHECK(ref_says(proven).out.find("estimated") == std::string::npos);
    CHECK(json::parse(ref_says(proven + " --json").out)["results"]["ref"].at("proven") == true);
  }
  CHECK(ref_says(die).out.find("estimated error") != std::string::npos);
  CHECK(ref_says(die).out.find("bound") == std::string::npos);
  const json estimated = json::parse(ref_says(die + " --json").out)["results"]["ref"];
  CHECK(estimated.at("proven") == false);
  CHECK(std::stod(estimated.at("error").get<std::string>()) <= 1e-20);
}

TEST_CASE("fast's estimated error follows rtol") {
  const auto error = [](const std::string& options) {
    const json answer = json::parse(run("eval I1 alpha=0.73 path=fast --json " + options).out);
    return answer["results"]["fast"]["error"].get<double>();
  };
  CHECK(error("") < 1e-15);
  CHECK(error("rtol=1e-3") > 1e-5);
  CHECK(error("rtol=1e-3") <= 1e-3);
}

TEST_CASE(
    "eval says of an accuracy that was asked whether it is met, with status 1 if not, and nothing of another") {
  const auto met = [](const std::string& options, int status) {
    const Outcome outcome = run("eval nip.load L_over_B=5 poisson=0.3 path=fast --json " + options);
    CHECK(outcome.status == status);
    return json::parse(outcome.out)["results"]["fast"].at("met");
  };
  CHECK(met("rtol=1e-6", 0) == true);
  CHECK(met("rtol=1e-15", 1) == false);  // less than the rounding of what is solved
  CHECK(met("", 0).is_null());
  CHECK(run("eval nip.load L_over_B=5 poisson=0.3 path=fast rtol=1e-15")
            .out.find("accuracy 1e-15 of the scale is missed") != std::string::npos);
  CHECK(run("eval I1 alpha=0.73").out.find("accuracy 1e-50 of the scale is met") != std::string::npos);
  CHECK(run("eval I1 alpha=0.73 path=fast").out.find("accuracy") == std::string::npos);
  CHECK(json::parse(run("eval rolling.span_ratio poisson=0.3 speed=0.6 form=printed --json")
                        .out)["results"]["printed"]["met"]
            .is_null());
}

TEST_CASE("eval by ref has the digits that were asked for, and says so") {
  struct Case {
    std::string arguments;
    int digits;
  };
  for (const auto& [arguments, digits] :
       {Case{"nip.peak_pressure L_over_B=12 poisson=0.3", 20},
        // A long gripped sheet that hardly is compressible: the ends are felt far inside.
        Case{"nip.peak_pressure L_over_B=15.75 poisson=0.499 friction=full", 16},
        Case{"halfspace.condition poisson=0.25 speed=0.5", 50},
        // Nearly elastic: the resistance is as small as the softening, and its digits are of 1/10.
        Case{"rolling_nip.resistance L_over_B=1 memory_over_L=0.1 softening=1.0000001", 16}}) {
    CAPTURE(arguments);
    const Outcome outcome =
        run("eval " + arguments + " --path ref --json --digits " + std::to_string(digits));
    CHECK(outcome.status == 0);
    const json answer = json::parse(outcome.out), &ref = answer["results"]["ref"];
    CHECK(ref.at("met") == true);
    CHECK(std::stod(ref["error"].get<std::string>()) <=
          std::pow(10.0, -digits) * answer["scale"].get<double>());
  }
}

TEST_CASE("an error in two digits is never less than the error") {
  CHECK(verify::upward_text(0) == "0.0e+00");
  CHECK(verify::upward_text(1e-3) == "1.0e-03");
  CHECK(verify::upward_text(1.01e-3) == "1.1e-03");
  CHECK(verify::upward_text(1.99e-3) == "2.0e-03");
  CHECK(verify::upward_text(9.949e-3) == "1.0e-02");
  const json answer = json::parse(run("eval I1 alpha=0.73 path=fast rtol=1.23456e-5 --json").out);
  CHECK(answer["results"]["fast"]["error"].get<double>() >= 1.23456e-5 * answer["scale"].get<double>());
}

TEST_CASE("another instruction set of this processor can be asked for, and no other") {
  const Outcome outcome = run("audit I3 points=500 isa=baseline --json");
  CHECK(outcome.status == 0);
  CHECK(json::parse(outcome.out)["nipref"]["instruction_set"] == "baseline");
  check_call_refused("bench I3 --isa v9", "isa = v9: must be what this processor has: baseline");
}

TEST_CASE("audit as JSON says what was promised, and the worst argument exactly") {
  const Outcome outcome = run("audit I3 points=500 --json");
  CHECK(outcome.status == 0);
  const json answer = json::parse(outcome.out);
  REQUIRE(answer.at("rows").size() == 1);
  const json& row = answer["rows"][0];
  CHECK(row.at("fault_width") == doctest::Approx(3.0 / row.at("points").get<double>()).epsilon(0.01));
  CHECK(row.at("quantity") == "I3");
  CHECK(row.at("passed") == true);
  CHECK(row.at("max_error_ulp").get<double>() <= row.at("promise_ulp").get<double>());
  CHECK(row.at("mean_error_ulp").get<double>() <= row.at("max_error_ulp").get<double>());
  CHECK(row.at("worst").at("alpha").get<std::string>().find("0x") != std::string::npos);
}

TEST_CASE(
    "defaults are in the domains of the table of verbs, and what is beyond a domain is refused by every verb") {
  std::size_t ranges = 0;
  for (const verify::VerbText& verb : verify::verbs()) {
    for (const verify::OptionText& option : verb.options) {
      CAPTURE(verb.name);
      CAPTURE(option.name);
      if (!option.usual.empty()) CHECK_NOTHROW(verify::check_option(option, option.usual));
      if (option.positive) {
        for (const char* const beyond : {"0", "-1", "nan"})
          CHECK_THROWS_AS(verify::check_option(option, beyond), data::BadInput);
      }
      if (!option.range) continue;
      ++ranges;
      CHECK_NOTHROW(verify::check_option(option, option.range->least));
      CHECK_NOTHROW(verify::check_option(option, option.range->most));
      for (const std::string& beyond : {std::string("0"), option.range->most + "9", std::string("nan")}) {
        const std::string assignment = option.name + "=" + beyond;
        const std::array words{"nipref", verb.name.c_str(), assignment.c_str()};
        CHECK_THROWS_AS(static_cast<void>(verify::parse_command_line(3, words.data())), data::BadInput);
      }
      CHECK(verify::help_of(option).find(option.range->least + " to " + option.range->most) !=
            std::string::npos);
    }
  }
  CHECK(ranges > 10);
}
