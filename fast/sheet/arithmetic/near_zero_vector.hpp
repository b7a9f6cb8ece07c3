#pragma once

// near_zero.hpp for a vector of arguments. Registers of AVX-512 hold the table of logarithms; the gathers that
// 128 cells need would cost more than the longer series that 16 cells need.

#include <nipref/fast/sheet/arithmetic/near_zero.hpp>
#include <nipref/fast/sheet/arithmetic/vector.hpp>

#ifdef NIPREF_VECTORS

namespace nipref::fast::internal::NIPREF_ISA {

/// constant of the component - ln x for x > 0, denormal x included. The centres are defined by their reciprocals, which
/// are doubles, so that a fused multiply-add computes r = m/centre - 1 with one rounding.
template <Component component, int tier>
NIPREF_INLINE VectorPair minus_logarithm(Vector x) {
  constexpr double ln2_high = 0x1.62e42fefa38p-1;
  constexpr double ln2_low = 0x1.ef35793c7673p-45;
  constexpr int cell_shift = 48;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const VectorDecomposed part = decompose(x);
  const TableIndex cell = table_index((bits_of(part.mantissa) >> cell_shift) & (short_log_cells - 1));
  const Vector r = mul_add(part.mantissa, look_up(common_table.short_log_reciprocal, cell), all(-1.0));
  Vector low = minus_mul_subtract(r * r, horner<tier_works[tier].short_log1p - 2>(log1p_curvature, r), r);
  if constexpr (tier_works[tier].compensated)
    low += minus_mul_add(part.exponent, all(ln2_low), look_up(table.short_log_low, cell));
  return {minus_mul_add(part.exponent, all(ln2_high), look_up(table.short_log_high, cell)), low};
}

/// A logarithmic component for 0 < x < near_end.
template <Component component, int tier>
NIPREF_INLINE VectorPair near_zero(Vector x) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Vector square = x * x;
  VectorPair sum = minus_logarithm<component, tier>(x);
  sum.low = mul_add(square, horner<tier_works[tier].even - 1>(table.even[tier], square), sum.low);
  if constexpr (component == Component::alpha_part_of_I6) sum.low = mul_add(all(table.odd), x, sum.low);
  return sum;
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
