#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

struct ProgramOutput {
  int status;  ///< exit status, or -1 if the program did not exit
  std::string text;
};

/// Runs a program and waits for its end. The first word is the program, which is searched as by a shell. Its standard
/// input is `input`, its standard output is returned, and its standard error is discarded. OutputError if the input
/// cannot be written to a temporary file.
ProgramOutput output_of(const std::vector<std::string>& words, std::string_view input = {});

/// The status that a shell returns for an unknown program.
inline constexpr int status_not_found = 127;

/// The drawing by a script of gnuplot, as SVG; nothing if gnuplot is not installed. Throws std::runtime_error if it
/// fails.
std::optional<std::string> drawn_by_gnuplot(const std::string& script);

}  // namespace nipref::verify
