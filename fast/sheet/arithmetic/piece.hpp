#pragma once

#include <nipref/fast/sheet/arithmetic/floating.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Row of the piece around x < piece_end and distance of x from its centre, which is exact.
struct Located {
  int64_t row;
  double t;
};

NIPREF_INLINE Located locate(double x) {
  static_assert(fine_pieces == 2 * coarse_pieces && coarse_offset == 32);
  // Fine pieces have half the width, which is one step in the exponent. All else follows by arithmetic from this one
  // selection: several selections would be compiled to a branch, and the loop over points would not be vectorised.
  constexpr uint64_t exponent_step = uint64_t{1} << 52;
  const uint64_t step = x < fine_end ? exponent_step : 0;
  const double pieces = from_bits(__builtin_bit_cast(uint64_t, coarse_pieces) + step);
  const double width = from_bits(__builtin_bit_cast(uint64_t, 1 / coarse_pieces) - step);
  const Nearest centre = nearest(x * pieces);
  const int64_t offset = coarse_offset - static_cast<int64_t>(step >> 47);
  return {centre.integer + offset, x - centre.value * width};
}

/// Powers first .. degree of the local polynomial, divided by t^first.
template <int first, int degree>
NIPREF_INLINE double piece_powers(const ComponentTable& table, Located at) {
  double sum = table.power[at.row][degree];
#pragma GCC unroll 16
  for (int k = degree - 1; k >= first; --k) sum = mul_add(sum, at.t, table.power[at.row][k]);
  return sum;
}

/// A component for x < piece_end (and x >= near_end where it is logarithmic): local polynomial of the nearest
/// centre. Odd components are tabulated as f(x)/x, which makes them relatively accurate down to denormal x.
template <Component component, int tier>
NIPREF_INLINE Pair piece(double x) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const Located at = locate(x);
  const double constant = table.power[at.row][0];
  double low = at.t * piece_powers<1, tier_works[tier].piece>(table, at);
  if constexpr (tier_works[tier].compensated) low += table.constant_low[at.row];
  if constexpr (shape_of<component> == Shape::odd) return {mul_add(x, constant, x * low), 0};
  return {constant, low};
}

}  // namespace nipref::fast::internal::NIPREF_ISA
