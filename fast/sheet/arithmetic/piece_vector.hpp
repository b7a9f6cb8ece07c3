#pragma once

// piece.hpp for a vector of arguments.

#include <nipref/fast/sheet/arithmetic/near_zero_vector.hpp>
#include <nipref/fast/sheet/arithmetic/rows_vector.hpp>

#ifdef NIPREF_VECTORS

namespace nipref::fast::internal::NIPREF_ISA {

/// Rows of the pieces around arguments and distances from their centres.
struct VectorLocated {
  VectorBits row;
  Vector t;
};

/// Adding 2^47 rounds to a multiple of 1/32, 2^46 to one of 1/64; 1 more moves to the rows of coarse pieces.
NIPREF_INLINE VectorLocated locate(Vector x) {
  static_assert(fine_pieces == 64 && coarse_pieces == 32 && coarse_offset == 32);
  const Vector shift = x < all(fine_end) ? all(0x1p46) : all(0x1p47 + 1);
  const Vector shifted = x + shift;
  return {bits_of(shifted) & 0xffff, x - (shifted - shift)};
}

/// A component for x < piece_end (and x >= near_end where it is logarithmic).
template <Component component, int tier>
NIPREF_INLINE VectorPair piece(Vector x) {
  constexpr int degree = tier_works[tier].piece;
  static_assert(degree >= 4 && piece_degree == 7);
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const VectorLocated at = locate(x);
  const TableIndex offset = table_index(at.row << 3);
  const Columns first = columns(table.power[0], offset.lane);
  const Columns second = columns(table.power[0] + 4, offset.lane);
  Vector sum = second.number[degree - 4];
#pragma GCC unroll 8
  for (int k = degree - 1; k >= 1; --k)
    sum = mul_add(sum, at.t, k >= 4 ? second.number[k - 4] : first.number[k]);
  Vector low = at.t * sum;
  if constexpr (tier_works[tier].compensated) low += gather_eighths(table.constant_low, offset);
  if constexpr (shape_of<component> == Shape::odd) return {mul_add(x, first.number[0], x * low), Vector{}};
  return {first.number[0], low};
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
