#pragma once
#include <functional>
#include <ostream>

#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {

/// Runs a program: parses the command line, calls `run`, and prints its output at the end, so that bad input leaves
/// standard output empty, or with --json has the error alone there. Every error is one line on standard error.
/// Returns the exit status: that of `run`, 2 for BadInput, 4 where standard output or a file cannot be written, 70
/// for an internal error, 130 after an interrupt.
int program_status(int argc, const char* const* argv,
                   const std::function<int(const CommandLine& line, std::ostream& out)>& run);

}  // namespace nipref::verify
