#pragma once

#include <nipref/fast/sheet/arithmetic/sort.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// The form in which a caller needs a component: its rounded value, or two words for further arithmetic.
enum class Words { rounded, two };

/// A component at sorted points: its value or high word, and its low word where two are wanted.
struct SortedValues {
  alignas(64) double high[3 * regime_capacity];
  alignas(64) double low[3 * regime_capacity];
};

template <Regime regime, Component component, int tier, Words words>
NIPREF_INLINE void evaluate_regime(const SortedPoints& points, SortedValues& values) {
  constexpr int32_t first = first_of_regime[static_cast<int>(regime)];
  const int32_t n = (points.count[static_cast<int>(regime)] + lanes - 1) & ~(lanes - 1);
  const double* __restrict x = points.x + first;
  double* __restrict high = values.high + first;
  double* __restrict low = values.low + first;
  for (int32_t i = 0; i < n; ++i) {
    const Pair value = in_regime<regime, component, tier>(x[i]);
    if constexpr (words == Words::rounded) {
      high[i] = value.high + value.low;
    } else {
      high[i] = value.high;
      low[i] = value.low;
    }
  }
}

#ifdef NIPREF_VECTORS

template <Regime regime, Component component, int tier>
NIPREF_INLINE VectorPair in_regime(Vector x) {
  if constexpr (regime == Regime::near_zero) return near_zero<component, tier>(x);
  if constexpr (regime == Regime::piece) return piece<component, tier>(x);
}

/// The same for the regimes whose vector form differs from the scalar one.
template <Regime regime, Component component, int tier, Words words>
requires(regime != Regime::residue_tail) NIPREF_INLINE
    void evaluate_regime(const SortedPoints& points, SortedValues& values) {
  const int32_t first = first_of_regime[static_cast<int>(regime)];
  const int32_t last = first + points.count[static_cast<int>(regime)];
  for (int32_t i = first; i < last; i += lanes) {
    const VectorPair value = in_regime<regime, component, tier>(load(points.x + i));
    if constexpr (words == Words::rounded) {
      store(values.high + i, value.high + value.low);
    } else {
      store(values.high + i, value.high);
      store(values.low + i, value.low);
    }
  }
}

#endif

template <Component component, int tier, Words words>
NIPREF_INLINE void evaluate_sorted(const SortedPoints& points, SortedValues& values) {
  if constexpr (shape_of<component> == Shape::logarithmic) {
    evaluate_regime<Regime::near_zero, component, tier, words>(points, values);
  }
  evaluate_regime<Regime::piece, component, tier, words>(points, values);
  evaluate_regime<Regime::residue_tail, component, tier, words>(points, values);
}

}  // namespace nipref::fast::internal::NIPREF_ISA
