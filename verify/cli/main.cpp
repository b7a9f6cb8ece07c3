#include <cstdio>

#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/text.hpp>

namespace {

constexpr int status_not_written = 4, status_interrupted = 130;

/// Prints a line on standard error. If this fails, the failure cannot be reported.
void complain(const std::string& message) { std::fputs(("nipref: " + message + "\n").c_str(), stderr); }

}  // namespace

/// Prints the answer of the call at its end. The exit status is the answer's, 4 if standard output cannot be written,
/// and 130 after an interrupt.
int main(int argc, char** argv) try {
  using namespace nipref::verify;
  occupy_standard_descriptors();
  Answer answer = nipref::verify::answer(argc, argv);
  if (!answer.complaint.empty()) complain(answer.complaint);
  if (!standard_output_shows_colours()) answer.output = plain(answer.output);
  if (!answer.output.empty()) write_to_standard_output(answer.output);
  return interrupted() ? status_interrupted : answer.status;
} catch (const nipref::verify::OutputError& error) {
  complain(error.what());
  return status_not_written;
}
