#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

Evaluator fast_evaluator(const Quantity& quantity, fast::Accuracy accuracy) {
  return [&quantity, accuracy](std::span<const Point> points, std::span<double> values) {
    std::ranges::transform(points, values.begin(),
                           [&](const Point& point) { return fast_value(quantity, point, accuracy); });
  };
}

std::size_t AuditOptions::points_of(const Quantity& quantity) const {
  if (points > 0) return points;
  return static_cast<std::size_t>(
      std::max(1.0, std::round(density * static_cast<double>(quantity.audit_points))));
}

std::vector<Point> audit_points(const Quantity& quantity, const AuditOptions& options) {
  const QuantityWork work(quantity, options);
  std::vector<Point> points;
  for (std::size_t block = 0; block < work.blocks(); ++block)
    std::ranges::move(work.points(block), std::back_inserter(points));
  return points;
}

AuditResult audit(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options) {
  QuantityWork work(quantity, options, true, evaluator);
  for (std::size_t block = 0; block < work.blocks(); ++block) {
    work.do_block(block, [&](double part) {
      if (options.progress)
        options.progress((static_cast<double>(block) + part) / static_cast<double>(work.blocks()));
    });
  }
  return work.result();
}

AuditResult audit(const Quantity& quantity, const AuditOptions& options) {
  return audit(quantity, Evaluator(), options);
}

std::string point_text(const Quantity& quantity, const Point& point) {
  std::string text;
  const auto both = [](double x) { return fmt::format("{:.6g} ({:a})", x, x); };
  for (const auto& [name, value] : written_point(quantity, point, both))
    text += fmt::format(" {}={}", name, value);
  return text;
}

Json point_json(const Quantity& quantity, const Point& point) {
  return json_object(written_point(quantity, point, [](double x) { return fmt::format("{:a}", x); }));
}

Json audit_row_json(const AuditResult& result) {
  return {{"quantity", result.quantity->name},
          {"points", result.points},
          {"left_out", result.left_out},
          {"_left_out", result.left_out > 0 ? Json(result.left_out) : Json()},
          {"max_error_ulp", result.max_error_ulp},
          {"mean_error_ulp", result.errors.mean()},
          {"median_error_ulp", result.errors.percentile(0.5)},
          {"percentile_90_ulp", result.errors.percentile(0.9)},
          {"percentile_99_ulp", result.errors.percentile(0.99)},
          {"percentile_99_9_ulp", result.errors.percentile(0.999)},
          {"max_relative_error", result.max_relative_error},
          {"promise_ulp", result.promise},
          {"allowance_used", result.allowance_used},
          {"passed", result.kept()},
          {"fault_width", result.fault_width()},
          {"worst", point_json(*result.quantity, result.worst)}};
}

Json audit_json(const std::vector<AuditResult>& results) { return json_list(results, audit_row_json); }

}  // namespace nipref::verify
