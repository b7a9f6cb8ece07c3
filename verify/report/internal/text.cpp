#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/report/internal/counts.hpp>
#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

/// A part's name, and what there is to say of it.
std::string paragraph(std::string_view part, std::string_view says) {
  return folded(fmt::format("{:<11}{}\n", part, says));
}

/// In the colour of a verdict.
std::string judged(std::size_t some, std::size_t all, std::string_view what) {
  return verdict(some == all, counted(some, all, what));
}

std::string audit_line(const Report& report) {
  const AuditResult* const closest = closest_to_its_promise(report.quantities);
  std::string text = judged(kept_in(report.quantities), report.quantities.size(), "quantities kept");
  if (closest != nullptr)
    text += fmt::format("; closest to its promise: {} with {:.0f} %", closest->quantity->name,
                        100 * closest->allowance_used);
  return text;
}

std::string speed_line(const Report& report) {
  std::string text;
  for (const BenchRatio* ratio : headline_ratios(report.speed))
    text += fmt::format("{}: {} times; ", ratio->what, two_digits(ratio->measured));
  const auto met = static_cast<std::size_t>(std::ranges::count_if(report.speed.ratios, &BenchRatio::met));
  return text + judged(met, report.speed.ratios.size(), "promised ratios met");
}

std::string shortfalls_line(const Report& report) {
  std::string text;
  for (const Shortfall& one : shortfalls(report))
    text += (text.empty() ? "" : "; ") + one.count + " " + one.what;
  return text;
}

std::string contacts_line(const Report& report) {
  std::size_t scenes = 0, numbers = 0, uncovered = 0;
  for (const SceneTally& tally : report.scenes) {
    scenes += tally.scenes;
    numbers += tally.numbers - tally.unchecked;
    uncovered += tally.uncovered;
  }
  const auto with_truth = std::ranges::count_if(
      report.hard_cases, [](const ContactAudit& audit) { return audit.kept().has_value(); });
  const auto kept = std::ranges::count_if(
      report.hard_cases, [](const ContactAudit& audit) { return audit.kept().value_or(false); });
  return fmt::format(
      "{} random scenes, {} numbers with a truth: errors of {}; {} hard cases with a truth kept", scenes,
      numbers, uncovered == 0 ? good("all cover") : bad(fmt::format("{} do NOT cover", uncovered)),
      fraction(static_cast<std::size_t>(kept), static_cast<std::size_t>(with_truth)));
}

std::string witness_line(const Witness& witness) {
  if (!witness.installed) return "skipped: CalculiX is not installed";
  return "CalculiX confirms " +
         judged(static_cast<std::size_t>(std::ranges::count_if(witness.contacts, &Witnessed::agrees)),
                witness.contacts.size(), "contacts");
}

std::string tables_line(const Report& report) {
  std::size_t cells = 0;
  std::string text;
  for (const Verdict verdict :
       {Verdict::match, Verdict::misprint, Verdict::seed_error, Verdict::unexplained}) {
    std::size_t count = 0;
    for (const Replay& replay : report.tables) count += replay.count(verdict);
    cells += count;
    text += fmt::format(", {} {}", count, name(verdict));
  }
  return fmt::format("{} cells of {} tables: {}{}", cells, report.tables.size(),
                     text.substr(std::min<std::size_t>(2, text.size())),
                     report.tables_fall_short ? "; " + bad("NOT all of these are known") : "");
}

std::string seeds_line(const Report& report) {
  std::string text;
  for (const SeedError& error : seed_errors(report.tables))
    text += fmt::format("{}{}: up to {}", text.empty() ? "" : "; ", error.what, off_text(error.relative));
  return text;
}

std::string claims_line(const Report& report) {
  std::string text;
  for (const ClaimVerdict verdict :
       {ClaimVerdict::holds, ClaimVerdict::fails, ClaimVerdict::holds_in_a_range})
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", name_of(verdict),
                        std::ranges::count_if(report.claims, [&](const CheckedClaim& one) {
                          return one.outcome.verdict == verdict;
                        }));
  return fmt::format("{} of the seeds' statements: {}", report.claims.size(), text);
}

std::string golden_line(const Report& report) {
  std::size_t kept = 0, rows = 0, looked_at = 0;
  for (const GoldenSample& one : report.golden) {
    kept += one.checked.kept();
    rows += one.file.rows.size();
    looked_at += one.checked.rows;
  }
  return fmt::format("{}; {} of {} values looked at", judged(kept, report.golden.size(), "quantities kept"),
                     looked_at, rows);
}

/// A line of the version each, without what it is linked with.
std::string built_text(std::string_view version) {
  std::string text;
  while (!version.empty()) {
    const std::size_t end = std::min(version.find('\n'), version.size());
    const std::string_view line = version.substr(0, end);
    const std::size_t colon = line.find(": ");
    const std::size_t split = colon == std::string_view::npos ? line.find(' ') : colon;
    if (!line.starts_with("libraries"))
      text += paragraph(line.substr(0, split), line.substr(line.find_first_not_of(": ", split)));
    version.remove_prefix(std::min(end + 1, version.size()));
  }
  return text;
}

}  // namespace

std::string report_text(const Report& report, const std::string& where_more_is) {
  const auto settled = static_cast<std::size_t>(std::ranges::count_if(
      report.errata, [](const SettledErratum& one) { return one.settlement.settled(); }));
  const auto approached =
      static_cast<std::size_t>(std::ranges::count_if(report.limits, &LimitRow::approached));
  std::string text = built_text(report.version);
  text += "\n";
  return text + paragraph("audit", audit_line(report)) + paragraph("short", shortfalls_line(report)) +
         paragraph("speed", speed_line(report)) + paragraph("contacts", contacts_line(report)) +
         paragraph("witness", witness_line(report.witness)) + paragraph("tables", tables_line(report)) +
         paragraph("seeds", seeds_line(report)) + paragraph("claims", claims_line(report)) +
         paragraph("limits",
                   judged(approached, report.limits.size(), "closed forms approached as they must be")) +
         paragraph("errata", judged(settled, report.errata.size(), "misprinted formulas settled")) +
         paragraph("golden", golden_line(report)) + paragraph("page", where_more_is);
}

}  // namespace nipref::verify
