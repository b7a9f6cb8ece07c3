#include <fmt/format.h>

#include <algorithm>
#include <string>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

std::string promise_text(const AuditResult& result, fast::Accuracy accuracy) {
  return accuracy.rtol() > fast::Accuracy::best_rtol ? fmt::format("{:.1e} scale", accuracy.rtol())
                                                     : fmt::format("{:g} ulp", result.promise);
}

std::string verdict_text(const AuditResult& result) {
  if (!result.kept()) return bad("BROKEN");
  return good(result.few_points() ? "kept, few" : "kept");
}

/// "37 of 38 kept; closest to its promise: F1, 90 %"
std::string summary(const std::vector<AuditResult>& results) {
  const auto closest = std::ranges::max_element(results, {}, &AuditResult::allowance_used);
  const auto kept = std::ranges::count_if(results, &AuditResult::kept);
  return fmt::format("{}; closest to its promise: {}, {:.0f} %\n",
                     verdict(all_kept(results), fmt::format("{} of {} kept", kept, results.size())),
                     closest->quantity->name, 100 * closest->allowance_used);
}

}  // namespace

std::string point_text(const Quantity& quantity, const Point& point) {
  std::string text;
  const auto both = [](double x) { return fmt::format("{:.6g} ({:a})", x, x); };
  for (const auto& [name, value] : written_point(quantity, point, both))
    text += fmt::format(" {}={}", name, value);
  return text;
}

Json point_json(const Quantity& quantity, const Point& point) {
  Json arguments = Json::object();
  const auto exact = [](double x) { return fmt::format("{:a}", x); };
  for (const auto& [name, value] : written_point(quantity, point, exact)) arguments.set(name, value);
  return arguments;
}

std::string audit_text(const std::vector<AuditResult>& results, fast::Accuracy accuracy) {
  TextTable table({"verdict", "quantity", ">points", ">max ulp", ">mean ulp", ">promise", ">used"});
  for (const AuditResult& result : results) {
    table.add({verdict_text(result), result.quantity->name, std::to_string(result.points),
               fmt::format("{:.4g}", result.max_error_ulp), fmt::format("{:.3g}", result.spread.mean),
               promise_text(result, accuracy), fmt::format("{:.0f}%", 100 * result.allowance_used)});
    table.add_below("worst at" + point_text(*result.quantity, result.worst));
  }
  std::string text = summary(results) + "\n" + table.text();
  if (std::ranges::any_of(results, &AuditResult::few_points)) {
    text += fmt::format("few: fewer than {} points, which say little; --density or --points looks at more\n",
                        enough_points);
  }
  return text;
}

Json audit_row_json(const AuditResult& result) {
  return {{"quantity", result.quantity->name},
          {"points", result.points},
          {"max_error_ulp", result.max_error_ulp},
          {"mean_error_ulp", result.spread.mean},
          {"median_error_ulp", result.spread.median},
          {"percentile_90_ulp", result.spread.percentile_90},
          {"percentile_99_ulp", result.spread.percentile_99},
          {"percentile_99_9_ulp", result.spread.percentile_999},
          {"max_relative_error", result.max_relative_error},
          {"promise_ulp", result.promise},
          {"allowance_used", result.allowance_used},
          {"kept", result.kept()},
          {"few_points", result.few_points()},
          {"worst", point_json(*result.quantity, result.worst)}};
}

Json audit_json(const std::vector<AuditResult>& results) { return json_list(results, audit_row_json); }

bool all_kept(const std::vector<AuditResult>& results) {
  return std::ranges::all_of(results, &AuditResult::kept);
}

}  // namespace nipref::verify
