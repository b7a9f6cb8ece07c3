#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/memory/internal/smooth_part.hpp>
#include <nipref/fast/number/internal/complex_inverse.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast::internal {

const SmoothPart& SmoothPart::of(Kernel kernel) {
  static const SmoothPart of_I1(Kernel::I1), of_I3(Kernel::I3);
  return kernel == Kernel::I1 ? of_I1 : of_I3;
}

SmoothPart::SmoothPart(Kernel kernel) {
  const auto value = [kernel](double w) {
    if (kernel == Kernel::I3) return I3(w);
    double at[] = {w};
    regular_I1(at, at);
    return at[0];
  };
  for (std::size_t k = 0; k < points; ++k) {
    for (std::size_t j = 0; j < points; ++j) {
      const double angle = (static_cast<double>(j) + 0.5) * std::numbers::pi / points;
      coefficients_[0][k] +=
          2.0 / points * value(half * std::cos(angle)) * std::cos(static_cast<double>(k) * angle);
    }
  }
  for (std::size_t order = 1; order < coefficients_.size(); ++order) {
    // c'_(k-1) = c'_(k+1) + 2 k c_k; the first coefficients count twice.
    const auto& now = coefficients_[order - 1];
    auto& next = coefficients_[order];
    for (std::size_t k = points - 1; k > 0; --k)
      next[k - 1] = next[k + 1] + 2 * static_cast<double>(k) * now[k] / half;
  }
  count();
}

void SmoothPart::count() {
  constexpr double negligible = 1e-18;
  for (std::size_t order = 0; order < coefficients_.size(); ++order) {
    const double tolerance =
        negligible * std::pow(by_parts_from, std::max(static_cast<double>(order) - 1, 0.0));
    std::size_t& count = counts_[order] = points;
    for (double tail = 0; count > 1; --count) {
      tail += std::fabs(coefficients_[order][count - 1]);
      if (tail > tolerance) break;
    }
  }
}

double SmoothPart::operator()(int order, double w) const {
  double value[1];
  at(order, {&w, 1}, value);
  return value[0];
}

void SmoothPart::at(int order, std::span<const double> w, std::span<double> values) const {
  constexpr std::size_t at_once = 8;
  const auto& c = coefficients_[static_cast<std::size_t>(order)];
  for (std::size_t first = 0; first < w.size(); first += at_once) {
    const std::size_t count = std::min(at_once, w.size() - first);
    std::array<double, at_once> t{}, above{}, here{};
    for (std::size_t i = 0; i < count; ++i) t[i] = w[first + i] / half;
    for (std::size_t k = counts_[static_cast<std::size_t>(order)] - 1; k > 0; --k) {
      for (std::size_t i = 0; i < at_once; ++i)
        above[i] = std::exchange(here[i], 2 * t[i] * here[i] - above[i] + c[k]);
    }
    for (std::size_t i = 0; i < count; ++i) values[first + i] = t[i] * here[i] - above[i] + c[0] / 2;
  }
}

Complex smooth_memory_by_parts(Kernel kernel, int first, double w, Complex rate) {
  constexpr double negligible = 1e-20;
  const SmoothPart& smooth = SmoothPart::of(kernel);
  const Complex kept = faded_exp(rate * (nearest - w)), step = inverse(rate);
  Complex sum = 0, power = step;
  for (int order = first; order <= SmoothPart::derivatives; ++order, power *= step) {
    sum += (kept == 0.0 ? smooth(order, w) : smooth(order, w) - kept * smooth(order, nearest)) * power;
    if (std::norm(power) < negligible * negligible * std::norm(step)) break;
  }
  return sum;
}

}  // namespace nipref::fast::internal
