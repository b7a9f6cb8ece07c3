#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

bool is_computed(const SweepRow& row) { return !row.columns.empty(); }

std::vector<SweepRow> finished_rows(const Sweep& sweep, bool quiet) {
  std::vector<SweepRow> rows(sweep.product.size());
  Progress progress(quiet);
  progress.begin("sweep", 1);
  progress.next(fmt::format("{} rows", rows.size()));
  const auto finish = [&](std::size_t i) {
    try {
      rows[i] = sweep.row_at(i);
    } catch (const BadInput& error) {
      rows[i].refused = error;
    }
  };
  try {
    parallel_for(rows.size(), finish, [&](double part) { progress.at(part); });
  } catch (const Interrupted&) {
    // The rows that were finished before the interrupt are printed.
  }
  return rows;
}

std::string refusal_text(const SweepRow& row) {
  if (row.refused) return row.refused->what();
  return is_computed(row) ? "" : "not computed: interrupted";
}

/// A field of CSV without commas: readers such as NumPy's genfromtxt end a column at a comma even in quotes.
std::string without_commas(std::string text) {
  std::ranges::replace(text, ',', ';');
  return csv_field(text);
}

/// The first row that was computed, for its columns; without such a row there are none.
SweepRow shape_of(const std::vector<SweepRow>& rows) {
  const auto known = std::ranges::find_if(rows, is_computed);
  return known == rows.end() ? SweepRow() : *known;
}

std::string sweep_csv(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  const SweepRow shape = shape_of(rows);
  const std::vector<std::string>& heads = shape.heads.empty() ? shape.columns : shape.heads;
  const std::vector<std::vector<std::string>> unknown{std::vector<std::string>(heads.size())};
  std::string text;
  for (const Axis& axis : sweep.product.axes()) text += csv_field(axis.name) + ",";
  for (const std::string& head : heads) text += csv_field(head) + ",";
  text += "refused\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string start;
    for (const AxisValue* const value : sweep.product.at(i)) start += csv_field(value->shown) + ",";
    for (const std::vector<std::string>& line : is_computed(rows[i]) ? rows[i].lines : unknown) {
      text += start;
      for (const std::string& cell : line) text += without_commas(cell) + ",";
      text += without_commas(refusal_text(rows[i])) + "\n";
    }
  }
  return text;
}

Json sweep_json(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  Json columns = Json::object();
  const auto& axes = sweep.product.axes();
  for (std::size_t a = 0; a < axes.size(); ++a)
    columns.set(axes[a].name, json_list(std::views::iota(std::size_t{0}, rows.size()),
                                        [&](std::size_t i) { return sweep.product.at(i)[a]->shown; }));
  const std::vector<std::string> names = shape_of(rows).columns;
  for (std::size_t j = 0; j < names.size(); ++j)
    columns.set(names[j], json_list(rows, [&](const SweepRow& row) {
                  return is_computed(row) ? row.values[j] : Json();
                }));
  Json members = sweep.members;
  members.set("columns", columns);
  members.set("refused",
              json_list(rows, [](const SweepRow& row) { return Json::unless_empty(refusal_text(row)); }));
  return members;
}

}  // namespace

VerbAnswer swept(const Sweep& sweep, const CommandLine& line) {
  const std::vector<SweepRow> rows = finished_rows(sweep, line.has("quiet"));
  if (std::ranges::all_of(rows, [](const SweepRow& row) { return row.refused.has_value(); }))
    throw BadInput(*rows.front().refused);
  const bool all_well =
      std::ranges::all_of(rows, [](const SweepRow& row) { return is_computed(row) && !row.fell_short; });
  if (line.json) return {sweep.verb, sweep_json(sweep, rows), all_well};
  return {sweep.verb, {}, all_well, [csv = sweep_csv(sweep, rows)] { return csv; }};
}

}  // namespace nipref::verify
