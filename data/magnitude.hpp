#pragma once
#include <string_view>

namespace nipref::data {

/// A problem's units may be any, but products of up to four of its numbers are formed, and their parts in two
/// words: from the least to the greatest magnitude none of these leaves the range of doubles.
inline constexpr double least_magnitude = 1e-60, greatest_magnitude = 1e60;

/// True from the least to the greatest magnitude.
[[nodiscard]] bool is_magnitude(double value);

/// What a number with a unit must be that `value`, which is no magnitude, is not.
[[nodiscard]] std::string_view allowed_magnitude(double value);

/// BadInput unless `value` is a magnitude.
void check_magnitude(std::string_view argument, double value);

}  // namespace nipref::data
