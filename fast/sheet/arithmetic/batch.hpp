#pragma once

#include <nipref/fast/sheet/arithmetic/sort.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// The form in which a caller needs a component: rounded to one double, or as two words for further arithmetic.
enum class Words { rounded, two };

/// A component at sorted points: its value, or its high and low words.
struct SortedValues {
  alignas(64) double high[3 * regime_capacity];
  alignas(64) double low[3 * regime_capacity];
};

template <class Number, Regime regime, Component component, int tier, Words words>
NIPREF_INLINE void evaluate_regime(const SortedPoints& points, SortedValues& values) {
  constexpr int32_t first = first_of_regime[static_cast<int>(regime)], step = sizeof(Number) / sizeof(double);
  const int32_t n = (points.count[static_cast<int>(regime)] + lanes - 1) & ~(lanes - 1);
  const double* __restrict x = points.x + first;
  double* __restrict high = values.high + first;
  double* __restrict low = values.low + first;
  for (int32_t i = 0; i < n; i += step) {
    const Sum<Number> value = in_regime<regime, component, tier>(load<Number>(x + i));
    if constexpr (words == Words::rounded) {
      store(high + i, value.high + value.low);
    } else {
      store(high + i, value.high);
      store(low + i, value.low);
    }
  }
}

template <Component component, int tier, Words words>
NIPREF_INLINE void evaluate_sorted(const SortedPoints& points, SortedValues& values) {
  if constexpr (shape_of<component> == Shape::logarithmic) {
    evaluate_regime<Vector, Regime::near_zero, component, tier, words>(points, values);
  }
  evaluate_regime<Vector, Regime::piece, component, tier, words>(points, values);
  // The compiler vectorises this loop over doubles.
  evaluate_regime<double, Regime::residue_tail, component, tier, words>(points, values);
}

}  // namespace nipref::fast::internal::NIPREF_ISA
