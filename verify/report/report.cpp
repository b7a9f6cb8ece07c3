#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/report/report.hpp>

namespace nipref::verify {
namespace {

/// A column of the seeds' tables whose largest error is reported.
struct SeedColumn {
  std::string_view what;
  std::string_view tables;  ///< the beginning of the tables' ids
  std::string_view weakness;
  std::string_view column;  ///< the beginning of the column's name
};

constexpr SeedColumn seed_columns[] = {
    {"contact length L of the thesis", "thesis-", "discretisation", "L"},
    {"rolling resistance mu_R of the thesis", "thesis-", "discretisation", "muR"},
    {"span ratio of Brock's Table 1 (2013)", "brock2013-1", "formula", "c="}};

/// The number of rows for which `is_so` holds, of other rows, and of all rows.
template <class Rows, class IsSo>
Json share_json(const Rows& rows, IsSo is_so) {
  const auto kept = std::ranges::count_if(rows, is_so);
  const auto of = std::ranges::ssize(rows);
  return {{"passed", kept}, {"missed", of - kept}, {"of", of}, {"all", kept == of}};
}

template <class Rows, class Count>
long sum(const Rows& rows, Count count) {
  long total = 0;
  for (const auto& row : rows) total += static_cast<long>(std::invoke(count, row));
  return total;
}

Json closest_json(const std::vector<AuditResult>& results) {
  const AuditResult* const closest = closest_to_its_promise(results);
  return closest == nullptr ? Json()
                            : Json{{"quantity", closest->quantity->name},
                                   {"allowance_used", closest->allowance_used},
                                   {"error_ulp", closest->worst_ulp}};
}

Json random_contacts_json(const std::vector<SceneTally>& scenes) {
  const long numbers = sum(scenes, &SceneTally::numbers), unchecked = sum(scenes, &SceneTally::unchecked);
  return {{"scenes", sum(scenes, &SceneTally::scenes)},
          {"numbers", numbers - unchecked},
          {"not_covered", sum(scenes, &SceneTally::uncovered)},
          {"passed", all_kept(scenes)}};
}

Json hard_cases_json(const std::vector<ContactAudit>& audits) {
  std::vector<bool> kept;
  for (const ContactAudit& audit : audits)
    if (audit.kept()) kept.push_back(*audit.kept());
  return share_json(kept, std::identity());
}

/// The numbers without a truth to compare with.
Json skipped_json(const Report& report) {
  const long points = sum(report.quantities, &AuditResult::left_out);
  const long refused = sum(report.scenes, &SceneTally::refused);
  const long numbers = sum(report.scenes, &SceneTally::unchecked);
  const auto hard_cases = std::ranges::count_if(
      report.hard_cases, [](const ContactAudit& audit) { return !audit.kept().has_value(); });
  return {{"all", points + refused + numbers + hard_cases},
          {"points", points},
          {"contacts", refused},
          {"numbers", numbers},
          {"hard_cases", hard_cases}};
}

Json table_counts_json(const Replay& replay) {
  const ColumnDeviation* worst = nullptr;
  for (const Cost& cost : replay.costs) {
    for (const ColumnDeviation& column : cost.columns)
      if (worst == nullptr || std::fabs(column.largest) > std::fabs(worst->largest)) worst = &column;
  }
  return {{"id", replay.table.id},
          {"judged", replay.cells.size() - replay.count(Verdict::input)},
          {"match", replay.count(Verdict::match)},
          {"misprint", replay.count(Verdict::misprint)},
          {"likely_misprint", replay.count(Verdict::likely_misprint)},
          {"seed_error", replay.count(Verdict::seed_error)},
          {"unexplained", replay.count(Verdict::unexplained)},
          {"worst_column", worst == nullptr ? Json() : column_json(*worst)},
          {"costs", cost_list_json(replay)}};
}

/// The promised ratios of fast's times to those of other libraries.
Json headline_ratios_json(const BenchReport& speed) {
  const auto is_headline = [](const BenchRatio& ratio) {
    return ratio.what.find("against Boost") != std::string::npos ||
           ratio.what.find("against GSL") != std::string::npos;
  };
  return json_list(speed.ratios | std::views::filter(is_headline), ratio_json);
}

/// The largest deviations in the given tables: of the contact length and the rolling resistance by the thesis's line
/// loads, and of the span ratio by the formula of Brock's first table of 2013.
Json seed_errors_json(const std::vector<Replay>& tables) {
  std::vector<Json> errors;
  for (const SeedColumn& where : seed_columns) {
    double largest = 0;
    Json error;
    for (const Replay& replay : tables) {
      if (!replay.table.id.starts_with(where.tables)) continue;
      for (const Cost& cost : replay.costs) {
        for (const ColumnDeviation& column : cost.columns) {
          if (cost.weakness != where.weakness || !column.column.starts_with(where.column) ||
              (!error.is_null() && std::fabs(column.largest) <= std::fabs(largest)))
            continue;
          largest = column.largest;
          error = {{"what", where.what},
                   {"table", replay.table.id},
                   {"relative", largest},
                   {"cause", cost.weakness + ", " + cost.against}};
        }
      }
    }
    if (!error.is_null()) errors.push_back(error);
  }
  return errors;
}

Json summary_json(const Report& report) {
  const long missed_accuracies =
      sum(report.scenes, &SceneTally::miss_reported) + sum(report.scenes, &SceneTally::miss_unreported);
  const auto missed_promises = std::ranges::count_if(report.quantities, std::not_fn(&AuditResult::kept)) +
                               std::ranges::count_if(report.speed.ratios, std::not_fn(&BenchRatio::met)) +
                               missed_accuracies;
  return {{"quantities", share_json(report.quantities, &AuditResult::kept)},
          {"points", sum(report.quantities, &AuditResult::points)},
          {"closest", closest_json(report.quantities)},
          {"random_contacts", random_contacts_json(report.scenes)},
          {"missed_accuracies", missed_accuracies},
          {"hard_cases", hard_cases_json(report.hard_cases)},
          {"witness",
           report.witness.installed ? share_json(report.witness.contacts, &Witnessed::agrees) : Json()},
          {"skipped", skipped_json(report)},
          {"tables", json_list(report.tables, table_counts_json)},
          {"tables_known", !report.tables_fall_short},
          {"claims", verdict_counts_json(report.claims, {ClaimVerdict::holds, ClaimVerdict::fails,
                                                         ClaimVerdict::holds_in_a_range})},
          {"limits", share_json(report.limits, &LimitRow::approached)},
          {"errata", share_json(report.errata, &Settlement::settled)},
          {"golden", share_json(report.golden, [](const GoldenSample& one) { return one.checked.kept(); })},
          {"golden_values",
           {{"checked", sum(report.golden, [](const GoldenSample& one) { return one.checked.rows; })},
            {"of", sum(report.golden, [](const GoldenSample& one) { return one.file.rows.size(); })}}},
          {"seed", report.seed},
          {"times",
           {{"missed", missed_promises},
            {"ratios", share_json(report.speed.ratios, &BenchRatio::met)},
            {"headline", headline_ratios_json(report.speed)}}}};
}

Json quantities_json(const std::vector<AuditResult>& results) {
  return json_list(results, [](const AuditResult& result) {
    const Quantity& quantity = *result.quantity;
    return Json{{"quantity", quantity.name},          {"subject", quantity.subject},
                {"definition", quantity.definition},  {"notation", quantity.notation},
                {"measured_against", quantity.scale}, {"plot", error_plot_json(result)}};
  });
}

Json golden_values_json(const std::vector<GoldenSample>& samples) {
  std::vector<Json> files;
  for (const auto& [file, checked] : samples) {
    if (file.rows.empty()) continue;
    std::set<std::string> methods;  // names of methods without the distance, which differs from row to row
    for (const GoldenRow& row : file.rows)
      methods.insert(row.confirmed_by.substr(0, row.confirmed_by.rfind(" to ")));
    files.push_back({{"quantity", checked.quantity},
                     {"values", file.rows.size()},
                     {"digits", file.digits()},
                     {"proven", std::ranges::count_if(file.rows, &GoldenRow::proven)},
                     {"confirmed_by", json_list(methods)},
                     {"commit", file.entry("commit").substr(0, 10)}});
  }
  return files;
}

/// The number of kept promises, and the result that uses the largest share of its promised error; null without results.
Json kept_json(const std::vector<AuditResult>& results) {
  if (results.empty()) return {};
  const AuditResult& closest = *closest_to_its_promise(results);
  return {{"all", all_kept(results)},
          {"passed", std::ranges::count_if(results, &AuditResult::kept)},
          {"of", results.size()},
          {"closest", closest.quantity->name},
          {"used", closest.allowance_used}};
}

}  // namespace

bool Report::kept(bool strict) const {
  const auto none_broken = [](const auto& rows, auto is_kept) { return std::ranges::all_of(rows, is_kept); };
  return Audited::kept() && witness.agrees() && !tables_fall_short && all_met(speed, strict) &&
         none_broken(limits, &LimitRow::approached) && none_broken(errata, &Settlement::settled) &&
         none_broken(golden, [](const GoldenSample& one) { return one.checked.kept(); });
}

const AuditResult* closest_to_its_promise(const std::vector<AuditResult>& results) {
  const auto closest = std::ranges::max_element(results, {}, &AuditResult::allowance_used);
  return closest == results.end() ? nullptr : &*closest;
}

Json audits_json(const Audited& audited, fast::Accuracy accuracy) {
  const bool is_full = accuracy.rtol() <= fast::Accuracy::best_rtol;
  return {{"rtol", is_full ? Json() : Json(accuracy.rtol())},
          {"rows", audit_json(audited.quantities)},
          {"contacts", contact_audit_json(audited.hard_cases)},
          {"scenes", scene_tally_json(audited.scenes)},
          {"_of_quantities", kept_json(audited.quantities)}};
}

Json report_json(const Report& report) {
  return {{"command", report.command},
          {"audit", audits_json(report, {})},
          {"witness", witness_json(report.witness)},
          {"bench", bench_json(report.speed)},
          {"tables", tables_json(report.tables)},
          {"seed_errors", seed_errors_json(report.tables)},
          {"claims", claims_json(report.claims)},
          {"limits", limits_json(report.limits)},
          {"errata", errata_json(report.errata)},
          {"golden",
           json_list(report.golden, [](const GoldenSample& one) { return checked_file_json(one.checked); })},
          {"golden_values", golden_values_json(report.golden)},
          {"quantities", quantities_json(report.quantities)},
          {"figures", json_list(report.figures, figure_json)},
          {"times", {{"plots", speed_plots_json(report.speed.rows)}}},
          {"summary", summary_json(report)},
          {"to_come", json_list(report.to_come)},
          {"comparison", report.comparison ? comparison_json(*report.comparison) : Json()}};
}

}  // namespace nipref::verify
