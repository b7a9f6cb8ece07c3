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

/// The calls of bad_calls.txt, each with what its one line must say.
std::vector<std::string> bad_calls() {
  std::ifstream file(source_directory() + "/tests/verify/cli/bad_calls.txt");
  std::vector<std::string> calls;
  for (std::string line; std::getline(file, line);) {
    for (const auto& [name, place] :
         {std::pair<std::string, std::string>{"{kernels}", plugin_file("kernels")},
          {"{program}", program()},
          {"{scenes}", source_directory() + "/data/scenes"}}) {
      if (const std::size_t at = line.find(name); at != std::string::npos)
        line.replace(at, name.size(), place);
    }
    if (line.starts_with(' ')) {
      calls.back() += " " + line.substr(line.find_first_not_of(' '));
    } else if (!line.empty() && !line.starts_with('#')) {
      calls.push_back(line);
    }
  }
  return calls;
}

void check_bad_call(const std::string& call) {
  constexpr std::string_view bar = " | ", either = "{ref,fast}";
  if (const std::size_t at = call.find(either); at != std::string::npos) {
    for (const char* const path : {"ref", "fast"})
      check_bad_call(std::string(call).replace(at, either.size(), path));
    return;
  }
  std::size_t end = call.find(bar);
  const std::string arguments = call.substr(0, end);
  while (end != std::string::npos) {
    const std::size_t begin = end + bar.size();
    end = call.find(bar, begin);
    check_call_refused(arguments, call.substr(begin, end - begin));
  }
}

}  // namespace

TEST_CASE("bad input: status 2, one line that names it, nothing on standard output") {
  check_call_refused("", "verb = (missing)");
  const std::vector<std::string> calls = bad_calls();
  CHECK(calls.size() > 230);
  for (const std::string& call : calls) check_bad_call(call);
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
  const json listed = answer_to("list").at("quantities");
  CHECK(text.status == 0);
  CHECK(listed.size() == nipref::verify::catalogue().size());
  for (const auto& quantity : nipref::verify::catalogue()) CHECK(contains(text.out, quantity.name));
}

TEST_CASE("eval as JSON gives both paths, each with its error") {
  const json answer = answer_to("eval I1 alpha=0.73 --digits 50");
  CHECK(run("eval I1 alpha=0.73 --digits 50 --json").err.empty());
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
    return answer_to("eval I1 alpha=0.73 " + options).at("caveat");
  };
  CHECK(contains(caveat("").get<std::string>(), "nearest double"));
  CHECK(caveat("path=fast") == caveat(""));
  CHECK(caveat("path=ref").is_null());
  CHECK(contains(unfolded(run("eval I1 alpha=0.73").out), caveat("").get<std::string>()));
}

TEST_CASE("an audit looks at the ranges that it is given, in the grammar of sweeps and of grade") {
  const json row = answer_to("audit I6 alpha=3..4:bits eta=2 --points 300 --quiet")["rows"][0];
  CHECK(row.at("points") > 250);
  const double alpha = std::strtod(row["worst"]["alpha"].get<std::string>().c_str(), nullptr);
  CHECK(alpha >= 3);
  CHECK(alpha <= 4);
  CHECK(row["worst"]["eta"] == "0x1p+1");
}

TEST_CASE("options may be written as name=value") {
  const json answer = answer_to("eval I4 eta=0x1p-1 digits=40 path=ref");
  REQUIRE(answer.at("results").size() == 1);
  CHECK(answer["results"].at("ref").at("digits") == 40);
}

TEST_CASE("ref takes the text exactly: 0.1 is not the double nearest to it") {
  const auto value = [](const std::string& alpha) {
    return answer_to("eval I1 alpha=" + alpha + " path=ref digits=40")["results"]["ref"]["value"];
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
    CHECK(contains(ref_says(proven).out, "error bound"));
    CHECK(!contains(ref_says(proven).out, "estimated"));
    CHECK(json::parse(ref_says(proven + " --json").out)["results"]["ref"].at("proven") == true);
  }
  CHECK(contains(ref_says(die).out, "estimated error"));
  CHECK(!contains(ref_says(die).out, "bound"));
  const json estimated = json::parse(ref_says(die + " --json").out)["results"]["ref"];
  CHECK(estimated.at("proven") == false);
  CHECK(std::stod(estimated.at("error").get<std::string>()) <= 1e-20);
}

TEST_CASE("fast's estimated error follows rtol") {
  const auto error = [](const std::string& options) {
    const json answer = answer_to("eval I1 alpha=0.73 path=fast " + options);
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
  CHECK(contains(run("eval nip.load L_over_B=5 poisson=0.3 path=fast rtol=1e-15").out,
                 "accuracy 1e-15 of the scale is missed"));
  CHECK(contains(run("eval I1 alpha=0.73").out, "accuracy 1e-50 of the scale is met"));
  CHECK(!contains(run("eval I1 alpha=0.73 path=fast").out, "accuracy"));
  CHECK(answer_to("eval rolling.span_ratio poisson=0.3 speed=0.6 form=printed")["results"]["printed"]["met"]
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
    const json answer = answer_to("eval " + arguments + " --path ref --digits " + std::to_string(digits)),
               &ref = answer["results"]["ref"];
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
  const json answer = answer_to("eval I1 alpha=0.73 path=fast rtol=1.23456e-5");
  CHECK(answer["results"]["fast"]["error"].get<double>() >= 1.23456e-5 * answer["scale"].get<double>());
}

TEST_CASE("another instruction set of this processor can be asked for, and no other") {
  const Outcome outcome = run("audit I3 points=500 isa=baseline --json");
  CHECK(outcome.status == 0);
  CHECK(json::parse(outcome.out)["nipref"]["instruction_set"] == "baseline");
}

TEST_CASE("audit as JSON says what was promised, and the worst argument exactly") {
  const json answer = answer_to("audit I3 points=500");
  REQUIRE(answer.at("rows").size() == 1);
  const json& row = answer["rows"][0];
  CHECK(row.at("fault_width") == doctest::Approx(3.0 / row.at("points").get<double>()).epsilon(0.01));
  CHECK(row.at("quantity") == "I3");
  CHECK(row.at("passed") == true);
  CHECK(row.at("max_error_ulp").get<double>() <= row.at("promise_ulp").get<double>());
  CHECK(row.at("mean_error_ulp").get<double>() <= row.at("max_error_ulp").get<double>());
  CHECK(contains(row.at("worst").at("alpha").get<std::string>(), "0x"));
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
      CHECK(contains(verify::help_of(option), option.range->least + " to " + option.range->most));
    }
  }
  CHECK(ranges > 10);
}
