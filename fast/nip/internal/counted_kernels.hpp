#pragma once
#include <Eigen/Core>
#include <span>

#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/accuracy.hpp>

namespace nipref::fast {

/// The sheet kernels in batches, with their evaluations counted.
class CountedKernels {
 public:
  using Alphas = std::span<const double>;
  /// Counts into `work`, which outlives this.
  CountedKernels(Accuracy accuracy, Work& work) : accuracy_(accuracy), work_(work) {}

  [[nodiscard]] Eigen::RowVectorXd I1(Alphas alpha);
  [[nodiscard]] Eigen::RowVectorXd I3(Alphas alpha);
  /// I6(alpha, 0): by symmetry the terms in eta cancel in pairs.
  [[nodiscard]] Eigen::RowVectorXd I6(Alphas alpha);
  /// The same plus ln|alpha|, which is known.
  [[nodiscard]] Eigen::RowVectorXd regular_I1(Alphas alpha, Alphas logarithm);
  [[nodiscard]] Eigen::RowVectorXd regular_I6(Alphas alpha, Alphas logarithm);

 private:
  [[nodiscard]] Eigen::RowVectorXd counted(std::size_t kernel, Alphas alpha, const auto& evaluate);

  Accuracy accuracy_;
  Work& work_;
};

}  // namespace nipref::fast
