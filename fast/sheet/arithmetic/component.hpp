#pragma once

#include <nipref/fast/sheet/arithmetic/coarse.hpp>
#include <nipref/fast/sheet/arithmetic/piece.hpp>
#include <nipref/fast/sheet/arithmetic/residue_tail.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// The regimes of the argument x.
///
///   0 <= x < 1/2    logarithmic components: -ln x + even remainder; others: pieces
///   1/2 <= x < 12   pieces
///   12 <= x         limit and first residue
///
/// Coarse tiers treat the first two regimes as one.
enum class Regime { near_zero, piece, residue_tail };

template <Regime regime, Component component, int tier, class Number>
NIPREF_INLINE Sum<Number> in_regime(Number x) {
  if constexpr (regime == Regime::near_zero) return near_zero<component, tier>(x);
  if constexpr (regime == Regime::piece) return piece<component, tier>(x);
  if constexpr (regime == Regime::residue_tail) return residue_tail<component, tier>(x);
}

template <Component component>
NIPREF_INLINE bool is_near_zero(double x) {
  return shape_of<component> == Shape::logarithmic && x < near_end;
}

template <Component component, int tier>
NIPREF_INLINE Pair evaluate(double x) {
  if (x >= piece_end) [[unlikely]]
    return residue_tail<component, tier>(x);
  if constexpr (tier_works[tier].coarse) {
    return {coarse<component, tier>(x), 0};
  } else {
    return is_near_zero<component>(x) ? near_zero<component, tier>(x) : piece<component, tier>(x);
  }
}

/// f(-x) from f(x).
template <Component component>
NIPREF_INLINE double with_symmetry(double value, double argument) {
  return shape_of<component> == Shape::odd ? __builtin_copysign(value, argument) : value;
}

/// (pi/4)(e - a) + r - s for a, e >= 0. The first term has a relative error of 2^-106, as it alone remains if a and e
/// are large and close to each other.
NIPREF_INLINE double combine_i6(double a, double e, Pair r, Pair s) {
  constexpr double quarter_pi_high = 0x1.921fb54442d18p-1;
  constexpr double quarter_pi_low = 0x1.1a62633145c07p-55;
  const Pair difference = two_sum(e, -a);
  const Pair linear = two_product(difference.high, quarter_pi_high);
  const Pair with_r = two_sum(linear.high, r.high);
  const Pair with_s = two_sum(with_r.high, -s.high);
  const double linear_low =
      mul_add(difference.high, quarter_pi_low, mul_add(difference.low, quarter_pi_high, linear.low));
  return with_s.high + ((with_r.low + with_s.low) + (linear_low + (r.low - s.low)));
}

}  // namespace nipref::fast::internal::NIPREF_ISA
