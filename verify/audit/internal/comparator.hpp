#pragma once
#include <optional>
#include <span>

#include <nipref/verify/audit/audit.hpp>

namespace nipref::verify {

/// Compares an evaluator's values with the reference.
class Comparator {
 public:
  /// Quantity and evaluator must outlive the comparator. If `may_refuse`, the reference may refuse points. If
  /// `is_fast`, the error that fast states for a value, where it states one, must cover the error found.
  Comparator(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options,
             bool may_refuse, bool is_fast = false);

  /// Finds the errors at a batch of points; a point that the reference refuses has none.
  void operator()(std::span<const Point> points, std::span<std::optional<Finding>> findings) const;
  [[nodiscard]] std::optional<Finding> operator()(const Point& point) const;
  /// The same for a value that was computed before.
  [[nodiscard]] std::optional<Finding> operator()(const Point& point, double value) const;

 private:
  [[nodiscard]] std::optional<ref::Estimate> truth(const Point& point) const;
  [[nodiscard]] Finding finding(double value, const ref::Estimate& truth, const Point& point) const;
  [[nodiscard]] double allowed_ulps(double scale, const Point& point) const;
  [[nodiscard]] double tolerated_ulps(double scale) const;

  const Quantity& quantity_;
  const Evaluator& evaluator_;
  fast::Accuracy accuracy_;
  double promise_;
  bool may_refuse_;
  bool checks_own_error_;
};

}  // namespace nipref::verify
