#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include <nipref/fast/sheet/internal/dispatch.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast::internal {
namespace {

/// Near 0 the constant and the tabulated rest, beyond it the kernel itself; `kernel` is that of a batch.
template <class KernelOf>
void regular_part(Component component, const KernelOf& kernel, std::span<const double> alpha,
                  std::span<double> value) {
  const auto rest = [&](std::span<const double> at, std::span<double> to) {
    sheet_code().even_rest(component, 0, 1, at.data(), to.data(), at.size());
  };
  const double place[] = {0.375};
  double there[1], rest_there[1];
  kernel(place, there);
  rest(place, rest_there);
  const double constant = there[0] + std::log(place[0]) - rest_there[0];

  std::vector<std::size_t> far;
  std::vector<double> far_alpha;
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    if (std::fabs(alpha[i]) < near_end) continue;
    far.push_back(i);
    far_alpha.push_back(alpha[i]);
  }
  if (far.size() < alpha.size()) rest(alpha, value);
  for (double& v : value) v += constant;
  std::vector<double> far_value(far.size());
  kernel(far_alpha, far_value);
  const auto count = static_cast<Eigen::Index>(far.size());
  Eigen::Map<Eigen::ArrayXd>(far_value.data(), count) +=
      Eigen::Map<const Eigen::ArrayXd>(far_alpha.data(), count).abs().log();
  for (std::size_t i = 0; i < far.size(); ++i) value[far[i]] = far_value[i];
}

}  // namespace

void regular_I1(std::span<const double> alpha, std::span<double> value) {
  regular_part(
      Component::I1, [](std::span<const double> at, std::span<double> to) { I1(at, to); }, alpha, value);
}

void regular_I6(std::span<const double> alpha, std::span<double> value) {
  regular_part(
      Component::alpha_part_of_I6,
      [](std::span<const double> at, std::span<double> to) { I6(at, std::vector<double>(at.size()), to); },
      alpha, value);
}

}  // namespace nipref::fast::internal
