#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/block.hpp>
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

/// All blocks, and all their points, which the spread needs.
AuditResult audit_of(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options,
                     bool is_fast) {
  const Judge judge(quantity, evaluator, options, !options.ranges.empty(), is_fast);
  const AuditPlan plan(quantity, options);
  AuditTally total;
  Compared all;
  for (std::size_t block = 0; block < plan.blocks(); ++block) {
    const std::size_t before = total.points;
    const auto told = [&](std::size_t done) { options.progress(before + done); };
    total.add(audit_block(quantity, options.ranges, judge, plan, block,
                          options.progress ? std::function<void(std::size_t)>(told) : nullptr, &all));
  }
  AuditResult result = result_of(quantity, options, total, plan.points(0).front());
  add_places(result.spread, quantity, all.points, all.findings);
  return result;
}

}  // namespace

AuditResult audit(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options) {
  return audit_of(quantity, evaluator, options, false);
}

AuditResult audit(const Quantity& quantity, const AuditOptions& options) {
  return audit_of(quantity, fast_evaluator(quantity, options.accuracy), options, true);
}

AuditResult audit_values(const Quantity& quantity, std::span<const Point> points,
                         std::span<const double> values, const AuditOptions& options) {
  const Evaluator none;
  const Judge judge(quantity, none, options, true);
  std::vector<std::optional<Finding>> findings(points.size());
  parallel_for(
      points.size(), [&](std::size_t i) { findings[i] = judge(points[i], values[i]); }, options.progress);
  const Compared compared = compared_of({points.begin(), points.end()}, findings);
  AuditResult result = result_of(quantity, options, tally_of(compared), points.front());
  add_places(result.spread, quantity, compared.points, compared.findings);
  return result;
}

}  // namespace nipref::verify
