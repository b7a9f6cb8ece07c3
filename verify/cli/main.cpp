#include <cstdio>

#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/text.hpp>

namespace {

using namespace nipref;
using namespace nipref::verify;

constexpr int status_bad_input = 2;
constexpr int status_internal = 70;  // EX_SOFTWARE of sysexits.h
constexpr int status_not_written = 4;
constexpr int status_interrupted = 130;

int run(const CommandLine& line, std::ostream& out) {
  if (line.help || line.version) {
    out << (line.help ? folded(*line.help) : version_answer_text(line.json));
    return 0;
  }
  if (const auto isa = line.option("isa")) fast::use_instruction_set(*isa);
  return find_verb(line.verb).run(line, out);
}

/// Whatever was in the input, the message stays one line, which is given back. There is nobody to tell if this fails.
std::string complain(std::string message) {
  std::ranges::replace_if(
      message, [](unsigned char letter) { return letter < ' '; }, ' ');
  std::fputs(("nipref: " + message + "\n").c_str(), stderr);
  return message;
}

/// What came of a command line: all that goes to standard output.
struct Result {
  int status;
  std::string output = {};
};

Result result_of(int argc, const char* const* argv) {
  const bool json = asks_for_json(argc, argv);
  try {
    std::ostringstream out;
    const int status = run(parse_command_line(argc, argv), out);
    return {status, out.str()};
  } catch (const data::BadInput& error) {
    const std::string message = complain(error.what());
    if (!json) return {status_bad_input};
    return {status_bad_input, error_answer_text(message, error.argument(), error.value(), error.allowed())};
  } catch (const OutputError&) {
    throw;
  } catch (const std::exception& error) {
    const std::string message = complain(std::string("internal error: ") + error.what());
    return {status_internal, json ? error_answer_text(message) : ""};
  }
}

}  // namespace

/// Parses the command line, runs its verb, and prints its output at the end, so that bad input leaves standard output
/// empty, or with --json has the error alone there. Every error is one line on standard error. The exit status is that of
/// the verb, 2 for BadInput, 4 where standard output or a file cannot be written, 70 for an internal error, 130 after an
/// interrupt.
int main(int argc, char** argv) try {
  occupy_standard_descriptors();
  Result result = result_of(argc, argv);
  if (!standard_output_shows_colours()) result.output = plain(result.output);
  if (!result.output.empty()) write_to_standard_output(result.output);
  return interrupted() ? status_interrupted : result.status;
} catch (const OutputError& error) {
  complain(error.what());
  return status_not_written;
}
