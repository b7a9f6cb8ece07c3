#include <nipref/data/scene/keys.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/text.hpp>

#include "support/json_schema.hpp"
#include "support/run_nipref.hpp"
#include "support/table_rows.hpp"
#include "support/unfolded.hpp"

using namespace nipref;
namespace fs = std::filesystem;

namespace {

using nlohmann::json;

/// A line of a file of calls: a call, and the claims about its answer behind the bars.
struct TabledCall {
  std::string call;
  std::vector<std::string> claims;
};

/// The calls in a file of this folder.
std::vector<TabledCall> tabled_calls(const std::string& name) {
  const std::map<std::string, std::string> places{{"{kernels}", plugin_file("kernels")},
                                                  {"{slower}", plugin_file("slower")},
                                                  {"{program}", program()},
                                                  {"{data}", source_directory() + "/data"}};
  std::vector<TabledCall> calls;
  for (std::vector<std::string> row : table_rows("verify/cli/" + name)) {
    for (std::string& part : row) {
      for (const auto& [word, place] : places) part = replaced_in(part, word, place);
    }
    calls.push_back({row.front(), {row.begin() + 1, row.end()}});
  }
  return calls;
}

void check_bad_call(const TabledCall& bad) {
  constexpr std::string_view either = "{ref,fast}";
  if (const std::size_t at = bad.call.find(either); at != std::string::npos) {
    for (const char* const path : {"ref", "fast"})
      check_bad_call({std::string(bad.call).replace(at, either.size(), path), bad.claims});
    return;
  }
  const std::string err = refusal_of_call(bad.call);
  for (const std::string& words : bad.claims) {
    CAPTURE(words);
    CHECK(contains(err, words.substr(words.starts_with('!'))) != words.starts_with('!'));
  }
}

/// Makes a call, which must end with this status, and returns its output.
using Answered = std::function<std::string(const std::string& call, int status)>;

/// Makes each call once and keeps its output.
std::string answered_once(const std::string& call, int status) {
  static std::map<std::string, std::string> all;
  const auto known = all.find(call);
  if (known != all.end()) return known->second;
  CAPTURE(call);
  const Outcome outcome = outcome_of_call(call);
  CHECK(outcome.status == status);
  CHECK(outcome.err.empty());
  return all.emplace(call, outcome.out).first->second;
}

json member_of(const json& answer, const std::string& pointer) {
  const json::json_pointer place(pointer);
  return answer.contains(place) ? answer.at(place) : json("(absent)");
}

double number_in(const json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

/// Whether a claim of the form /NAME/NAME RELATION WANTED holds; answers.txt describes claims.
bool holds(const json& answer, const std::string& claim, const Answered& answered) {
  std::istringstream words(claim);
  std::string pointer, relation, wanted;
  words >> pointer >> relation >> std::ws;
  std::getline(words, wanted);
  const json found = member_of(answer, pointer);
  if (relation == "as" || relation == "unlike")
    return (found == member_of(json::parse(answered(wanted + " --json", 0)), pointer)) == (relation == "as");
  if (relation == "has") return contains(found.get<std::string>(), wanted);
  const std::size_t tolerance = wanted.find(" +- ");
  const std::string text = wanted.substr(0, tolerance);
  const json other = text.starts_with('/') ? member_of(answer, text) : json::parse(text);
  if (relation == "=") return found == other;
  if (relation == "size") return found.size() == other;
  const double x = number_in(found), y = number_in(other);
  if (relation == "~") return std::fabs(x - y) <= std::stod(wanted.substr(tolerance + 4));
  const std::map<std::string, bool> orders{{"<", x < y}, {"<=", x <= y}, {">", x > y}, {">=", x >= y}};
  return orders.at(relation);
}

void check_fits(const std::string& text) {
  CHECK(text == verify::plain(text));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (verify::width_of(line) > 80) FAIL_CHECK(line);
  }
}

void check_schema(const json& answer, const std::string& definition) {
  CHECK(answer_schema().misfit(answer, definition) == "");
  CHECK(answer_schema().misfit(answer) == "");
  CHECK_FALSE(holds_anywhere(answer, [](const std::string&, const json& item) { return item == ""; }));
}

void check_answer(const TabledCall& tabled, const Answered& answered) {
  int status = 0;
  for (const std::string& claim : tabled.claims) {
    CAPTURE(tabled.call, claim);
    const auto text = [&] { return answered(tabled.call, status); };
    const auto in_json = [&] { return json::parse(answered(tabled.call + " --json", status)); };
    if (claim.starts_with("status ")) {
      status = std::stoi(claim.substr(7));
    } else if (claim.starts_with('/')) {
      CHECK(holds(in_json(), claim, answered));
    } else if (claim.starts_with("schema ")) {
      check_schema(in_json(), claim.substr(7));
    } else if (claim == "fits") {
      check_fits(text());
    } else if (claim.starts_with("is ")) {
      CHECK(text() == answered(claim.substr(3), 0));
    } else {
      CHECK(contains(unfolded(text()), claim.substr(claim.starts_with('!'))) != claim.starts_with('!'));
    }
  }
}

/// Checks the lines of a file of sessions. Each session has a folder of its own.
void check_sessions(const std::string& name) {
  std::optional<ScratchFolder> folder;
  std::string title, start;
  for (TabledCall& line : tabled_calls(name)) {
    if (line.call.starts_with("== ")) {
      title = line.call;
      start = "cd '" + folder.emplace().path().string() + "'; nipref() { '" + program() + "' \"$@\"; }; ";
      continue;
    }
    constexpr std::string_view always = "always ";
    if (line.call.starts_with(always)) {
      start += line.call.substr(always.size()) + "; ";
      continue;
    }
    CAPTURE(title);
    std::map<std::string, std::string> known;  // outputs by call: no call is made again for another claim
    if (line.claims.empty() || line.claims == std::vector<std::string>{"status 1"})
      line.claims.emplace_back("");
    check_answer(line, [&](const std::string& call, int status) {
      const auto [text, is_new] = known.try_emplace(call);
      if (!is_new) return text->second;
      const Outcome outcome = outcome_in_shell(start + call);
      CAPTURE(outcome.out, outcome.err);
      CHECK(outcome.status == status);
      CHECK((status < 2 ? outcome.err : outcome.out) == "");
      return text->second = status < 2 ? outcome.out : outcome.err;
    });
  }
}

/// The README's calls of the program, without the remarks behind them.
std::vector<std::string> commands() {
  std::ifstream readme(fs::path(source_directory()) / "README.md");
  std::vector<std::string> found;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("    nipref ")) found.push_back(line.substr(11, line.find(" #") - 11));
  }
  return found;
}

}  // namespace

TEST_CASE("bad input gives status 2, one line that names it, and nothing on standard output") {
  check_call_refused("", "verb = (missing)");
  check_call_refused("eval I1 \"alpha=1\n2\"", "alpha = 1 2");
  const std::string long_name(300, 'a');  // longer than a file's name may be
  check_call_refused("solve " + long_name, "scene = " + long_name);
  const std::vector<TabledCall> calls = tabled_calls("bad_calls.txt");
  CHECK(calls.size() > 230);
  for (const TabledCall& bad : calls) check_bad_call(bad);
}

TEST_CASE("calls are answered with the words, the members of JSON and the status of answers.txt") {
  const std::vector<TabledCall> calls = tabled_calls("answers.txt");
  CHECK(calls.size() > 90);
  for (const TabledCall& tabled : calls) check_answer(tabled, answered_once);
}

TEST_CASE("calls that follow each other make, keep, change and refuse files as sessions.txt says") {
  check_sessions("sessions.txt");
}

TEST_CASE("list names the whole catalogue, 'help scene' all keys and results with unit and meaning") {
  const json listed = answer_to("list").at("quantities"), answer = answer_to("list scene");
  const std::string all = run("list").out, of_scenes = run("help scene").out;
  CHECK(listed.size() == verify::catalogue().size());
  for (const verify::Quantity& quantity : verify::catalogue()) CHECK(contains(all, quantity.name));
  CHECK(answer.at("keys").size() == data::scene_keys().size());
  CHECK(answer.at("results").size() == data::scene_results().size());
  for (const auto* const list : {"keys", "results"}) {
    for (const json& one : answer.at(list)) {
      CAPTURE(one);
      CHECK(contains(of_scenes, "  " + one.at("name").get<std::string>() + " [" +
                                    one.at("unit").get<std::string>() + "]: "));
      CHECK(!one.at("meaning").get<std::string>().empty());
    }
  }
}

TEST_CASE("each verb's help has what its names are, two examples and the exit statuses") {
  for (const std::string verb : {"list", "eval", "solve", "balance", "tables", "audit", "bench", "report"}) {
    CAPTURE(verb);
    const std::string help = run("help " + verb).out, one = "\n  nipref " + verb;
    CHECK(help == run(verb + " --help").out);
    CHECK(contains(help, "Usage: nipref " + verb));
    const std::size_t first = help.find(one, help.find("Examples:\n"));
    REQUIRE(first != std::string::npos);
    CHECK(help.find(one, first + one.size()) != std::string::npos);
    for (const char* status : {"0 success", "1 a check", "2 bad input", "4 output", "130 interrupted"})
      CHECK(contains(unfolded(help), status));
    if (verb != "report") CHECK(contains(help, "Positionals:"));
  }
  const auto [least, most] = std::ranges::minmax(verify::catalogue(), {}, &verify::Quantity::audit_points);
  CHECK(contains(run("help audit").out, std::to_string(least.audit_points) + " to " +
                                            std::to_string(most.audit_points) + ", as 'nipref list' says"));
}

TEST_CASE("defaults are in the domains of the table of verbs, and each verb refuses what is beyond") {
  std::size_t ranges = 0;
  for (const verify::VerbText& verb : verify::verbs()) {
    for (const verify::OptionText& option : verb.options) {
      CAPTURE(verb.name, option.name);
      if (!option.usual().empty()) CHECK_NOTHROW(verify::check_option(option, option.usual()));
      if (option.row.number_or("positive", 0) != 0) {
        for (const char* const beyond : {"0", "-1", "nan"})
          CHECK_THROWS_AS(verify::check_option(option, beyond), data::BadInput);
      }
      const std::vector<std::string> range = option.row.words_of("range");
      if (range.empty()) continue;
      ++ranges;
      for (const std::string& end : range) CHECK_NOTHROW(verify::check_option(option, end));
      for (const std::string& beyond : {std::string("0"), range.back() + "9", std::string("nan")}) {
        const std::string assignment = option.name + "=" + beyond;
        const std::array words{"nipref", verb.name.c_str(), assignment.c_str()};
        CHECK_THROWS_AS(static_cast<void>(verify::parse_command_line(3, words.data())), data::BadInput);
      }
      CHECK(contains(verify::help_of(option), range.front() + " to " + range.back()));
    }
  }
  CHECK(ranges > 10);
}

TEST_CASE("every command of the README does what it says, with status 0") {
  const ScratchFolder folder;
  for (const char* const name : {"mine.so", "old.so"})
    fs::copy_file(plugin_file("readme"), folder.file(name));
  folder.write("results.csv", "# quantity: I2\nalpha,value\n0.5,1.5707963267948966\n");
  const std::string start = "cd '" + folder.path().string() + "' && '" + program() + "' ";
  const std::vector<std::string> all = commands();
  CHECK(all.size() >= 15);
  for (const std::string& command : all) {
    CAPTURE(command);
    CHECK(std::system((start + command + " >log 2>&1").c_str()) == 0);
  }
}
