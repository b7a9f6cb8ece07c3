#pragma once
#include <optional>
#include <span>

#include <nipref/verify/audit/audit.hpp>

namespace nipref::verify {

/// Compares an evaluator's values with the reference.
class Judge {
 public:
  /// All of it must outlive this. If `may_refuse`, the reference may refuse points; `is_fast`: what fast says of its
  /// own errors must cover them too.
  Judge(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options, bool may_refuse,
        bool is_fast = false);

  /// Findings at a batch of points; none where the reference refuses a point of the ranges.
  void operator()(std::span<const Point> points, std::span<std::optional<Finding>> findings) const;
  [[nodiscard]] std::optional<Finding> operator()(const Point& point) const;
  /// Of a value that is there already.
  [[nodiscard]] std::optional<Finding> operator()(const Point& point, double value) const;

 private:
  [[nodiscard]] std::optional<Reference> truth(const Point& point) const;
  [[nodiscard]] Finding finding(double value, const Reference& truth, const Point& point) const;
  [[nodiscard]] double allowed_ulps(double scale, const Point& point) const;
  [[nodiscard]] double tolerated_ulps(double scale) const;

  const Quantity& quantity_;
  const Evaluator& evaluator_;
  fast::Accuracy accuracy_;
  double promise_;
  bool may_refuse_;
  bool says_more_;
};

}  // namespace nipref::verify
