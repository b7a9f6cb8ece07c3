#include <algorithm>
#include <cstddef>
#include <numeric>

#include <nipref/data/scene/internal/closest_name.hpp>

namespace nipref::data {
namespace {

/// Levenshtein's distance, row by row.
std::size_t typing_errors(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t exchanged = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[to.size()];
}

}  // namespace

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates) {
  std::size_t fewest = name.size() / 3 + 1;
  std::string_view closest;
  for (const std::string_view candidate : candidates) {
    const std::size_t errors = typing_errors(name, candidate);
    if (errors < fewest) {
      fewest = errors;
      closest = candidate;
    }
  }
  return closest.empty() ? "" : "did you mean " + std::string(closest) + "? ";
}

}  // namespace nipref::data
