#include <fmt/format.h>

#include <algorithm>

#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/select_by_id.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/seeds/limits.hpp>
#include <nipref/verify/seeds/render.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

std::string order_text(const LimitRow& row) {
  return row.order == 0 ? "faster than any power" : fmt::format("with its power {:g}", row.order);
}

std::string row_text(const LimitRow& row) {
  std::string text = fmt::format("{}: {}\n  {}\n", row.name, row.statement, row.source);
  for (const LimitSample& sample : row.samples)
    text += fmt::format("  {} = {:g}: {}, limit {}, distance {:.1e}\n", row.size, sample.size,
                        stated_text(sample.found), stated_text(sample.limit), sample.distance().value());
  const auto measured = row.measured_order();
  return text + fmt::format("  {}: the distance must fall {}, and {}\n",
                            verdict(row.approached(), row.approached() ? "approached" : "MISSED"),
                            order_text(row),
                            measured ? "falls with " + stated_text(*measured)
                                     : "is below the solver's error at last");
}

}  // namespace

int limits_verb(const CommandLine& line, std::ostream& out) {
  std::vector<LimitRow> rows = limits();
  select_by_id(rows, line.words, "limit", &LimitRow::name);
  const auto missed = std::ranges::count_if(rows, [](const LimitRow& row) { return !row.approached(); });
  if (line.json) {
    out << answer_text("limits", {{"rows", limits_json(rows)}}, line.no_times);
  } else {
    std::string text = fmt::format("{} limits, {} missed\n", rows.size(), missed);
    for (const LimitRow& row : rows) text += "\n" + row_text(row);
    out << folded(text);
  }
  return missed == 0 ? 0 : 1;
}

}  // namespace nipref::verify
