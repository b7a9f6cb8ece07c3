#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// name=value pairs as they were given.
using Assignments = std::vector<std::pair<std::string, std::string>>;

/// A quantity's arguments, in its order: the text, the number that it is exactly, and the nearest double.
struct ParsedArguments {
  std::vector<std::string> text;
  std::vector<ref::Exact> exact;

  /// Nearest doubles. BadInput for a number that overflows, or that is not zero but rounds to zero.
  [[nodiscard]] Point nearest(const Quantity& quantity) const;
};

/// BadInput for a pair that names no argument of the quantity.
void refuse_unknown_arguments(const Quantity& quantity, const Assignments& assignments);

/// What is given for the argument, if anything is. BadInput if it is given twice.
std::optional<std::string> argument_text(const Argument& argument, const Assignments& assignments);

/// Matches the pairs with the quantity's arguments and fills in defaults. BadInput naming the argument if one
/// is missing, unknown, given twice, or not a number (decimal or hexadecimal text).
ParsedArguments parse_arguments(const Quantity& quantity, const Assignments& assignments);

/// A whole number, or BadInput naming `name`.
long parse_integer(const std::string& name, const std::string& text);

/// A finite double, or BadInput naming `name`.
double parse_real(const std::string& name, const std::string& text);

}  // namespace nipref::verify
