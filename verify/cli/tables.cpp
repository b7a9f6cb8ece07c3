#include <nipref/data/directory.hpp>
#include <nipref/verify/cli/report_parts.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {
namespace {

VerbAnswer list_tables(const std::vector<std::string>& ids) {
  std::vector<data::TableSummary> summaries;
  if (ids.empty()) summaries = data::summarize_tables();
  for (const std::string& id : ids) summaries.push_back(data::summarize(data::load_table_by_id(id)));
  return {"tables", table_list_json(summaries), true, "tables_list.txt"};
}

/// Unexplained though the table does not speak against the printed number, and not known to be so.
bool falls_short(const std::vector<data::KnownMiss>& known, const Replay& replay, const ReplayedCell& cell) {
  const data::TableCell& printed = replay.table.cell(cell.row, cell.column);
  return cell.verdict == Verdict::unexplained && printed.is_readable() && !printed.is_doubtful() &&
         !is_known_miss(known, replay, cell);
}

}  // namespace

std::vector<Replay> replay_and_correct(const std::vector<std::string>& ids, Progress& progress) {
  std::vector<Replay> replays;
  progress.each("tables", ids, std::identity(), [&](const std::string& id) {
    Replay replay = replay_table(id);
    correct(replay);
    replays.push_back(std::move(replay));
  });
  return replays;
}

bool fall_short(const std::vector<Replay>& replays) {
  const auto known = data::load_known_misses(data::tables_directory() / "known_misses.csv");
  return std::ranges::any_of(replays, [&](const Replay& replay) {
    return std::ranges::any_of(replay.cells,
                               [&](const ReplayedCell& cell) { return falls_short(known, replay, cell); });
  });
}

VerbAnswer tables_verb(const CommandLine& line) {
  const std::vector<std::string> ids =
      each_once(mapped(line.words, [](const auto& name) { return data::find_table_id(name); }));
  if (line.has("list")) return list_tables(ids);
  Progress progress(line.has("quiet"));
  const auto replays = replay_and_correct(ids.empty() ? replayable_tables() : ids, progress);
  return {"tables", tables_json(replays, line.has("full")), !fall_short(replays)};
}

}  // namespace nipref::verify
