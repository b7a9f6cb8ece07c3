#pragma once
#include <string>
#include <vector>

namespace nipref::verify {

struct ProgramOutput {
  int status;  ///< of its exit; -1 if it did not come to one
  std::string text;
};

/// Runs a program with these words, the first of them the program, found as a shell finds it, and waits for its end.
/// Its standard output is the text, its standard error goes nowhere.
ProgramOutput output_of(const std::vector<std::string>& words);

}  // namespace nipref::verify
