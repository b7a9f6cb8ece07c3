#pragma once
#include <fmt/format.h>

#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// The whole text as a number; nothing if the text is no number.
inline std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::nullopt : std::optional(number);
}

/// An error >= 0 with two digits, rounded upwards.
inline std::string upward_text(double error) {
  const std::string nearest = fmt::format("{:.1e}", error);
  if (std::strtod(nearest.c_str(), nullptr) >= error) return nearest;
  return fmt::format("{:.1e}", 1.05 * error);  // half a unit of the second digit is at most a twentieth
}

/// A field of a CSV record, in quotes if it contains a comma or a quote.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

}  // namespace nipref::verify
