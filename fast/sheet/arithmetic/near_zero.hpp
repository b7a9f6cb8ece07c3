#pragma once

#include <nipref/fast/sheet/arithmetic/vector.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Coefficients of the powers of r in (ln(1 + r) - r)/r^2.
inline constexpr double log1p_curvature[] = {-1.0 / 2, 1.0 / 3,  -1.0 / 4, 1.0 / 5,  -1.0 / 6,
                                             1.0 / 7,  -1.0 / 8, 1.0 / 9,  -1.0 / 10};

/// The component's constant minus ln x, for x > 0, denormal x included, with 16 cells for the mantissa m.
///
/// k ln2_high and log_high are multiples of 2^-42 below 2^10. Their sum is exact, so that only terms below 1/32 are
/// rounded. The tables of 16 cells fit into registers of AVX-512; with 128 cells, a vector would lose more time by
/// gathers than it gains by the shorter series. The centres are defined by their reciprocals, which are doubles, so
/// that a fused multiply-add computes r = m/centre - 1 with one rounding. Without a fused multiply-add the error of r
/// is 2^-53, which is small enough for the tiers below full accuracy.
template <Component component, int tier, class Number>
NIPREF_INLINE Sum<Number> minus_logarithm(Number x) {
  constexpr int cell_shift = 48;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Decomposed<Number> part = decompose(x);
  const auto cell = table_index((bits_of(part.mantissa) >> cell_shift) & (short_log_cells - 1));
  const Number r =
      mul_add(part.mantissa, look_up(common_table.short_log_reciprocal, cell), all<Number>(-1.0));
  Number low = minus_mul_subtract(r * r, horner<tier_works[tier].short_log1p - 2>(log1p_curvature, r), r);
  if constexpr (tier_works[tier].compensated)
    low += minus_mul_add(part.exponent, all<Number>(ln2_low), look_up(table.short_log_low, cell));
  return {minus_mul_add(part.exponent, all<Number>(ln2_high), look_up(table.short_log_high, cell)), low};
}

/// The component's constant minus ln x for one number, with 128 cells: only terms below 1/256 are rounded.
template <Component component, int tier>
requires(tier_works[tier].log1p != 0) NIPREF_INLINE Pair minus_logarithm(double x) {
  constexpr int cell_shift = 45;
  constexpr uint64_t half_cell = uint64_t{1} << (cell_shift - 1);
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Decomposed<double> part = decompose(x);
  const uint64_t cells = bits_of(part.mantissa) >> cell_shift, cell = cells & (log_cells - 1);
  const double centre = from_bits(cells << cell_shift | half_cell);
  const double r = (part.mantissa - centre) * common_table.log_reciprocal[cell];
  double low = minus_mul_subtract(r * r, horner<tier_works[tier].log1p - 2>(log1p_curvature, r), r);
  if constexpr (tier_works[tier].compensated)
    low += minus_mul_add(part.exponent, ln2_low, table.log_low[cell]);
  return {table.log_high[cell] - part.exponent * ln2_high, low};
}

/// A logarithmic component for 0 < x < near_end. Low words are added from small to large: the low word of the logarithm
/// is below 1/256 where it matters, the even remainder below 0.1, the odd term below 0.4.
template <Component component, int tier, class Number>
NIPREF_INLINE Sum<Number> near_zero(Number x) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Number square = x * x;
  Sum<Number> sum = minus_logarithm<component, tier>(x);
  sum.low = mul_add(square, horner<tier_works[tier].even - 1>(table.even[tier], square), sum.low);
  if constexpr (component == Component::alpha_part_of_I6)
    sum.low = mul_add(all<Number>(table.odd), x, sum.low);
  return sum;
}

}  // namespace nipref::fast::internal::NIPREF_ISA
