#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

/// The columns of the terminal that standard output is, at least 40; 80 if it is none.
std::size_t text_width();

/// A text in green, or in red, by escape sequences of terminals.
std::string good(std::string_view text);
std::string bad(std::string_view text);

/// The text without blanks at its ends.
std::string trimmed(std::string_view text);

/// The words of a text, between white space.
std::vector<std::string> words_of(const std::string& text);

/// The parts of a text between separators; what is behind the last one counts unless it is empty.
std::vector<std::string> parts_of(const std::string& text, char separator);

/// The text without colours.
std::string plain(std::string_view text);

/// The number of columns that the text takes; escape sequences take none.
std::size_t width_of(std::string_view text);

/// Breaks each line that is too wide at spaces. The continuation starts below the last column of the line if that column is
/// in the first half, and otherwise four columns to the right of the line's start. A word that is too wide is not broken.
std::string folded(std::string_view text, std::size_t width = text_width());

/// A table in plain text: each column is as wide as its widest cell, with two spaces between columns.
class TextTable {
 public:
  /// The heads of the columns; a head that begins with '>', which is not shown, makes its column flush right.
  explicit TextTable(std::vector<std::string_view> heads);

  /// Adds a row, with a cell for each column.
  void add(std::vector<std::string> cells);
  /// Adds an indented line below the last row.
  void add_below(std::string line);

  [[nodiscard]] bool empty() const { return rows_.size() == 1; }
  /// The table with its line of heads. Lines below rows are folded, rows are not.
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
