#include <nipref/verify/audit/internal/block.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

namespace nipref::verify {

Comparator::Comparator(const Quantity& quantity, Evaluator evaluator, const AuditOptions& options)
    : quantity_(quantity),
      accuracy_(options.accuracy),
      promise_(options.promise_of(quantity)),
      absolute_(options.absolute),
      checks_own_error_(!evaluator && quantity.fast_error) {
  evaluator_ = evaluator ? std::move(evaluator) : fast_evaluator(quantity, accuracy_);
}

void Comparator::operator()(std::span<const Point> points, std::span<std::optional<Finding>> findings) const {
  std::vector<std::optional<ref::Estimate>> truths;
  std::vector<Point> known;
  for (const Point& point : points) {
    truths.push_back(truth(point));
    if (truths.back()) known.push_back(point);
  }
  const auto found = values(known);
  for (std::size_t i = 0, next = 0; i < points.size(); ++i) {
    if (!truths[i]) continue;
    if (const auto value = found[next++]) findings[i] = finding(*value, *truths[i], points[i]);
  }
}

std::vector<std::optional<double>> Comparator::values(std::span<const Point> points) const {
  try {
    std::vector<double> found(points.size());
    evaluator_(points, found);
    return {found.begin(), found.end()};
  } catch (const data::BadInput&) {
    if (points.size() == 1) return {std::nullopt};
  }
  // Which of them are refused?
  std::vector<std::optional<double>> found;
  for (const Point& point : points) found.push_back(values({&point, 1}).front());
  return found;
}

std::optional<Finding> Comparator::operator()(const Point& point) const {
  std::optional<Finding> finding;
  (*this)({&point, 1}, {&finding, 1});
  return finding;
}

std::optional<Finding> Comparator::operator()(const Point& point, double value) const {
  const auto known = truth(point);
  return known ? std::optional(finding(value, *known, point)) : std::nullopt;
}

std::optional<ref::Estimate> Comparator::truth(const Point& point) const {
  return unless_refused([&] { return ref_value(quantity_, point, digits_beyond_double); });
}

Finding Comparator::finding(double value, const ref::Estimate& truth, const Point& point) const {
  const Deviation found = deviation(value, truth, quantity_.envelope(point));
  return {found.ulps, found.relative, found.ulps == 0 ? 0 : found.ulps / allowed_ulps(found.scale, point)};
}

double Comparator::allowed_ulps(double scale, const Point& point) const {
  const double allowed = std::max(promise_, tolerated_ulps(scale));
  if (!checks_own_error_) return allowed;
  return std::min(allowed, quantity_.fast_error(point, accuracy_) / ulp_of(scale));
}

double Comparator::tolerated_ulps(double scale) const {
  const double of_scale = accuracy_.rtol() > fast::Accuracy::best_rtol ? accuracy_.rtol() * scale : 0;
  return std::max(of_scale, absolute_) / ulp_of(scale);
}

}  // namespace nipref::verify
