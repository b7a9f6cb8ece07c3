#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/verify/report/internal/counts.hpp>

namespace nipref::verify {

std::string fraction(std::size_t some, std::size_t all) { return fmt::format("{} of {}", some, all); }

std::string counted(std::size_t some, std::size_t all, std::string_view what) {
  return (some == all ? fmt::format("all {} ", all) : fraction(some, all) + " ") + std::string(what);
}

std::size_t kept_in(const std::vector<AuditResult>& results) {
  return static_cast<std::size_t>(std::ranges::count_if(results, &AuditResult::kept));
}

std::vector<const BenchRatio*> headline_ratios(const BenchReport& speed) {
  std::vector<const BenchRatio*> headline;
  for (const BenchRatio& ratio : speed.ratios) {
    if (ratio.what.find("against Boost") != std::string::npos ||
        ratio.what.find("against GSL") != std::string::npos)
      headline.push_back(&ratio);
  }
  return headline;
}

std::vector<Shortfall> shortfalls(const Report& report) {
  const auto ratios = report.speed.ratios.size();
  const auto missed_ratios =
      ratios - static_cast<std::size_t>(std::ranges::count_if(report.speed.ratios, &BenchRatio::met));
  const auto missed_quantities = report.quantities.size() - kept_in(report.quantities);
  std::size_t points = 0, missed_accuracies = 0, unchecked = 0, refused = 0, cells = 0, unexplained = 0;
  for (const AuditResult& result : report.quantities) points += result.left_out;
  for (const SceneTally& tally : report.scenes) {
    missed_accuracies += tally.miss_reported + tally.miss_unreported;
    unchecked += tally.unchecked;
    refused += tally.refused;
  }
  for (const Replay& replay : report.tables) {
    unexplained += replay.count(Verdict::unexplained);
    for (const Verdict verdict :
         {Verdict::match, Verdict::misprint, Verdict::seed_error, Verdict::unexplained})
      cells += replay.count(verdict);
  }
  const auto without_truth = static_cast<std::size_t>(std::ranges::count_if(
      report.hard_cases, [](const ContactAudit& audit) { return !audit.kept().has_value(); }));
  return {
      {fmt::format("{} missed", missed_quantities + missed_ratios + missed_accuracies),
       fmt::format("promises: {} quantities, {} ratios of the bench, {} accuracies asked of random contacts",
                   fraction(missed_quantities, report.quantities.size()), fraction(missed_ratios, ratios),
                   missed_accuracies),
       "speed"},
      {fmt::format("{} skipped", points + refused + unchecked + without_truth),
       fmt::format(
           "for want of a truth: {} points, {} random contacts, {} numbers of others, {} hard cases{}",
           points, refused, unchecked, without_truth,
           report.witness.installed ? "" : ", all that CalculiX would confirm"),
       "contacts"},
      {fmt::format("{} unexplained", unexplained), fmt::format("of {} cells of the printed tables", cells),
       "tables"}};
}

std::string two_digits(double number) {
  if (!(number >= 10 && number < 1e6)) return fmt::format("{:.2g}", number);
  const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
  return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

std::string off_text(double relative) {
  const double percent = std::fabs(100 * relative);
  return fmt::format("{} % {}", percent < 1 ? fmt::format("{:.1g}", percent) : fmt::format("{:.0f}", percent),
                     relative < 0 ? "low" : "high");
}

}  // namespace nipref::verify
