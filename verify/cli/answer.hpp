#pragma once
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// What comes of a call of the program.
struct Answer {
  int status;  ///< that of the verb, 2 for BadInput, 4 where a file cannot be written, 70 for an internal error
  std::string output = {};     ///< all that goes to standard output
  std::string complaint = {};  ///< the line that goes to standard error; empty if there is none
};

/// Parses the command line and runs its verb. With bad input the output is empty, or with --json the error alone.
Answer answer(int argc, const char* const* argv);

}  // namespace nipref::verify
