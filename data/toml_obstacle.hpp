#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace nipref::data {

/// A key has no more parts than this, a.b.c: toml++ makes a table of each, and goes through tables in tables
/// by recursion. (It bounds lists in lists itself.)
inline constexpr std::size_t most_key_parts = 16;

/// What toml++ 3.3 must not be given, for what it does then is undefined.
struct TomlObstacle {
  std::size_t line;  ///< from 1
  std::string_view allowed;
};

/// The first one in a text: a key of too many parts, or a letter beyond ASCII outside comments, but in a text
/// in quotes behind a space that has no backslash. Most of that is no TOML either.
[[nodiscard]] std::optional<TomlObstacle> toml_obstacle(std::string_view text);

}  // namespace nipref::data
