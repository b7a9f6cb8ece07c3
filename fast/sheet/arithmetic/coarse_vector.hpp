#pragma once

// coarse.hpp for a vector of arguments.

#include <nipref/fast/sheet/arithmetic/coarse.hpp>
#include <nipref/fast/sheet/arithmetic/near_zero_vector.hpp>
#include <nipref/fast/sheet/arithmetic/rows_vector.hpp>

#ifdef NIPREF_VECTORS

namespace nipref::fast::internal::NIPREF_ISA {

/// f = rest + cubic of t in a row; see CoarsePoint.
struct VectorCoarsePoint {
  VectorBits offset;  ///< of the row in the table
  Vector t;
  Vector rest;
};

/// One addition rounds y to a multiple of 1/32 and adds the first row's number.
NIPREF_INLINE VectorCoarsePoint about_coarse_centre(Vector y, Vector shift) {
  static_assert(coarse_degree + 1 == 4);
  const Vector shifted = y + shift;
  return {(bits_of(shifted) & 0xffff) << 2, y - (shifted - shift), Vector{}};
}

template <Component component, int tier>
NIPREF_INLINE VectorCoarsePoint locate_coarsely(Vector x) {
  const Vector bounded = smaller(x, all(piece_end));
  const Vector piece_shift = all(0x1p47);
  if constexpr (shape_of<component> != Shape::logarithmic) return about_coarse_centre(bounded, piece_shift);
  constexpr double ln2 = 0x1.62e42fefa39efp-1;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const auto near = x < all(near_end);
  const Vector near_x = near ? x : Vector{};
  const Vector square = near_x * near_x;
  const VectorDecomposed part = decompose(x);
  const Vector minus_power = (near ? part.exponent : Vector{}) * -ln2;
  const Vector log_shift = all(0x1p47 + static_cast<double>(first_coarse_log_row) / coarse_pieces);
  VectorCoarsePoint at = about_coarse_centre(near ? part.mantissa : bounded, near ? log_shift : piece_shift);
  at.rest = mul_add(square, horner<tier_works[tier].even - 1>(table.even[tier], square), minus_power);
  if constexpr (component == Component::alpha_part_of_I6) at.rest = mul_add(all(table.odd), near_x, at.rest);
  return at;
}

/// The cubics of points whose rows begin at the offsets.
template <int degree>
NIPREF_INLINE Vector cubics(const double* table, const uint64_t* offset, Vector t) {
  const Columns power = columns(table, offset);
  Vector sum = power.number[degree];
#pragma GCC unroll 4
  for (int k = degree - 1; k >= 0; --k) sum = mul_add(sum, t, power.number[k]);
  return sum;
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
