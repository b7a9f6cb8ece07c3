#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

/// What people read is this wide.
inline constexpr std::size_t text_width = 80;

/// A verdict in the colour of what is well, and of what is not, as a terminal shows it.
std::string good(std::string_view text);
std::string bad(std::string_view text);
inline std::string verdict(bool well, std::string_view text) { return well ? good(text) : bad(text); }

/// Without colours.
std::string plain(std::string_view text);

/// Columns that the text takes: colours take none.
std::size_t width_of(std::string_view text);

/// Each line that is too wide broken at spaces. It goes on below its last column, where that starts in the first half,
/// or else a little to the right of where it starts. A word that is too wide by itself stays whole.
std::string folded(std::string_view text);

/// A table for people: columns as wide as what is in them, two spaces apart.
class TextTable {
 public:
  /// Heads; what stands below one that begins with '>' is flush right, and the '>' is not shown.
  explicit TextTable(std::vector<std::string_view> heads);

  /// A cell for each column.
  void add(std::vector<std::string> cells);
  /// A line below the last row, indented.
  void add_below(std::string line);

  [[nodiscard]] bool empty() const { return rows_.size() == 1; }
  /// With a line of heads; lines below rows are folded, rows are not.
  [[nodiscard]] std::string text() const;

 private:
  struct Row {
    std::vector<std::string> cells;
    std::vector<std::string> below = {};
  };
  std::vector<bool> flush_right_;
  std::vector<Row> rows_;  ///< the first holds the heads
};

}  // namespace nipref::verify
