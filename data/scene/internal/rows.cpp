#include <nipref/data/scene/internal/rows.hpp>

namespace nipref::data {

std::vector<std::string_view> split(std::string_view text, char separator, std::size_t most) {
  std::vector<std::string_view> parts;
  for (bool has_more = true; has_more;) {
    const std::size_t end =
        parts.size() + 1 < most ? std::min(text.find(separator), text.size()) : text.size();
    std::string_view part = text.substr(0, end);
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    part.remove_suffix(part.size() - (part.find_last_not_of(' ') + 1));
    parts.push_back(part);
    has_more = end < text.size();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words = split(text, ' ');
  std::erase(words, std::string_view());
  return words;
}

std::vector<std::vector<std::string_view>> rows_of(std::string_view table, std::size_t fields) {
  std::vector<std::vector<std::string_view>> rows;
  for (const std::string_view line : split(table, '\n')) {
    if (line.empty() || line.front() == '#') continue;
    if (rows.emplace_back(split(line, '|', fields)).size() != fields)
      throw std::logic_error("table of scenes: " + std::string(line));
  }
  return rows;
}

}  // namespace nipref::data
