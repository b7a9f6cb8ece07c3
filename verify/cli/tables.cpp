#include <algorithm>

#include <nipref/data/directory.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/tables.hpp>
#include <nipref/verify/replay/corrected.hpp>
#include <nipref/verify/replay/internal/known_misses.hpp>
#include <nipref/verify/replay/render.hpp>

namespace nipref::verify {
namespace {

int list_tables(const TablesRequest& request, std::ostream& out) {
  std::vector<data::TableSummary> summaries;
  if (request.ids.empty()) summaries = data::summarize_tables();
  for (const std::string& id : request.ids) summaries.push_back(data::summarize(data::load_table_by_id(id)));
  out << (request.json ? answer_text("tables", table_list_json(summaries)) : table_list_text(summaries));
  return 0;
}

bool has_doubtful_length(const Replay& replay, std::size_t row) {
  return replay.table.has_column("L") && replay.table.cell(row, "L").is_doubtful();
}

/// Unexplained though the table speaks against neither the printed number nor the length its row is replayed
/// from, and not known to be so.
bool falls_short(const std::vector<data::KnownMiss>& known, const Replay& replay, const ReplayedCell& cell) {
  const data::TableCell& printed = replay.table.cell(cell.row, cell.column);
  return cell.verdict == Verdict::unexplained && printed.is_readable() && !printed.is_doubtful() &&
         !has_doubtful_length(replay, cell.row) && !is_known_miss(known, replay, cell);
}

}  // namespace

std::vector<Replay> replay_and_correct(const std::vector<std::string>& ids) {
  std::vector<Replay> replays;
  for (const std::string& id : ids) {
    replays.push_back(replay_table(id));
    correct(replays.back());
  }
  return replays;
}

bool fall_short(const std::vector<Replay>& replays) {
  const auto known = data::load_known_misses(data::tables_directory() / "known_misses.csv");
  return std::ranges::any_of(replays, [&](const Replay& replay) {
    return std::ranges::any_of(replay.cells,
                               [&](const ReplayedCell& cell) { return falls_short(known, replay, cell); });
  });
}

int tables_verb(const TablesRequest& request, std::ostream& out) {
  if (request.list) return list_tables(request, out);
  const auto replays = replay_and_correct(request.ids.empty() ? replayable_tables() : request.ids);
  out << (request.json ? answer_text("tables", tables_json(replays)) : tables_text(replays, false));
  return fall_short(replays) ? 1 : 0;
}

}  // namespace nipref::verify
