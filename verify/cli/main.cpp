#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/tables.hpp>
#include <nipref/verify/cli/verbs.hpp>

namespace {

using namespace nipref;

constexpr int status_bad_input = 2;
constexpr int status_internal = 3;

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

/// Whatever was in the input, the message stays one line.
int complain(std::string message, int status) {
  std::ranges::replace_if(
      message, [](unsigned char letter) { return letter < ' '; }, ' ');
  fmt::print(stderr, "nipref: {}\n", message);
  return status;
}

}  // namespace

/// Nothing is printed before a verb has come to its end, so that bad input leaves standard output empty.
int main(int argc, char** argv) try {
  std::ostringstream out;
  const int status = run(verify::parse_command_line(argc, argv), out);
  std::cout << out.str() << std::flush;
  return status;
} catch (const data::BadInput& error) {
  return complain(error.what(), status_bad_input);
} catch (const std::exception& error) {
  return complain(std::string("internal error: ") + error.what(), status_internal);
}
