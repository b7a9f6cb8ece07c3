#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/fast/viscoelastic_nip/internal/pressure.hpp>

namespace nipref::fast {

/// A rolling contact solved with more and more terms until the accuracy is met, as ContactLadder does for the
/// elastic ones: the last three solutions are kept, and what they differ by estimates the error.
class RollingLadder {
 public:
  using Functional = std::function<double(const RollingPressure&)>;

  /// Half length A (half-thicknesses) given.
  static RollingLadder at_half_length(double half_length, const RollingMaterial& material, double accuracy);
  /// Dimensionless load given (unit: RollingPressure).
  static RollingLadder at_load(double load, const RollingMaterial& material, double accuracy);

  /// Value on the last solution and an estimate of its error: see estimate_from_levels; not less than a tenth
  /// of what the whole solution is estimated to lack, nor than rounding, kernels and the load's last residual
  /// make, relative to `scale` (the value itself if that is larger).
  [[nodiscard]] Estimate estimate(const Functional& functional, double scale = 0) const;

  /// The same for a functional whose value may be far smaller than A though its rounding is not: the accuracy
  /// is asked of the value itself, and rounding is relative to A.
  [[nodiscard]] Estimate estimate_down_to_rounding(const Functional& functional) const;

  [[nodiscard]] const RollingPressure& last() const { return *solutions_[2]; }
  /// For what is computed from the solutions.
  [[nodiscard]] ContactKernels kernels() const {
    return {Accuracy(std::max(tolerance_, Accuracy::kBest)), *work_};
  }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] const ContactWork& work() const { return *work_; }

 private:
  using Step = std::function<std::unique_ptr<RollingPressure>(double near, int level)>;

  RollingLadder(const RollingMaterial& material, double accuracy);
  void climb(double near, const Step& step);
  [[nodiscard]] std::unique_ptr<RollingPressure> solve(double half_length, double near, int level) const;
  [[nodiscard]] std::unique_ptr<RollingPressure> solve_for_load(double load, double near, int level);
  [[nodiscard]] Estimate own_estimate(const Functional& functional) const;
  [[nodiscard]] double largest_relative_error() const;

  RollingMaterial material_;
  double accuracy_;
  double tolerance_;
  std::unique_ptr<ContactWork> work_ = std::make_unique<ContactWork>();
  std::array<std::unique_ptr<RollingPressure>, 3> solutions_;
  double relative_error_ = 1;
  double load_residual_ = 0;
  double slope_ = LengthSearch::usual_slope;
};

}  // namespace nipref::fast
