#pragma once

#include <nipref/fast/sheet/arithmetic/floating.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// x > 0 as 2^exponent * mantissa, 1 <= mantissa < 2, with the mantissa's position in the table of
/// logarithms.
struct Decomposed {
  double exponent;
  double mantissa;
  double centre;
  int64_t cell;
};

NIPREF_INLINE Decomposed decompose(double x) {
  constexpr uint64_t one = 0x3ff0000000000000;
  constexpr uint64_t fraction_bits = 0x000fffffffffffff;
  constexpr int cell_shift = 45;
  constexpr uint64_t inside_cell = (uint64_t{1} << cell_shift) - 1;
  constexpr uint64_t half_cell = uint64_t{1} << (cell_shift - 1);
  const bool denormal = x < 0x1p-1022;
  const uint64_t bits = bits_of(denormal ? x * 0x1p54 : x);
  // An integer below 2^52 written into the fraction of 2^52 reads as 2^52 + integer, a conversion that compilers
  // vectorise.
  const double biased = from_bits((bits >> 52) | 0x4330000000000000);
  const double bias = denormal ? 0x1p52 + 1023 + 54 : 0x1p52 + 1023;
  const uint64_t fraction = bits & fraction_bits;
  return {biased - bias, from_bits(fraction | one), from_bits((fraction & ~inside_cell) | half_cell | one),
          static_cast<int64_t>(fraction >> cell_shift)};
}

/// Powers of r in (ln(1 + r) - r)/r^2.
inline constexpr double log1p_curvature[] = {-1.0 / 2, 1.0 / 3,  -1.0 / 4, 1.0 / 5,  -1.0 / 6,
                                             1.0 / 7,  -1.0 / 8, 1.0 / 9,  -1.0 / 10};

/// constant of the component - ln x for x > 0, denormal x included.
///
/// k ln2_high and log_high are multiples of 2^-42 below 2^10, so that their sum is exact and only terms below 1/256 are
/// rounded.
template <Component component, int tier>
NIPREF_INLINE Pair minus_logarithm(double x) {
  constexpr double ln2_high = 0x1.62e42fefa38p-1;
  constexpr double ln2_low = 0x1.ef35793c7673p-45;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Decomposed part = decompose(x);
  const double r = (part.mantissa - part.centre) * common_table.log_reciprocal[part.cell];
  double low = mul_add(-r * r, horner<tier_works[tier].log1p - 2>(log1p_curvature, r), -r);
  if constexpr (tier_works[tier].compensated)
    low += mul_add(-part.exponent, ln2_low, table.log_low[part.cell]);
  return {table.log_high[part.cell] - part.exponent * ln2_high, low};
}

/// The same by 16 cells, whose tables fit into vector registers. Without a fused multiply-add r has an error of 2^-53,
/// which is enough for the tiers below full accuracy.
template <Component component, int tier>
requires(tier_works[tier].log1p == 0) NIPREF_INLINE Pair minus_logarithm(double x) {
  constexpr double ln2_high = 0x1.62e42fefa38p-1;
  constexpr double ln2_low = 0x1.ef35793c7673p-45;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Decomposed part = decompose(x);
  const int64_t cell = part.cell / (log_cells / short_log_cells);
  const double r = mul_add(part.mantissa, common_table.short_log_reciprocal[cell], -1.0);
  double low = mul_add(-r * r, horner<tier_works[tier].short_log1p - 2>(log1p_curvature, r), -r);
  if constexpr (tier_works[tier].compensated)
    low += mul_add(-part.exponent, ln2_low, table.short_log_low[cell]);
  return {mul_add(-part.exponent, ln2_high, table.short_log_high[cell]), low};
}

/// A logarithmic component for 0 < x < near_end. Low words are added from small to large: the logarithm's is
/// below 1/256 where it matters, the even remainder below 0.1, the odd term below 0.4.
template <Component component, int tier>
NIPREF_INLINE Pair near_zero(double x) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const double square = x * x;
  Pair sum = minus_logarithm<component, tier>(x);
  sum.low = mul_add(square, horner<tier_works[tier].even - 1>(table.even[tier], square), sum.low);
  if constexpr (component == Component::alpha_part_of_I6) sum.low = mul_add(table.odd, x, sum.low);
  return sum;
}

}  // namespace nipref::fast::internal::NIPREF_ISA
