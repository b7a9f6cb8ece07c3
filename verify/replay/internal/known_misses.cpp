#include <algorithm>

#include <nipref/verify/replay/internal/known_misses.hpp>

namespace nipref::verify {

bool is_known_miss(const std::vector<data::KnownMiss>& known, const Replay& replay,
                   const ReplayedCell& cell) {
  return std::ranges::any_of(known, [&](const data::KnownMiss& miss) {
    return miss.table == replay.table.id && miss.row == cell.row + 1 && miss.column == cell.column;
  });
}

}  // namespace nipref::verify
