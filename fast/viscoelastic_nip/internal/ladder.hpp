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

/// A rolling contact solved with more and more terms until the accuracy is met, as ElasticNipLadder does for the
/// elastic ones: the last three solutions are kept, and what they differ by estimates the error.
class ViscoelasticLadder {
 public:
  using Functional = std::function<double(const ViscoelasticPressure&)>;

  /// Half length A (half-thicknesses) given.
  static ViscoelasticLadder at_half_length(double half_length, const ViscoelasticMaterial& material,
                                           double accuracy);
  /// Dimensionless load given (unit: ViscoelasticPressure).
  static ViscoelasticLadder at_load(double load, const ViscoelasticMaterial& material, double accuracy);

  /// Value on the last solution and an estimate of its error: see estimate_from_levels; not less than a tenth
  /// of what the whole solution is estimated to lack, nor than rounding, kernels and the load's last residual
  /// make, relative to `scale` (the value itself if that is larger).
  [[nodiscard]] Estimate estimate(const Functional& functional, double scale = 0) const;

  /// The same for a functional whose value may be far smaller than A though its rounding is not: the accuracy
  /// is asked of the value itself, and rounding is relative to A.
  [[nodiscard]] Estimate estimate_down_to_rounding(const Functional& functional) const;

  [[nodiscard]] const ViscoelasticPressure& last() const { return *solutions_[2]; }
  /// For what is computed from the solutions.
  [[nodiscard]] CountedKernels kernels() const {
    return {Accuracy(std::max(tolerance_, Accuracy::best_rtol)), *work_};
  }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  using Step = std::function<std::unique_ptr<ViscoelasticPressure>(double near, int level)>;

  ViscoelasticLadder(const ViscoelasticMaterial& material, double accuracy);
  void climb(double near, const Step& step);
  [[nodiscard]] std::unique_ptr<ViscoelasticPressure> solve(double half_length, double near, int level) const;
  [[nodiscard]] std::unique_ptr<ViscoelasticPressure> solve_for_load(double load, double near, int level);
  [[nodiscard]] Estimate own_estimate(const Functional& functional) const;
  [[nodiscard]] double largest_relative_error() const;

  ViscoelasticMaterial material_;
  double accuracy_;
  double tolerance_;
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
  std::array<std::unique_ptr<ViscoelasticPressure>, 3> solutions_;
  double relative_error_ = 1;
  double load_residual_ = 0;
  double slope_ = LengthSearch::usual_slope;
};

}  // namespace nipref::fast
