#pragma once

// Table rows for eight points at a time with AVX-512. Loading rows and transposing them takes half the time
// of gathering powers.

#ifdef __AVX512F__

#include <immintrin.h>  // nothing but always-inlined functions, so safe here; see floating.hpp

#include <nipref/fast/sheet/arithmetic/floating.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Four neighbouring numbers of a table at two offsets, side by side.
NIPREF_INLINE __m512d two_rows(const double* table, int64_t first, int64_t second) {
  return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(table + first)),
                            _mm256_load_pd(table + second), 1);
}

/// Numbers 0 ... 3 from each of eight offsets, number by number.
struct Columns {
  __m512d number[4];
};

NIPREF_INLINE Columns columns(const double* table, const int64_t* offset) {
  constexpr int even_lanes = 0x88;
  constexpr int odd_lanes = 0xdd;
  const __m512d rows02 = two_rows(table, offset[0], offset[2]);
  const __m512d rows13 = two_rows(table, offset[1], offset[3]);
  const __m512d rows46 = two_rows(table, offset[4], offset[6]);
  const __m512d rows57 = two_rows(table, offset[5], offset[7]);
  const __m512d even_low = _mm512_unpacklo_pd(rows02, rows13);
  const __m512d even_high = _mm512_unpacklo_pd(rows46, rows57);
  const __m512d odd_low = _mm512_unpackhi_pd(rows02, rows13);
  const __m512d odd_high = _mm512_unpackhi_pd(rows46, rows57);
  return {{_mm512_shuffle_f64x2(even_low, even_high, even_lanes),
           _mm512_shuffle_f64x2(odd_low, odd_high, even_lanes),
           _mm512_shuffle_f64x2(even_low, even_high, odd_lanes),
           _mm512_shuffle_f64x2(odd_low, odd_high, odd_lanes)}};
}

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif
