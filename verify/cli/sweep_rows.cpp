#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

/// A row that was computed or refused; neither where the process was interrupted before.
struct FinishedRow {
  std::optional<SweepRow> row;
  std::optional<BadInput> refused;
};

FinishedRow finished(const Sweep& sweep, std::size_t number) try {
  return {sweep.row_at(number), {}};
} catch (const BadInput& error) {
  return {{}, error};
}

std::vector<FinishedRow> finished_rows(const Sweep& sweep, bool quiet) {
  std::vector<FinishedRow> rows(sweep.product.size());
  Progress progress(quiet);
  progress.begin("sweep", 1);
  progress.next(fmt::format("{} rows", rows.size()));
  try {
    parallel_for(
        rows.size(), [&](std::size_t i) { rows[i] = finished(sweep, i); },
        [&](double part) { progress.at(part); });
  } catch (const Interrupted&) {
    // The rows that were finished before the interrupt are printed.
  }
  return rows;
}

std::string refusal_text(const FinishedRow& row) {
  if (row.refused) return row.refused->what();
  return row.row ? "" : "not computed: interrupted";
}

/// As a field of CSV: a comma in quotes is one more column to readers such as NumPy's genfromtxt.
std::string without_commas(std::string text) {
  std::ranges::replace(text, ',', ';');
  return csv_field(text);
}

std::string sweep_csv(const Sweep& sweep, const std::vector<FinishedRow>& rows) {
  const std::vector<std::vector<std::string>> unknown{std::vector<std::string>(sweep.heads.size())};
  std::string text;
  for (const Axis& axis : sweep.product.axes()) text += csv_field(axis.name) + ",";
  for (const std::string& head : sweep.heads) text += csv_field(head) + ",";
  text += "refused\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string start;
    for (const AxisValue* const value : sweep.product.at(i)) start += csv_field(value->shown) + ",";
    for (const std::vector<std::string>& line : rows[i].row ? rows[i].row->lines : unknown) {
      text += start;
      for (const std::string& cell : line) text += without_commas(cell) + ",";
      text += without_commas(refusal_text(rows[i])) + "\n";
    }
  }
  return text;
}

Json columns_json(const Sweep& sweep, const std::vector<FinishedRow>& rows) {
  Json columns = Json::object();
  const auto& axes = sweep.product.axes();
  for (std::size_t a = 0; a < axes.size(); ++a) {
    std::vector<Json> values;
    for (std::size_t i = 0; i < rows.size(); ++i) values.emplace_back(sweep.product.at(i)[a]->shown);
    columns.set(axes[a].name, values);
  }
  for (std::size_t j = 0; j < sweep.columns.size(); ++j)
    columns.set(sweep.columns[j], json_list(rows, [&](const FinishedRow& row) {
                  return row.row ? row.row->values[j] : Json();
                }));
  return columns;
}

Json sweep_json(const Sweep& sweep, const std::vector<FinishedRow>& rows) {
  Json members = sweep.members;
  members.set("columns", columns_json(sweep, rows));
  members.set("refused",
              json_list(rows, [](const FinishedRow& row) { return Json::unless_empty(refusal_text(row)); }));
  return members;
}

}  // namespace

int write_sweep(const Sweep& sweep, const CommandLine& line, std::ostream& out) {
  const std::vector<FinishedRow> rows = finished_rows(sweep, line.has("quiet"));
  if (std::ranges::all_of(rows, [](const FinishedRow& row) { return row.refused.has_value(); }))
    throw BadInput(*rows.front().refused);
  out << (line.json ? answer_text(sweep.verb, sweep_json(sweep, rows), line.no_times)
                    : sweep_csv(sweep, rows));
  return std::ranges::all_of(rows, [](const FinishedRow& row) { return row.row && !row.row->fell_short; })
             ? 0
             : 1;
}

}  // namespace nipref::verify
