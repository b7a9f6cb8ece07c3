#pragma once
#include <functional>
#include <ostream>

#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {

/// What a program does from its command line to its exit status: takes the line apart, runs it, and prints what it has to
/// say when it has come to its end, so that bad input leaves standard output empty, or with --json to the error alone.
/// Whatever goes wrong is one line on standard error. Gives the status: that of `run`, 2 for BadInput, 4 where standard
/// output or a file cannot be written, 70 for an error of ours, 130 after an interrupt.
int program_status(int argc, const char* const* argv,
                   const std::function<int(const CommandLine& line, std::ostream& out)>& run);

}  // namespace nipref::verify
