#pragma once
#include <span>
#include <vector>

#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/accuracy.hpp>

namespace nipref::fast {

/// The sheet kernels in batches, with their evaluations counted.
class CountedKernels {
 public:
  /// Counts into `work`, which outlives this.
  CountedKernels(Accuracy accuracy, Work& work) : accuracy_(accuracy), work_(work) {}

  [[nodiscard]] std::vector<double> I1(std::span<const double> alpha);
  [[nodiscard]] std::vector<double> I3(std::span<const double> alpha);
  /// The same plus ln|alpha|.
  [[nodiscard]] std::vector<double> regular_I1(std::span<const double> alpha);
  [[nodiscard]] std::vector<double> regular_I6(std::span<const double> alpha);
  /// I6(alpha, 0): by symmetry the terms in eta cancel in pairs.
  [[nodiscard]] std::vector<double> I6(std::span<const double> alpha);

  void count_system(int unknowns);

 private:
  void count_values(int kernel, std::size_t values);

  Accuracy accuracy_;
  Work& work_;
};

}  // namespace nipref::fast
