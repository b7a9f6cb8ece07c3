#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

constexpr std::string_view green = "\x1b[32m", red = "\x1b[31m", as_before = "\x1b[0m";

/// The indent of a folded line's continuation: the column after the last gap of two spaces in its first half.
std::size_t hanging_indent(std::string_view line, std::size_t width) {
  const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
  std::size_t indent = start + 4;
  for (std::size_t gap = line.find("  ", start); gap < width / 2; gap = line.find("  ", indent)) {
    const std::size_t next = line.find_first_not_of(' ', gap);
    if (next == std::string_view::npos || next > width / 2) break;
    indent = next;
  }
  return indent;
}

void append_folded(std::string& text, std::string_view line, std::size_t width) {
  if (width_of(line) <= width) {
    text += line;
    return;
  }
  const std::size_t indent = hanging_indent(plain(line), width);
  std::size_t used = 0;
  for (std::size_t at = 0; at < line.size();) {
    // The next piece is a word with the spaces before it.
    const std::size_t word = std::min(line.find_first_not_of(' ', at), line.size());
    const std::size_t end = std::min(line.find(' ', word), line.size());
    const std::size_t of_word = width_of(line.substr(word, end - word));
    if (used > indent && used + (word - at) + of_word > width) {
      text += fmt::format("\n{:{}}", "", indent);
      used = indent;
    } else {
      text += line.substr(at, word - at);
      used += word - at;
    }
    text += line.substr(word, end - word);
    used += of_word;
    at = end;
  }
}

}  // namespace

std::size_t text_width() {
  constexpr std::size_t usual = 80, least = 40;
  winsize size{};
  const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? std::max<std::size_t>(size.ws_col, least) : usual;
}

std::string good(std::string_view text) { return fmt::format("{}{}{}", green, text, as_before); }
std::string bad(std::string_view text) { return fmt::format("{}{}{}", red, text, as_before); }

std::string trimmed(std::string_view text) {
  constexpr auto blanks = " \t";
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  return std::string(text.substr(first, text.find_last_not_of(blanks) + 1 - first));
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::string plain(std::string_view text) {
  std::string without;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\x1b') {
      at = std::min(text.find('m', at), text.size());
    } else {
      without += text[at];
    }
  }
  return without;
}

std::size_t width_of(std::string_view text) {
  const std::string seen = plain(text);
  // Of a UTF-8 character only the first byte takes a column.
  return static_cast<std::size_t>(std::ranges::count_if(
      seen, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

std::string folded(std::string_view text, std::size_t width) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    append_folded(all, text.substr(at, end - at), width);
    if (end < text.size()) all += '\n';
    at = end + 1;
  }
  return all;
}

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
