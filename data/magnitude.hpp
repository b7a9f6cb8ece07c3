#pragma once
#include <string_view>

namespace nipref::data {

/// The limits of numbers with a unit. Products of up to four numbers of a problem are formed, some as sums of two
/// doubles. Within these limits neither of the two doubles leaves the range of doubles.
inline constexpr double least_magnitude = 1e-60, greatest_magnitude = 1e60;

/// True from the least to the greatest magnitude.
[[nodiscard]] bool is_magnitude(double value);

/// The requirement for a number with a unit, in words, that `value`, which is not a magnitude, violates.
[[nodiscard]] std::string_view allowed_magnitude(double value);

/// BadInput unless `value` is a magnitude.
void check_magnitude(std::string_view argument, double value);

}  // namespace nipref::data
