#pragma once
#include <Eigen/Core>
#include <span>

#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/accuracy.hpp>

namespace nipref::fast {

/// Evaluates the sheet kernels in batches and counts the evaluations.
class CountedKernels {
 public:
  using Alphas = std::span<const double>;
  /// Adds the counts to `work`, which must outlive this.
  CountedKernels(Accuracy accuracy, Work& work) : accuracy_(accuracy), work_(work) {}

  [[nodiscard]] Eigen::RowVectorXd I1(Alphas alpha);
  [[nodiscard]] Eigen::RowVectorXd I3(Alphas alpha);
  /// I6(alpha, 0): by symmetry the terms in eta cancel in pairs.
  [[nodiscard]] Eigen::RowVectorXd I6(Alphas alpha);
  /// I1(alpha) and I6(alpha, 0), each plus ln|alpha|; `logarithm` is ln|alpha|.
  [[nodiscard]] Eigen::RowVectorXd regular_I1(Alphas alpha, Alphas logarithm);
  [[nodiscard]] Eigen::RowVectorXd regular_I6(Alphas alpha, Alphas logarithm);

 private:
  [[nodiscard]] Eigen::RowVectorXd counted(std::size_t kernel, Alphas alpha, const auto& evaluate);

  Accuracy accuracy_;
  Work& work_;
};

}  // namespace nipref::fast
