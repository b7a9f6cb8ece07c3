#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

struct ProgramOutput {
  int status;  ///< of its exit; -1 if it did not come to one
  std::string text;
};

/// Runs a program with these words, the first of them the program, found as a shell finds it, and waits for its end.
/// It reads `input`, its standard output is the text, its standard error goes nowhere. OutputError if the input could
/// not be put where it reads it.
ProgramOutput output_of(const std::vector<std::string>& words, std::string_view input = {});

/// The status that a shell gives for a program that it does not find.
inline constexpr int status_not_found = 127;

}  // namespace nipref::verify
