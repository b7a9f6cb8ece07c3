#pragma once
#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string>

#include <nipref/verify/support/text.hpp>

namespace nipref::verify {

/// A number in so many significant digits, or a dash where it is not known.
inline std::string or_dash(const std::optional<double>& number, int digits) {
  return number ? fmt::format("{:.{}g}", *number, digits) : "-";
}

/// An error >= 0 in two digits, rounded upwards.
inline std::string upward_text(double error) {
  const std::string nearest = fmt::format("{:.1e}", error);
  if (std::strtod(nearest.c_str(), nullptr) >= error) return nearest;
  return fmt::format("{:.1e}", 1.05 * error);  // half a unit of the second digit is at most a twentieth
}

/// "accuracy 1e-10 is met", or "is missed", in colour. `of`: what the accuracy is relative to, " of the scale".
inline std::string met_text(long double accuracy, bool met, const char* of = "") {
  return verdict(met, fmt::format("accuracy {:g}{} is {}", accuracy, of, met ? "met" : "missed"));
}

/// A field of a CSV record: in quotes where it has a comma or a quote.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

}  // namespace nipref::verify
