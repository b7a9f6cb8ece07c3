#pragma once

// coarse.hpp for a vector of arguments.

#include <nipref/fast/sheet/arithmetic/coarse.hpp>
#include <nipref/fast/sheet/arithmetic/near_zero_wide.hpp>
#include <nipref/fast/sheet/arithmetic/rows_wide.hpp>

#ifdef NIPREF_WIDE

namespace nipref::fast::internal::NIPREF_ISA {

/// f = rest + cubic of t in a row; see CoarsePoint.
struct WideCoarsePoint {
  WideBits offset;  ///< of the row in the table
  Wide t;
  Wide rest;
};

/// One addition rounds y to a multiple of 1/32 and moves it to its row, first_row times 1/32 further.
NIPREF_INLINE WideCoarsePoint about_coarse_centre(Wide y, Wide shift) {
  static_assert(coarse_degree + 1 == 4);
  const Wide shifted = y + shift;
  return {(bits_of(shifted) & 0xffff) << 2, y - (shifted - shift), Wide{}};
}

template <Component component, int tier>
NIPREF_INLINE WideCoarsePoint locate_coarsely(Wide x) {
  const Wide bounded = smaller(x, all(piece_end));
  const Wide piece_shift = all(0x1p47);
  if constexpr (shape_of<component> != Shape::logarithmic) return about_coarse_centre(bounded, piece_shift);
  constexpr double ln2 = 0x1.62e42fefa39efp-1;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const auto near = x < all(near_end);
  const Wide near_x = near ? x : Wide{};
  const Wide square = near_x * near_x;
  const WideDecomposed part = decompose(x);
  const Wide minus_power = (near ? part.exponent : Wide{}) * -ln2;
  const Wide log_shift = all(0x1p47 + static_cast<double>(first_coarse_log_row) / coarse_pieces);
  WideCoarsePoint at = about_coarse_centre(near ? part.mantissa : bounded, near ? log_shift : piece_shift);
  at.rest = mul_add(square, horner<tier_works[tier].even - 1>(table.even[tier], square), minus_power);
  if constexpr (component == Component::alpha_part_of_I6) at.rest = mul_add(all(table.odd), near_x, at.rest);
  return at;
}

/// The cubics of points whose rows begin at the offsets.
template <int degree>
NIPREF_INLINE Wide cubics(const double* table, const uint64_t* offset, Wide t) {
  const Columns power = columns(table, offset);
  Wide sum = power.number[degree];
#pragma GCC unroll 4
  for (int k = degree - 1; k >= 0; --k) sum = mul_add(sum, t, power.number[k]);
  return sum;
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
