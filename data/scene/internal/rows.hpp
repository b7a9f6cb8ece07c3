#pragma once
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::data {

// Readers of the tables of this folder, FILE.table. A line is a row with bars between its fields, or a comment after #.

/// The parts of a text between separators, without the blanks around them. The last of `most` parts has the rest.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator,
                                                  std::size_t most = std::string_view::npos);

[[nodiscard]] std::vector<std::string_view> words_in(std::string_view text);

/// The rows of a table. Each row must have so many fields.
[[nodiscard]] std::vector<std::vector<std::string_view>> rows_of(std::string_view table, std::size_t fields);

/// The names that the tables have for each SceneKind.
inline constexpr std::array<std::string_view, 2> scene_kinds{"nip", "half-space"};

/// The enumerator with a name, where `names` are in the order of the enumeration.
template <class Enum>
Enum named(const auto& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == std::ranges::end(names)) throw std::logic_error("table of scenes: " + std::string(name));
  return static_cast<Enum>(found - std::ranges::begin(names));
}

}  // namespace nipref::data
