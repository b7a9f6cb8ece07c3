#include <numbers>
#include <vector>

#include <nipref/fast/nip/internal/frictionless_kernel.hpp>

namespace nipref::fast {

Tractions::SplitKernel frictionless_kernel(CountedKernels& kernels) {
  const auto of_both_parts = [&kernels](
                                 std::vector<double> (CountedKernels::*kernel)(std::span<const double>)) {
    return [&kernels, kernel](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
      const std::vector<double> values = (kernels.*kernel)(alpha);
      on_p = Eigen::Map<const Eigen::RowVectorXd>(values.data(), static_cast<Eigen::Index>(values.size())) /
             std::numbers::pi;
      on_q = on_p;
    };
  };
  return {{1, true, {}, of_both_parts(&CountedKernels::I1)},
          Eigen::RowVector2d(1, 1),
          Eigen::RowVector2d(0, 0),
          of_both_parts(&CountedKernels::regular_I1)};
}

}  // namespace nipref::fast
