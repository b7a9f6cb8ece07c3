#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

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
  const AuditPlan plan(quantity, options);
  std::vector<Point> points;
  for (std::size_t block = 0; block < plan.blocks(); ++block)
    std::ranges::move(plan.points(block), std::back_inserter(points));
  return points;
}

namespace {

AuditResult audit_of(QuantityWork work, const OnProgress& on_progress) {
  for (std::size_t block = 0; block < work.blocks(); ++block) {
    const auto progress = [&](double part) {
      if (on_progress) on_progress((static_cast<double>(block) + part) / static_cast<double>(work.blocks()));
    };
    work.add(block, work.found_in(block, progress));
  }
  return work.result();
}

}  // namespace

AuditResult audit(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options) {
  return audit_of({quantity, options, evaluator, false, true}, options.progress);
}

AuditResult audit(const Quantity& quantity, const AuditOptions& options) {
  return audit_of({quantity, options, true}, options.progress);
}

AuditResult audit_values(const Quantity& quantity, std::span<const Point> points,
                         std::span<const double> values, const AuditOptions& options) {
  const Evaluator none;
  const Comparator comparator(quantity, none, options, true);
  std::vector<std::optional<Finding>> findings(points.size());
  parallel_for(
      points.size(), [&](std::size_t i) { findings[i] = comparator(points[i], values[i]); },
      options.progress);
  const Compared compared = compared_of({points.begin(), points.end()}, findings);
  AuditResult result = result_of(quantity, options, tally_of(compared), points.front());
  add_places(result.spread, quantity, compared.points, compared.findings);
  return result;
}

}  // namespace nipref::verify
