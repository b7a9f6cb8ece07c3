#include <fmt/format.h>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/report/internal/counts.hpp>
#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {
namespace {

/// A large number, what it is, and where more about it stands.
Markup headline_item(const std::string& number, const Markup& what, const std::string& id) {
  return element("li", link_to(id, element("b", number)) + what);
}

Markup accuracy_item(const Report& report) {
  const AuditResult* const closest = closest_to_its_promise(report.quantities);
  if (closest == nullptr) return {};
  std::size_t points = 0;
  for (const AuditResult& result : report.quantities) points += result.points;
  return headline_item(
      fmt::format("{:.0f} %", 100 * closest->allowance_used),
      fmt::format("of its promise is the largest error found, among {} points of {} quantities: that "
                  "of {}, {:.3g} ulp. ",
                  points, report.quantities.size(), closest->quantity->name, closest->worst_ulp) +
          verdict_mark(all_kept(report.quantities)),
      "accuracy-" + closest->quantity->name);
}

Markup contacts_item(const Report& report) {
  std::size_t numbers = 0, uncovered = 0;
  for (const SceneTally& tally : report.scenes) {
    numbers += tally.numbers - tally.unchecked;
    uncovered += tally.uncovered;
  }
  if (numbers == 0) return {};
  return headline_item(
      fraction(uncovered, numbers),
      "numbers of random contacts that have a truth lie farther from it than their stated errors. " +
          verdict_mark(all_kept(report.scenes)),
      "contacts");
}

}  // namespace

Markup headline_section(const Report& report) {
  Markup items = accuracy_item(report) + contacts_item(report);
  for (const BenchRatio* ratio : headline_ratios(report.speed))
    items += headline_item(fmt::format("{} times", two_digits(ratio->measured)),
                           fmt::format("less time a value in this run: {}. Promised are {:g} times. ",
                                       ratio->what, ratio->target) +
                               met_mark(ratio->met()),
                           "speed");
  for (const Shortfall& one : shortfalls(report)) items += headline_item(one.count, one.what + ".", one.id);
  for (const SeedError& error : seed_errors(report.tables))
    items += headline_item(
        off_text(error.relative),
        fmt::format("is the {} at worst, in {}: by {}.", error.what, error.table, error.cause), error.table);
  Markup content = element("ul", {{"class", "headline"}}, items);
  if (report.interrupted)
    content = element("p", {{"class", "bad"}}, "Interrupted: this is what was finished by then.") + content;
  return section("headline", "At a glance", content);
}

}  // namespace nipref::verify
