#include <cstdio>

#include <nipref/verify/replay/replay.hpp>

// A printed table beside its correct values: each cell by the seed's own method, and of the continuous contact.
int main() {
  using namespace nipref::verify;

  Replay replay = replay_table("thesis-VII");
  correct(replay);
  std::printf("%s\n", replay.table.title.c_str());
  for (const ReplayedCell& cell : replay.cells) {
    if (cell.row != 0 || !cell.corrected) continue;
    std::printf("%s: replayed %.6g, corrected %.6g (%s)\n", cell.column.c_str(), cell.value, *cell.corrected,
                name(cell.verdict).data());
  }
}
