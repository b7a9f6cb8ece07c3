#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace nipref::data {

/// The largest number of parts of a key; a.b.c has three. toml++ makes a table of each part and traverses nested tables
/// recursively. (For lists in lists toml++ has its own bound.)
inline constexpr std::size_t most_key_parts = 16;

/// A part of a text for which the behaviour of toml++ 3.3 is undefined.
struct TomlObstacle {
  std::size_t line;          ///< from 1
  std::string_view allowed;  ///< the requirement that the text violates
};

/// Returns the first obstacle in a text: a key of too many parts, or a letter beyond ASCII. Such letters are accepted
/// in comments, and in quoted texts without a backslash behind a space. Most of what is refused is not TOML either.
[[nodiscard]] std::optional<TomlObstacle> toml_obstacle(std::string_view text);

}  // namespace nipref::data
