#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/elastic_nip/internal/half_contact.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// A contact solved with more and more terms, each time half as many again, until the accuracy is met; the
/// last three solutions are kept, and what they differ by estimates the error of anything computed from them.
class ElasticNipLadder {
 public:
  using Functional = std::function<double(const HalfContact&)>;

  /// Half length A (half-thicknesses) given.
  static ElasticNipLadder at_half_length(double half_length, data::Friction friction, double poisson,
                                         double accuracy);
  /// Dimensionless load given (unit: HalfContact).
  static ElasticNipLadder at_load(double load, data::Friction friction, double poisson, double accuracy);

  /// Value on the last solution. Its error: from the last two differences d0 and d1 as 3 d1 min(1, d1/d0),
  /// for where the terms grow by half each time a geometric convergence has less than d1 d1/d0 left; not less
  /// than a tenth of what the whole solution is estimated to lack, nor than what rounding, the kernels' own
  /// tolerance and the load's last residual make, all relative to `scale` (the value itself if that is
  /// larger).
  [[nodiscard]] Estimate estimate(const Functional& functional, double scale = 0) const;

  [[nodiscard]] const HalfContact& last() const { return *solutions_[2]; }
  /// For what is computed from the solutions.
  [[nodiscard]] CountedKernels kernels() const {
    return {Accuracy(std::max(tolerance_, Accuracy::best_rtol)), *work_};
  }
  [[nodiscard]] const Work& work() const { return *work_; }
  /// Of the quadrature of what is computed from the solutions: stricter than theirs, for their differences do
  /// not show it.
  [[nodiscard]] double tolerance() const { return tolerance_; }

 private:
  /// Solution number `level`, its terms laid out for a half length near `near`.
  using Step = std::function<std::unique_ptr<HalfContact>(double near, int level)>;

  ElasticNipLadder(data::Friction friction, double poisson, double accuracy);
  void climb(double near, double accuracy, const Step& step);
  [[nodiscard]] std::unique_ptr<HalfContact> solve(double half_length, double near, int level) const;
  [[nodiscard]] std::unique_ptr<HalfContact> solve_for_load(double load, double near, int level,
                                                            double enough);
  [[nodiscard]] Estimate own_estimate(const Functional& functional) const;
  [[nodiscard]] double largest_relative_error() const;

  data::Friction friction_;
  double poisson_;
  double tolerance_;
  Accuracy kernel_accuracy_;
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
  std::array<std::unique_ptr<HalfContact>, 3> solutions_;
  double relative_error_ = 1;
  double load_residual_ = 0;
};

}  // namespace nipref::fast
