#pragma once

#include <nipref/fast/sheet/arithmetic/rows.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// The row of the piece around x < piece_end, and the distance of x from the piece's centre, which is exact.
template <class Number>
struct Located {
  decltype(bits_of(Number{})) row;
  Number t;
};

/// Adding 2^47 rounds x to a multiple of 1/32, adding 2^46 to a multiple of 1/64. The 1 leads to the rows of coarse pieces.
template <class Number>
NIPREF_INLINE Located<Number> locate(Number x) {
  static_assert(fine_pieces == 64 && coarse_pieces == 32 && coarse_offset == 32);
  const Number shift = select(less(x, all<Number>(fine_end)), all<Number>(0x1p46), all<Number>(0x1p47 + 1));
  const Number shifted = x + shift;
  return {bits_of(shifted) & 0xffff, x - (shifted - shift)};
}

/// A component for x < piece_end, and x >= near_end if it is logarithmic, by the local polynomial of the nearest
/// centre. Odd components are tabulated as f(x)/x, which makes them relatively accurate down to denormal x.
template <Component component, int tier, class Number>
NIPREF_INLINE Sum<Number> piece(Number x) {
  constexpr int degree = tier_works[tier].piece;
  static_assert(degree >= 4 && piece_degree == 7);
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Located<Number> at = locate(x);
  const auto offset = table_index(at.row << 3);
  const Columns<Number> first = columns(table.power[0], offset), second = columns(table.power[0] + 4, offset);
  Number sum = second.number[degree - 4];
#pragma GCC unroll 8
  for (int k = degree - 1; k >= 1; --k)
    sum = mul_add(sum, at.t, k >= 4 ? second.number[k - 4] : first.number[k]);
  Number low = at.t * sum;
  if constexpr (tier_works[tier].compensated) low += gather_eighths(table.constant_low, offset);
  if constexpr (shape_of<component> == Shape::odd) return {mul_add(x, first.number[0], x * low), Number{}};
  return {first.number[0], low};
}

}  // namespace nipref::fast::internal::NIPREF_ISA
