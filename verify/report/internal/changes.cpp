#include <fmt/format.h>

#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {
namespace {

std::string style_of(Change change) {
  if (change == Change::worse || change == Change::slower) return "bad";
  return change == Change::better || change == Change::quicker ? "good" : "";
}

}  // namespace

Markup comparison_section(const ReportComparison& comparison) {
  TableMarkup table("What has changed, the worst first", {"change", "what", "before", "now"});
  for (const ChangedItem& item : comparison.items)
    table.row({{std::string(name(item.change)), false, style_of(item.change)},
               {item.what},
               {item.before},
               {item.now}});
  Markup content = element("p", "Since " + comparison.older + ": " + counts_text(comparison) + ".");
  if (!comparison.note.empty()) content += element("p", comparison.note);
  if (!comparison.items.empty()) content += table.markup();
  return section("comparison", "Against an older report", content);
}

}  // namespace nipref::verify
