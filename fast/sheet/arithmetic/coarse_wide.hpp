#pragma once

// coarse.hpp for eight arguments at a time with AVX-512.

#ifdef __AVX512F__

#include <nipref/fast/sheet/arithmetic/coarse.hpp>
#include <nipref/fast/sheet/arithmetic/near_zero_wide.hpp>
#include <nipref/fast/sheet/arithmetic/rows_wide.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// f = rest + cubic of t in a row; see CoarsePoint.
struct WideCoarsePoint {
  __m512i offset;  ///< of the row in the table
  __m512d t;
  __m512d rest;
};

/// One addition rounds y to a multiple of 1/32 and moves it to its row, first_row times 1/32 further.
NIPREF_INLINE WideCoarsePoint about_coarse_centre(__m512d y, __m512d shift) {
  static_assert(coarse_degree + 1 == 4);
  const __m512d shifted = y + shift;
  const __m512i row = _mm512_and_si512(_mm512_castpd_si512(shifted), _mm512_set1_epi64(0xffff));
  return {_mm512_slli_epi64(row, 2), y - (shifted - shift), _mm512_setzero_pd()};
}

template <Component component, int tier>
NIPREF_INLINE WideCoarsePoint locate_coarsely(__m512d x) {
  const __m512d bounded = _mm512_min_pd(x, _mm512_set1_pd(piece_end));
  const __m512d piece_shift = _mm512_set1_pd(0x1p47);
  if constexpr (shape_of<component> != Shape::logarithmic) return about_coarse_centre(bounded, piece_shift);
  constexpr double ln2 = 0x1.62e42fefa39efp-1;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const __mmask8 near = _mm512_cmp_pd_mask(x, _mm512_set1_pd(near_end), _CMP_LT_OQ);
  const __m512d square = _mm512_maskz_mul_pd(near, x, x);
  const __m512d minus_power = _mm512_maskz_getexp_pd(near, x) * _mm512_set1_pd(-ln2);
  const __m512d log_shift =
      _mm512_set1_pd(0x1p47 + static_cast<double>(first_coarse_log_row) / coarse_pieces);
  WideCoarsePoint at =
      about_coarse_centre(_mm512_mask_getmant_pd(bounded, near, x, _MM_MANT_NORM_1_2, _MM_MANT_SIGN_zero),
                          _mm512_mask_blend_pd(near, piece_shift, log_shift));
  at.rest = _mm512_fmadd_pd(square, horner<tier_works[tier].even - 1>(table.even[tier], square), minus_power);
  if constexpr (component == Component::alpha_part_of_I6)
    at.rest = _mm512_mask3_fmadd_pd(_mm512_set1_pd(table.odd), x, at.rest, near);
  return at;
}

/// The cubics of eight points whose rows begin at the offsets.
template <int degree>
NIPREF_INLINE __m512d cubics(const double* table, const int64_t* offset, __m512d t) {
  const Columns power = columns(table, offset);
  __m512d sum = power.number[degree];
#pragma GCC unroll 4
  for (int k = degree - 1; k >= 0; --k) sum = _mm512_fmadd_pd(sum, t, power.number[k]);
  return sum;
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
