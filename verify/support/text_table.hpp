#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

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
