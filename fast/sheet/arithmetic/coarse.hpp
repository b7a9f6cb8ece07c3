#pragma once

#include <nipref/fast/sheet/arithmetic/near_zero.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// An argument x < piece_end in the coarse tiers: f = rest + the cubic in t of one row of the coarse table; for odd f
/// the rest is 0 and the cubic is multiplied by x.
struct CoarsePoint {
  int64_t row;
  double t;
  double rest;
};

/// The centre next to 0 <= y <= piece_end and the distance from it: adding 2^47 rounds y to a multiple of 1/32.
NIPREF_INLINE CoarsePoint about_coarse_centre(double y) {
  static_assert(coarse_pieces == 32);
  constexpr double rounding_shift = 0x1p47;
  const double shifted = y + rounding_shift;
  return {static_cast<int64_t>(bits_of(shifted) & 0xffff), y - (shifted - rounding_shift), 0};
}

/// Mantissa 1 is 32 steps of 1/32 from 0.
inline constexpr int64_t first_coarse_log_row = coarse_piece_rows - 32;

NIPREF_INLINE double masked(double x, uint64_t mask) { return from_bits(bits_of(x) & mask); }

/// There are no branches, which random arguments would mispredict: below near_end the mantissa replaces x, elsewhere
/// the power of two and the even remainder are masked off.
template <Component component, int tier>
NIPREF_INLINE CoarsePoint locate_coarsely(double x) {
  const double bounded = x < piece_end ? x : piece_end;  // beyond it any row will do: the value is not used
  if constexpr (shape_of<component> != Shape::logarithmic) return about_coarse_centre(bounded);
  constexpr double ln2 = 0x1.62e42fefa39efp-1;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const uint64_t near = x < near_end ? ~uint64_t{0} : 0;
  const Decomposed part = decompose(x);
  const double near_x = masked(x, near);
  const double square = near_x * near_x;
  CoarsePoint at =
      about_coarse_centre(from_bits((bits_of(part.mantissa) & near) | (bits_of(bounded) & ~near)));
  at.row += first_coarse_log_row & static_cast<int64_t>(near);
  at.rest = mul_add(square, horner<tier_works[tier].even - 1>(table.even[tier], square),
                    masked(part.exponent, near) * -ln2);
  if constexpr (component == Component::alpha_part_of_I6) at.rest = mul_add(table.odd, near_x, at.rest);
  return at;
}

/// A component for x < piece_end.
template <Component component, int tier>
NIPREF_INLINE double coarse(double x) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const CoarsePoint at = locate_coarsely<component, tier>(x);
  const double cubic = horner<tier_works[tier].piece>(table.coarse[at.row], at.t);
  return shape_of<component> == Shape::odd ? x * cubic : cubic + at.rest;
}

}  // namespace nipref::fast::internal::NIPREF_ISA
