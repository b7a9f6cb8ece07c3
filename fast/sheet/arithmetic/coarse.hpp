#pragma once

#include <nipref/fast/sheet/arithmetic/near_zero.hpp>
#include <nipref/fast/sheet/arithmetic/rows.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// An argument x < piece_end in the coarse tiers, where f is `rest` plus the cubic in t of one row of the coarse table.
/// For odd f the rest is 0 and the cubic is multiplied by x.
template <class Number>
struct CoarsePoint {
  decltype(bits_of(Number{})) offset;  ///< offset of the row in the table
  Number t, rest;
};

/// Finds the centre nearest to y, 0 <= y <= piece_end, and the distance from it. One addition rounds y to a multiple of
/// 1/32 and adds the number of the first row.
template <class Number>
NIPREF_INLINE CoarsePoint<Number> about_coarse_centre(Number y, Number shift) {
  static_assert(coarse_degree + 1 == 4);
  const Number shifted = y + shift;
  return {(bits_of(shifted) & 0xffff) << 2, y - (shifted - shift), Number{}};
}

/// Locates x without branches, which random arguments would mispredict: below near_end the mantissa replaces x,
/// elsewhere the power of two and the even remainder are masked off.
template <Component component, int tier, class Number>
NIPREF_INLINE CoarsePoint<Number> locate_coarsely(Number x) {
  const Number bounded = smaller(x, all<Number>(piece_end));  // beyond piece_end the value is not used
  const Number piece_shift = all<Number>(0x1p47);
  if constexpr (shape_of<component> != Shape::logarithmic) return about_coarse_centre(bounded, piece_shift);
  constexpr double ln2 = 0x1.62e42fefa39efp-1;
  // The mantissa 1 is 32 steps of 1/32 from 0.
  constexpr double first_log_row = coarse_piece_rows - 32;
  const Number log_shift = all<Number>(0x1p47 + first_log_row / coarse_pieces), none{};
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const auto near = less(x, all<Number>(near_end));
  const Decomposed<Number> part = decompose(x);
  const Number near_x = select(near, x, none), square = near_x * near_x;
  auto at = about_coarse_centre(select(near, part.mantissa, bounded), select(near, log_shift, piece_shift));
  at.rest = mul_add(square, horner<tier_works[tier].even - 1>(table.even[tier], square),
                    select(near, part.exponent, none) * -ln2);
  if constexpr (component == Component::alpha_part_of_I6)
    at.rest = mul_add(all<Number>(table.odd), near_x, at.rest);
  return at;
}

/// The cubics at points t, with coefficients from the rows that begin at the offsets.
template <int degree, class Offset, class Number>
NIPREF_INLINE Number cubics(const double* table, Offset offset, Number t) {
  const Columns<Number> power = columns(table, offset);
  Number sum = power.number[degree];
#pragma GCC unroll 4
  for (int k = degree - 1; k >= 0; --k) sum = mul_add(sum, t, power.number[k]);
  return sum;
}

/// A component for x < piece_end.
template <Component component, int tier>
NIPREF_INLINE double coarse(double x) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const auto at = locate_coarsely<component, tier>(x);
  const double cubic = cubics<tier_works[tier].piece>(table.coarse[0], at.offset, at.t);
  return shape_of<component> == Shape::odd ? x * cubic : cubic + at.rest;
}

}  // namespace nipref::fast::internal::NIPREF_ISA
