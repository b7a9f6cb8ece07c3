#pragma once

// piece.hpp for eight arguments at a time with AVX-512.

#ifdef __AVX512F__

#include <nipref/fast/sheet/arithmetic/near_zero_wide.hpp>
#include <nipref/fast/sheet/arithmetic/rows_wide.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Rows of the pieces around eight arguments and distances from their centres.
struct WideLocated {
  __m512i row;
  __m512d t;
};

/// Adding 2^47 rounds to a multiple of 1/32, 2^46 to one of 1/64.
NIPREF_INLINE WideLocated locate(__m512d x) {
  static_assert(fine_pieces == 64 && coarse_pieces == 32);
  const __mmask8 is_coarse = _mm512_cmp_pd_mask(x, _mm512_set1_pd(fine_end), _CMP_GE_OQ);
  const __m512d shift = _mm512_mask_blend_pd(is_coarse, _mm512_set1_pd(0x1p46), _mm512_set1_pd(0x1p47));
  const __m512d shifted = x + shift;
  const __m512i index = _mm512_and_si512(_mm512_castpd_si512(shifted), _mm512_set1_epi64(0xffff));
  return {_mm512_mask_add_epi64(index, is_coarse, index, _mm512_set1_epi64(coarse_offset)),
          x - (shifted - shift)};
}

/// A component for x < piece_end (and x >= near_end where it is logarithmic).
template <Component component, int tier>
NIPREF_INLINE WidePair piece(__m512d x) {
  constexpr int degree = tier_works[tier].piece;
  static_assert(degree >= 4 && piece_degree == 7);
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const WideLocated at = locate(_mm512_min_pd(x, _mm512_set1_pd(piece_end)));  // tail: any row will do
  alignas(64) int64_t offset[8];
  _mm512_store_si512(offset, _mm512_slli_epi64(at.row, 3));
  const Columns first = columns(table.power[0], offset);
  const Columns second = columns(table.power[0] + 4, offset);
  __m512d sum = second.number[degree - 4];
#pragma GCC unroll 8
  for (int k = degree - 1; k >= 1; --k)
    sum = _mm512_fmadd_pd(sum, at.t, k >= 4 ? second.number[k - 4] : first.number[k]);
  __m512d low = at.t * sum;
  if constexpr (tier_works[tier].compensated) low += _mm512_i64gather_pd(at.row, table.constant_low, 8);
  if constexpr (shape_of<component> == Shape::odd)
    return {_mm512_fmadd_pd(x, first.number[0], x * low), _mm512_setzero_pd()};
  return {first.number[0], low};
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
