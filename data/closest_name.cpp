#include <nipref/data/closest_name.hpp>
#include <nipref/data/internal/common.hpp>

namespace nipref::data {
namespace {

char lower(char letter) { return static_cast<char>(std::tolower(static_cast<unsigned char>(letter))); }

/// Returns Levenshtein's distance, computed row by row, where an exchange of two neighbouring letters is one error too.
std::size_t typing_errors(std::string_view from, std::string_view to) {
  std::vector<std::size_t> above(to.size() + 1), before_that, row = above;
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const auto same = [&](std::size_t of_from, std::size_t of_to) {
        return lower(from[of_from]) == lower(to[of_to]);
      };
      row[j + 1] = std::min({above[j] + (same(i, j) ? 0 : 1), row[j] + 1, above[j + 1] + 1});
      if (i > 0 && j > 0 && same(i, j - 1) && same(i - 1, j))
        row[j + 1] = std::min(row[j + 1], before_that[j - 1] + 1);
    }
    before_that = std::exchange(above, row);
  }
  return above[to.size()];
}

std::size_t errors_of(std::string_view name, std::string_view candidate) {
  constexpr std::size_t telling_letters = 3;
  const std::size_t errors = typing_errors(name, candidate);
  const bool is_part = name.size() >= telling_letters && candidate.find(name) != std::string_view::npos;
  return is_part ? std::min<std::size_t>(errors, 1) : errors;
}

}  // namespace

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates,
                         std::size_t most) {
  std::size_t fewest = std::max<std::size_t>(1, name.size() / 3);
  std::vector<std::string_view> nearest;
  for (const std::string_view candidate : candidates) {
    const std::size_t errors = errors_of(name, candidate);
    if (errors > fewest || errors >= name.size()) continue;
    if (errors < fewest) nearest.clear();
    fewest = errors;
    nearest.push_back(candidate);
  }
  if (nearest.empty()) return "";
  nearest.resize(std::min(most, nearest.size()));
  std::string text = "did you mean ";
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const char* const before = i == 0 ? "" : i + 1 == nearest.size() ? " or " : ", ";
    text += fmt::format("{}{}", before, nearest[i]);
  }
  return text + "? ";
}

}  // namespace nipref::data
