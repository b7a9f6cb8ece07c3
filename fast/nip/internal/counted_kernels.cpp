#include <algorithm>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/number/internal/tiers.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {

void CountedKernels::count_values(int kernel, std::size_t values) {
  work_.kernel_evaluations[static_cast<std::size_t>(kernel - 1)] += values;
  work_.terms += values * static_cast<std::size_t>(internal::tier_works[accuracy_.tier()].piece + 1);
}

void CountedKernels::count_system(int unknowns) {
  ++work_.systems;
  work_.unknowns = std::max(work_.unknowns, unknowns);
}

std::vector<double> CountedKernels::I1(std::span<const double> alpha) {
  std::vector<double> values(alpha.size());
  fast::I1(alpha, values, accuracy_);
  count_values(1, values.size());
  return values;
}

std::vector<double> CountedKernels::regular_I1(std::span<const double> alpha) {
  std::vector<double> values(alpha.size());
  internal::regular_I1(alpha, values);
  count_values(1, values.size());
  return values;
}

std::vector<double> CountedKernels::regular_I6(std::span<const double> alpha) {
  std::vector<double> values(alpha.size());
  internal::regular_I6(alpha, values);
  count_values(6, values.size());
  return values;
}

std::vector<double> CountedKernels::I3(std::span<const double> alpha) {
  std::vector<double> values(alpha.size());
  fast::I3(alpha, values, accuracy_);
  count_values(3, values.size());
  return values;
}

std::vector<double> CountedKernels::I6(std::span<const double> alpha) {
  const std::vector<double> eta(alpha.size(), 0.0);
  std::vector<double> values(alpha.size());
  fast::I6(alpha, eta, values, accuracy_);
  count_values(6, values.size());
  return values;
}

}  // namespace nipref::fast
