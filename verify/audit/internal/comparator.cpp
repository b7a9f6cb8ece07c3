#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

namespace nipref::verify {

Comparator::Comparator(const Quantity& quantity, Evaluator evaluator, const AuditOptions& options)
    : quantity_(quantity), options_(options), checks_own_error_(!evaluator && quantity.fast_error) {
  evaluator_ = evaluator ? std::move(evaluator) : fast_evaluator(quantity, options.accuracy);
}

std::vector<Finding> Comparator::operator()(std::span<const Point> points) const {
  std::vector<Point> known;
  std::vector<ref::Estimate> truths;
  for (const Point& point : points) {
    std::optional<ref::Estimate> truth = truth_at(point);
    if (!truth) continue;
    truths.push_back(*std::move(truth));
    known.push_back(point);
  }
  std::vector<double> values(known.size());
  evaluator_(known, values);
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < known.size(); ++i) findings.push_back(finding(known[i], values[i], truths[i]));
  return findings;
}

std::optional<Finding> Comparator::operator()(const Point& point, double value) const {
  const auto truth = truth_at(point);
  return truth ? std::optional(finding(point, value, *truth)) : std::nullopt;
}

std::optional<ref::Estimate> Comparator::truth_at(const Point& point) const {
  return unless_refused([&] { return ref_value(quantity_, point, digits_beyond_double); });
}

Finding Comparator::finding(const Point& point, double value, const ref::Estimate& truth) const {
  const Deviation found = deviation(value, truth, quantity_.envelope(point));
  const double ulp = ulp_of(found.scale), rtol = options_.accuracy.rtol();
  const double of_scale = rtol > fast::Accuracy::best_rtol ? rtol * found.scale : 0;
  double allowed = std::max(options_.promise_of(quantity_), std::max(of_scale, options_.absolute) / ulp);
  if (checks_own_error_) allowed = std::min(allowed, quantity_.fast_error(point, options_.accuracy) / ulp);
  return {point, found.ulps, found.relative, found.ulps == 0 ? 0 : found.ulps / allowed};
}

}  // namespace nipref::verify
