#include <algorithm>
#include <utility>

#include <nipref/verify/support/text.hpp>
#include <nipref/verify/support/text_table.hpp>

namespace nipref::verify {
namespace {

constexpr std::string_view gap = "  ", indent = "    ";

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

TextTable::TextTable(std::vector<std::string_view> heads) {
  std::vector<std::string> cells;
  for (const std::string_view head : heads) {
    flush_right_.push_back(head.starts_with('>'));
    cells.emplace_back(head.substr(flush_right_.back() ? 1 : 0));
  }
  rows_.push_back({std::move(cells)});
}

void TextTable::add(std::vector<std::string> cells) { rows_.push_back({std::move(cells)}); }
void TextTable::add_below(std::string line) { rows_.back().below.push_back(std::move(line)); }

std::string TextTable::text() const {
  std::vector<std::size_t> widths(flush_right_.size());
  for (const Row& row : rows_) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width_of(row.cells[i]));
  }
  std::string text;
  for (const Row& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string padding(widths[i] - width_of(row.cells[i]), ' ');
      line += i == 0 ? "" : gap;
      line += flush_right_[i] ? padding + row.cells[i] : row.cells[i] + padding;
    }
    text += without_trailing_spaces(std::move(line)) + "\n";
    for (const std::string& below : row.below) text += folded(std::string(indent) + below) + "\n";
  }
  return text;
}

}  // namespace nipref::verify
