#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// Pairs of name and value as they were given.
using Assignments = std::vector<std::pair<std::string, std::string>>;

/// Replaces material=MODEL(KEY=VALUE, KEY=[VALUE, ...]), as a user writes it, by the model and the arguments that hold
/// its numbers, and solid=MODEL(...) likewise. @FILE means the material, or the half-space, of the scene in that file.
/// Numbers at the end of a list may be missing and are then 0, unless the model needs them. Throws BadInput for another
/// form, a key that the model does not have, and an argument of the material that is given outside of it.
Assignments with_material_numbers(const Quantity& quantity, const Assignments& given);

/// The texts of the arguments as a user writes them: a material is one text with the numbers of its model.
Assignments written_arguments(const Quantity& quantity, const std::vector<std::string>& text);

/// The same for a point; `number` turns its numbers into text.
Assignments written_point(const Quantity& quantity, std::span<const double> point,
                          const std::function<std::string(double)>& number);

/// The name by which a user writes the argument: its own, or that of the material or solid that holds it.
const std::string& written_name(const Quantity& quantity, const Argument& argument);

/// The arguments that a user writes: a material or solid in place of those that hold its numbers.
std::vector<Argument> written_arguments(const Quantity& quantity);

/// The form in which a user writes the model: MODEL(KEY=..., KEY=[...]).
std::string written_model(const MaterialModel& model);

/// A quantity's arguments, in its order: the text of each, its exact number, and the double nearest to it.
struct ParsedArguments {
  std::vector<std::string> text;
  std::vector<ref::Exact> exact;

  /// Nearest doubles. BadInput for a number that overflows, or that is not zero but rounds to zero.
  [[nodiscard]] Point nearest(const Quantity& quantity) const;
};

/// BadInput for a pair that names no argument of the quantity.
void refuse_unknown_arguments(const Quantity& quantity, const Assignments& assignments);

/// The text that is given for the argument, if there is one. BadInput if it is given twice.
std::optional<std::string> argument_text(const Argument& argument, const Assignments& assignments);

/// Matches the pairs with the quantity's arguments and fills in defaults. BadInput naming the argument if one
/// is missing, unknown, given twice, or not a number (decimal or hexadecimal text).
ParsedArguments parse_arguments(const Quantity& quantity, const Assignments& assignments);

/// A whole number, or BadInput naming `name`.
long parse_integer(const std::string& name, const std::string& text);

/// A finite double, or BadInput naming `name`.
double parse_real(const std::string& name, const std::string& text);

}  // namespace nipref::verify
