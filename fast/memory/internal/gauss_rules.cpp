#include <algorithm>
#include <array>
#include <cmath>

#include <nipref/fast/memory/internal/gauss_rules.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal {
namespace {

constexpr int rules[] = {8, 10, 16, 32};

const GaussRule& rule(int index) {
  static const std::array<GaussRule, std::size(rules)> all = [] {
    std::array<GaussRule, std::size(rules)> made;
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = gauss_legendre(rules[i]);
    return made;
  }();
  return all[static_cast<std::size_t>(index)];
}

/// The index of the Gauss rule. Its degree 2 n has to be about 12 + 0.85 x for e^(-x s) on [0, 1] at full accuracy,
/// and 30 for the kernels, whose singularities are at least a quarter of the interval away.
int rule_for(double decays, double ratio, Accuracy accuracy) {
  const bool easy = decays <= 6 && ratio <= 3;
  if (accuracy.rtol() >= 1e-8) return easy ? 0 : 2;
  return easy ? 2 : 3;
}

/// The kernel at a rule's points between v > 0 and v + step.
void kernel_between(Kernel kernel, double v, double step, const GaussRule& rule, Nodes& values,
                    Accuracy accuracy) {
  Nodes points;
  const std::size_t count = rule.at.size();
  for (std::size_t i = 0; i < count; ++i) points[i] = v + step * rule.at[i];
  sheet_code().batch[static_cast<int>(kernel)][accuracy.tier()](points.data(), values.data(), count);
}

/// The kernels at the rules' points on the intervals that most integrals consist of: [1/2, 1] and, for the kernels
/// without logarithm, [0, 1/2], each in both directions.
struct WholePieces {
  Nodes value[kernel_count][2][2][std::size(rules)];

  WholePieces() {
    for (int kernel = 0; kernel < kernel_count; ++kernel) {
      for (int outer = kernel == 0 ? 1 : 0; outer < 2; ++outer) {
        for (int i = 0; i < static_cast<int>(std::size(rules)); ++i) {
          const double near = outer * inner_end;
          kernel_between(static_cast<Kernel>(kernel), near, inner_end, rule(i), value[kernel][outer][1][i],
                         {});
          kernel_between(static_cast<Kernel>(kernel), near + inner_end, -inner_end, rule(i),
                         value[kernel][outer][0][i], {});
        }
      }
    }
  }
};

const Nodes* whole_piece(Kernel kernel, double v, int step, double length, int index) {
  if (length != inner_end) return nullptr;
  const double near = step > 0 ? v : v - length;
  if (near != inner_end && (near != 0 || kernel == Kernel::I1)) return nullptr;
  static const WholePieces all;
  return &all.value[static_cast<int>(kernel)][near > 0][step > 0][index];
}

}  // namespace

const GaussRule& gauss_rule_for(double decays, Accuracy accuracy) {
  return rule(decays <= 2 ? 1 : rule_for(decays, 1, accuracy));
}

double faded_sum(const GaussRule& rule, const Nodes& values, double length, double rate) {
  const std::size_t count = rule.at.size();
  Nodes decay;
  sheet_code().decays(rate * length, rule.at.data(), decay.data(), count);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += rule.weight[i] * values[i] * decay[i];
  return length * sum;
}

Complex faded_sum(const GaussRule& rule, const Nodes& values, double length, Complex rate) {
  Complex sum = 0;
  for (std::size_t i = 0; i < rule.at.size(); ++i)
    sum += rule.weight[i] * values[i] * faded_exp(rate * (length * rule.at[i]));
  return length * sum;
}

template <typename Rate>
Rate by_rule(Kernel kernel, double v, int step, double length, Rate rate, Accuracy accuracy) {
  const double end = v + step * length;
  const double ratio = kernel == Kernel::I1 ? std::max(v, end) / std::min(v, end) : 2;
  const int index = rule_for(std::abs(rate) * length, ratio, accuracy);
  const GaussRule& gauss = rule(index);
  Nodes computed;
  const Nodes* value = whole_piece(kernel, v, step, length, index);
  if (!value) {
    kernel_between(kernel, v, step * length, gauss, computed, accuracy);
    value = &computed;
  }
  return faded_sum(gauss, *value, length, rate);
}

template double by_rule(Kernel, double, int, double, double, Accuracy);
template Complex by_rule(Kernel, double, int, double, Complex, Accuracy);

}  // namespace nipref::fast::internal
