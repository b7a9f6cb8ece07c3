#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <system_error>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/standard_output.hpp>
#include <nipref/verify/cli/tables.hpp>
#include <nipref/verify/cli/verbs.hpp>

namespace {

using namespace nipref;

constexpr int status_bad_input = 2;
constexpr int status_internal = 3;
constexpr int status_not_written = 4;

int run(const verify::CommandLine& line, std::ostream& out) {
  if (line.help) {
    out << *line.help;
    return 0;
  }
  if (line.verb == "list") return verify::list_verb(line, out);
  if (line.verb == "eval") return verify::eval_verb(line, out);
  if (line.verb == "solve") return verify::solve_verb(line, out);
  if (line.verb == "audit") return verify::audit_verb(line, out);
  if (line.verb == "bench") return verify::bench_verb(line, out);
  if (line.verb == "report") return verify::report_verb(line, out);
  return verify::tables_verb({.ids = line.words, .list = line.list, .json = line.json}, out);
}

/// Whatever was in the input, the message stays one line. There is nobody to tell if this fails.
void complain(std::string message) {
  std::ranges::replace_if(
      message, [](unsigned char letter) { return letter < ' '; }, ' ');
  std::fputs(("nipref: " + message + "\n").c_str(), stderr);
}

/// What came of a command line: all that goes to standard output. Nothing is printed before a verb has come to its
/// end, so that bad input leaves standard output empty.
struct Result {
  int status;
  std::string output = {};
};

Result result_of(int argc, const char* const* argv) try {
  std::ostringstream out;
  const int status = run(verify::parse_command_line(argc, argv), out);
  return {status, out.str()};
} catch (const data::BadInput& error) {
  complain(error.what());
  return {status_bad_input};
} catch (const std::exception& error) {
  complain(std::string("internal error: ") + error.what());
  return {status_internal};
}

}  // namespace

int main(int argc, char** argv) try {
  verify::occupy_standard_descriptors();
  const Result result = result_of(argc, argv);
  if (!result.output.empty()) verify::write_to_standard_output(result.output);
  return result.status;
} catch (const std::system_error& error) {
  complain(error.what());
  return status_not_written;
}
