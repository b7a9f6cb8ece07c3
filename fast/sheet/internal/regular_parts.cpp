#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <nipref/fast/sheet/internal/dispatch.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast::internal {
namespace {

/// Below near_end the constant plus the tabulated rest, elsewhere the kernel plus ln|alpha|. `kernel` evaluates a batch.
template <class KernelOf>
void regular_part(Component component, const KernelOf& kernel, std::span<const double> alpha,
                  std::span<const double> logarithm, std::span<double> value) {
  const auto rest = [&](std::span<const double> at, std::span<double> to) {
    sheet_code().even_rest(component, 0, 1, at.data(), to.data(), at.size());
  };
  const double place[] = {0.375};
  double there[1], rest_there[1];
  kernel(place, there);
  rest(place, rest_there);
  const double constant = there[0] + std::log(place[0]) - rest_there[0];

  // Where |alpha| < near_end, the batch evaluates the kernel at near_end, and the result is not used.
  std::vector<double> far(alpha.size()), near;
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    far[i] = std::max(std::fabs(alpha[i]), near_end);
    if (std::fabs(alpha[i]) < near_end) near.push_back(alpha[i]);
  }
  kernel(far, far);
  rest(near, near);
  for (std::size_t i = 0, next = 0; i < alpha.size(); ++i)
    value[i] = std::fabs(alpha[i]) < near_end ? near[next++] + constant : far[i] + logarithm[i];
}

std::vector<double> logarithms(std::span<const double> alpha) {
  std::vector<double> result;
  result.reserve(alpha.size());
  for (const double one : alpha) result.push_back(std::log(std::fabs(one)));
  return result;
}

}  // namespace

void regular_I1(std::span<const double> alpha, std::span<const double> logarithm, std::span<double> value) {
  regular_part(
      Component::I1, [](std::span<const double> at, std::span<double> to) { I1(at, to); }, alpha, logarithm,
      value);
}

void regular_I6(std::span<const double> alpha, std::span<const double> logarithm, std::span<double> value) {
  regular_part(
      Component::alpha_part_of_I6,
      [](std::span<const double> at, std::span<double> to) { I6(at, std::vector<double>(at.size()), to); },
      alpha, logarithm, value);
}

void regular_I1(std::span<const double> alpha, std::span<double> value) {
  regular_I1(alpha, logarithms(alpha), value);
}

void regular_I6(std::span<const double> alpha, std::span<double> value) {
  regular_I6(alpha, logarithms(alpha), value);
}

}  // namespace nipref::fast::internal
