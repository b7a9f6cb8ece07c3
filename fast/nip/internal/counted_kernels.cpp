#include <algorithm>
#include <functional>
#include <vector>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/number/internal/tiers.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {

using Eigen::RowVectorXd;

RowVectorXd CountedKernels::counted(std::size_t kernel, Alphas alpha, const auto& evaluate) {
  RowVectorXd values(static_cast<Eigen::Index>(alpha.size()));
  evaluate(std::span(values.data(), alpha.size()));
  work_.kernel_evaluations[kernel - 1] += alpha.size();
  work_.terms += alpha.size() * static_cast<std::size_t>(internal::tier_works[accuracy_.tier()].piece + 1);
  return values;
}

Work& Work::operator+=(const Work& other) {
  std::ranges::transform(kernel_evaluations, other.kernel_evaluations, kernel_evaluations.begin(),
                         std::plus());
  terms += other.terms;
  systems += other.systems;
  unknowns = std::max(unknowns, other.unknowns);
  line_responses += other.line_responses;
  return *this;
}

RowVectorXd CountedKernels::I1(Alphas alpha) {
  return counted(1, alpha, [&](auto values) { fast::I1(alpha, values, accuracy_); });
}
RowVectorXd CountedKernels::I3(Alphas alpha) {
  return counted(3, alpha, [&](auto values) { fast::I3(alpha, values, accuracy_); });
}
RowVectorXd CountedKernels::I6(Alphas alpha) {
  const std::vector<double> eta(alpha.size(), 0.0);
  return counted(6, alpha, [&](auto values) { fast::I6(alpha, eta, values, accuracy_); });
}
RowVectorXd CountedKernels::regular_I1(Alphas alpha, Alphas logarithm) {
  return counted(1, alpha, [&](auto values) { internal::regular_I1(alpha, logarithm, values); });
}
RowVectorXd CountedKernels::regular_I6(Alphas alpha, Alphas logarithm) {
  return counted(6, alpha, [&](auto values) { internal::regular_I6(alpha, logarithm, values); });
}

}  // namespace nipref::fast
