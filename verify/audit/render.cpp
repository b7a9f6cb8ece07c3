#include <fmt/format.h>

#include <algorithm>
#include <string>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

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
