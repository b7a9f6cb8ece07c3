#include <algorithm>

#include <nipref/data/toml_obstacle.hpp>

namespace nipref::data {
namespace {

/// Returns the length of the quoted text, including its quotes, with which `text` begins. Without a closing quote it
/// ends with the line, a text in triple quotes with `text`.
std::size_t quoted_length(std::string_view text) {
  const char quote = text.front();
  const std::string_view triple = text.substr(0, 3);
  const bool is_long = std::ranges::count(triple, quote) == 3;
  const std::string_view ending = is_long ? triple : triple.substr(0, 1);
  for (std::size_t at = ending.size(); at < text.size(); ++at) {
    if (text.substr(at).starts_with(ending)) return at + ending.size();
    if (text[at] == '\n' && !is_long) return at;
    if (text[at] == '\\' && quote == '"') ++at;
  }
  return text.size();
}

/// Returns the length of the comment, quoted text or single letter with which `text` begins.
std::size_t token_length(std::string_view text) {
  const char letter = text.front();
  if (letter == '#') return std::min(text.find('\n'), text.size());
  return letter == '"' || letter == '\'' ? quoted_length(text) : 1;
}

bool is_beyond_ascii(char letter) { return static_cast<unsigned char>(letter) >= 0x80; }

/// Whether toml++ surely reads a token as one quoted text. It reads what begins like a number on through quotes, up to
/// the next space or comma, and takes any letter after a backslash for a space.
bool is_plain(std::string_view text, std::size_t at, std::string_view token) {
  const bool is_apart = at == 0 || std::string_view(" \t\r\n,").find(text[at - 1]) != std::string_view::npos;
  return is_apart && token.size() > 1 && token.find('\\') == std::string_view::npos;
}

}  // namespace

std::optional<TomlObstacle> toml_obstacle(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf", no_part_of_a_key = "=,[]{}\n";
  std::size_t parts = 1, line = 1;
  for (std::size_t at = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; at < text.size();) {
    const char letter = text[at];
    if (letter == '.' && ++parts > most_key_parts)
      return TomlObstacle{line, "must have keys of at most 16 parts"};
    if (no_part_of_a_key.find(letter) != std::string_view::npos) parts = 1;
    const std::string_view token = text.substr(at, token_length(text.substr(at)));
    if (letter != '#' && std::ranges::any_of(token, is_beyond_ascii) && !is_plain(text, at, token))
      return TomlObstacle{line,
                          "must be TOML: letters beyond ASCII in quotes behind a space, with no backslash"};
    line += static_cast<std::size_t>(std::ranges::count(token, '\n'));
    at += token.size();
  }
  return std::nullopt;
}

}  // namespace nipref::data
