#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {
namespace {

/// The second methods, without what each row's distance is.
std::string second_methods(const GoldenFile& file) {
  std::set<std::string> methods;
  for (const GoldenRow& row : file.rows)
    methods.insert(row.confirmed_by.substr(0, row.confirmed_by.rfind(" to ")));
  std::string text;
  for (const std::string& method : methods) text += (text.empty() ? "" : "; ") + method;
  return text;
}

void append_golden(TableMarkup& table, const GoldenSample& one) {
  const auto proven = std::ranges::count_if(one.file.rows, &GoldenRow::proven);
  table.row({{one.checked.quantity, false, "keep"},
             {verdict_mark(one.checked.kept()), false, "keep"},
             number_cell(std::to_string(one.file.rows.size())),
             number_cell(std::to_string(one.file.digits())),
             number_cell(std::to_string(proven)),
             number_cell(std::to_string(one.checked.rows)),
             number_cell(std::to_string(one.checked.recomputed)),
             {second_methods(one.file), false, "wide"},
             {element("code", one.file.entry("commit").substr(0, 10)), false, "keep"}});
}

}  // namespace

Markup golden_section(const Report& report) {
  TableMarkup table(
      "Golden values: what is kept, and what came of the sample that this run looked at",
      {"quantity", "verdict", "#values", "#digits", "#with a proven bound", "#compared with fast",
       "#made anew by the reference", "confirmed by a second method", "made at commit"});
  Markup failures;
  for (const GoldenSample& one : report.golden) {
    if (!one.file.rows.empty()) append_golden(table, one);
    for (const GoldenFailure& failure : one.checked.failures)
      failures += element("li", one.checked.quantity + ": " + failure.what);
  }
  if (!failures.html().empty()) failures = element("ul", {{"class", "bad"}}, failures);
  return section(
      "golden", "Golden values",
      element(
          "p",
          "Values of every quantity with bounds, each confirmed by a second method that shares no code with the reference. "
          "All of them are looked at by nipref golden check.") +
          failures + details("All quantities", table.markup()));
}

}  // namespace nipref::verify
