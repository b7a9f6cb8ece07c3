#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The spacing of the points of a range: even, even in the logarithm of the magnitude, or even in the count of doubles.
enum class Spacing { linear, log, bits };

/// The doubles from `lower` to `upper`, both included, unit of the argument.
struct Range {
  double lower;
  double upper;
  Spacing spacing = Spacing::linear;

  [[nodiscard]] bool fixed() const { return lower == upper; }
  [[nodiscard]] bool contains(double value) const { return value >= lower && value <= upper; }
  /// The double at `fraction` in [0, 1] of the way; the ends are met exactly.
  [[nodiscard]] double at(double fraction) const;
};

/// "lo..hi", "lo..hi:linear", "lo..hi:log" or "lo..hi:bits", decimal or hexadecimal numbers, each taken as its
/// nearest double; a single number is a range of one. Without a spacing: log where both ends have one sign and are
/// not 0, otherwise linear. BadInput naming `name` if it cannot be read, if an end is not finite, if lo > hi, or if
/// the ends of a logarithmic range are 0 or of two signs.
Range parse_range(const std::string& name, const std::string& text);

/// A range for each of a quantity's arguments, in its order; none for an argument that is drawn from its own
/// domain.
using Ranges = std::vector<std::optional<Range>>;

/// The ranges that were given by name; the names of choices stand for their numbers. An argument that is not given has
/// no range. BadInput for a name that the quantity does not have, for one given twice, and where parse_range throws.
Ranges parse_ranges(const Quantity& quantity, const Assignments& assignments);

/// Whether each number of the point lies in its range.
bool contains(const Ranges& ranges, const Point& point);

}  // namespace nipref::verify
