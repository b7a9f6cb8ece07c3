#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/cli/output_file.hpp>
#include <nipref/verify/cli/standard_output.hpp>
#include <nipref/verify/cli/tables.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/text.hpp>

namespace {

using namespace nipref;

constexpr int status_bad_input = 2;
constexpr int status_internal = 70;  // EX_SOFTWARE of sysexits.h
constexpr int status_not_written = 4;
constexpr int status_interrupted = 130;

int run(const verify::CommandLine& line, std::ostream& out) {
  if (line.help) {
    out << verify::folded(*line.help);
    return 0;
  }
  if (line.version) {
    out << (line.json ? verify::version_answer_text() : verify::folded(verify::version_text()));
    return 0;
  }
  if (const auto isa = line.option("isa")) fast::use_instruction_set(*isa);
  if (line.verb == "list") return verify::list_verb(line, out);
  if (line.verb == "eval") return verify::eval_verb(line, out);
  if (line.verb == "solve") return verify::solve_verb(line, out);
  if (line.verb == "balance") return verify::balance_verb(line, out);
  if (line.verb == "audit") return verify::audit_verb(line, out);
  if (line.verb == "merge") return verify::merge_verb(line, out);
  if (line.verb == "points") return verify::points_verb(line, out);
  if (line.verb == "grade") return verify::grade_verb(line, out);
  if (line.verb == "golden") return verify::golden_verb(line, out);
  if (line.verb == "limits") return verify::limits_verb(line, out);
  if (line.verb == "claims") return verify::claims_verb(line, out);
  if (line.verb == "errata") return verify::errata_verb(line, out);
  if (line.verb == "figures") return verify::figures_verb(line, out);
  if (line.verb == "bench") return verify::bench_verb(line, out);
  if (line.verb == "report") return verify::report_verb(line, out);
  return verify::tables_verb({.ids = line.words,
                              .list = line.has("list"),
                              .full = line.has("full"),
                              .json = line.json,
                              .quiet = line.has("quiet")},
                             out);
}

/// Whatever was in the input, the message stays one line, which is given back. There is nobody to tell if this fails.
std::string complain(std::string message) {
  std::ranges::replace_if(
      message, [](unsigned char letter) { return letter < ' '; }, ' ');
  std::fputs(("nipref: " + message + "\n").c_str(), stderr);
  return message;
}

/// What came of a command line: all that goes to standard output. Nothing is printed before a verb has come to its
/// end, so that bad input leaves standard output empty, or with --json to the error alone.
struct Result {
  int status;
  std::string output = {};
};

Result result_of(int argc, const char* const* argv) {
  const bool json = verify::asks_for_json(argc, argv);
  try {
    std::ostringstream out;
    const int status = run(verify::parse_command_line(argc, argv), out);
    return {status, out.str()};
  } catch (const data::BadInput& error) {
    const std::string message = complain(error.what());
    if (!json) return {status_bad_input};
    return {status_bad_input,
            verify::error_answer_text(message, error.argument(), error.value(), error.allowed())};
  } catch (const verify::OutputError&) {
    throw;
  } catch (const std::exception& error) {
    const std::string message = complain(std::string("internal error: ") + error.what());
    return {status_internal, json ? verify::error_answer_text(message) : ""};
  }
}

}  // namespace

int main(int argc, char** argv) try {
  verify::occupy_standard_descriptors();
  Result result = result_of(argc, argv);
  if (!verify::standard_output_shows_colours()) result.output = verify::plain(result.output);
  if (!result.output.empty()) verify::write_to_standard_output(result.output);
  return verify::interrupted() ? status_interrupted : result.status;
} catch (const verify::OutputError& error) {
  complain(error.what());
  return status_not_written;
}
