#pragma once

// near_zero.hpp for eight arguments at a time with AVX-512, whose registers hold the table of logarithms. The
// gathers that 128 cells need would cost more than the longer series that 16 cells need.

#ifdef __AVX512F__

#include <immintrin.h>  // nothing but always-inlined functions, so safe here; see floating.hpp

#include <nipref/fast/sheet/arithmetic/near_zero.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Eight unevaluated sums; see Pair.
struct WidePair {
  __m512d high;
  __m512d low;
};

/// c[0] + c[1] x + ... + c[degree] x^degree.
template <int degree>
NIPREF_INLINE __m512d horner(const double* c, __m512d x) {
  __m512d sum = _mm512_set1_pd(c[degree]);
#pragma GCC unroll 16
  for (int k = degree - 1; k >= 0; --k) sum = _mm512_fmadd_pd(sum, x, _mm512_set1_pd(c[k]));
  return sum;
}

/// table[cell mod 16]
NIPREF_INLINE __m512d look_up(const double (&table)[wide_log_cells], __m512i cell) {
  static_assert(wide_log_cells == 16);
  return _mm512_permutex2var_pd(_mm512_load_pd(table), cell, _mm512_load_pd(table + 8));
}

/// constant of the component - ln x for x > 0, denormal x included. As the reciprocals are exact by
/// definition, a fused multiply-add rounds r = m/centre - 1 once.
template <Component component, int tier>
NIPREF_INLINE WidePair minus_logarithm(__m512d x) {
  constexpr double ln2_high = 0x1.62e42fefa38p-1;
  constexpr double ln2_low = 0x1.ef35793c7673p-45;
  constexpr int cell_shift = 48;
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const __m512d exponent = _mm512_getexp_pd(x);
  const __m512d mantissa = _mm512_getmant_pd(x, _MM_MANT_NORM_1_2, _MM_MANT_SIGN_zero);
  const __m512i cell = _mm512_srli_epi64(_mm512_castpd_si512(mantissa), cell_shift);
  const __m512d r =
      _mm512_fmsub_pd(mantissa, look_up(common_table.wide_log_reciprocal, cell), _mm512_set1_pd(1));
  __m512d low = _mm512_fnmsub_pd(r * r, horner<tier_works[tier].wide_log1p - 2>(log1p_curvature, r), r);
  if constexpr (tier_works[tier].compensated)
    low += _mm512_fnmadd_pd(exponent, _mm512_set1_pd(ln2_low), look_up(table.wide_log_low, cell));
  return {_mm512_fnmadd_pd(exponent, _mm512_set1_pd(ln2_high), look_up(table.wide_log_high, cell)), low};
}

/// A logarithmic component for 0 < x < near_end.
template <Component component, int tier>
NIPREF_INLINE WidePair near_zero(__m512d x) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const __m512d square = x * x;
  WidePair sum = minus_logarithm<component, tier>(x);
  sum.low = _mm512_fmadd_pd(square, horner<tier_works[tier].even - 1>(table.even[tier], square), sum.low);
  if constexpr (component == Component::alpha_part_of_I6)
    sum.low = _mm512_fmadd_pd(_mm512_set1_pd(table.odd), x, sum.low);
  return sum;
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
