#include <sys/ioctl.h>
#include <unistd.h>

#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

constexpr std::string_view green = "\x1b[32m", red = "\x1b[31m", as_before = "\x1b[0m";

/// The indent of a folded line's continuation: the column after the last gap of two spaces in the first half, if any.
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
    // The next piece is a word and the spaces before it.
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

std::size_t columns_of(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}
std::size_t text_width() { return std::max<std::size_t>(columns_of(STDOUT_FILENO), 40); }

std::string good(std::string_view text) { return fmt::format("{}{}{}", green, text, as_before); }
std::string bad(std::string_view text) { return fmt::format("{}{}{}", red, text, as_before); }

std::string trimmed(std::string_view text) {
  constexpr auto blanks = " \t";
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  return std::string(text.substr(first, text.find_last_not_of(blanks) + 1 - first));
}

std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char letter) { return letter < ' '; }, ' ');
  return text;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> parts_of(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + separator.size(), text.size()));
  }
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
  // Only the first byte of a UTF-8 character takes a column.
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

std::string table_text(const std::vector<std::string>& lines) {
  if (lines.size() < 2) return "";
  std::vector<std::vector<std::string>> rows = mapped(lines, [](const std::string& line) {
    return line.starts_with("    ") ? std::vector<std::string>() : parts_of(line, " | ");
  });
  std::vector<bool> flush_right;
  for (std::string& head : rows.front()) {
    flush_right.push_back(head.starts_with('>'));
    if (flush_right.back()) head.erase(0, 1);
  }
  std::vector<std::size_t> widths(flush_right.size());
  for (auto& row : rows) {
    if (!row.empty()) row.resize(widths.size());
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string line = rows[i].empty() ? folded(lines[i]) : "";
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const std::string padding(widths[j] - width_of(rows[i][j]), ' ');
      line += (j == 0 ? "" : "  ") + (flush_right[j] ? padding + rows[i][j] : rows[i][j] + padding);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace nipref::verify
