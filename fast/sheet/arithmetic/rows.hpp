#pragma once

// Table rows for a point or a vector of points. Loading rows and transposing them takes half the time of gathering powers.

#include <nipref/fast/sheet/arithmetic/vector.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Four neighbouring numbers of a table from the offset of each lane: number[k] has the k-th of each lane.
template <class Number>
struct Columns {
  Number number[4];
};

NIPREF_INLINE Columns<double> columns(const double* table, uint64_t offset) {
  const double* row = table + offset;
  return {{row[0], row[1], row[2], row[3]}};
}

#ifdef __AVX512F__

/// Four neighbouring numbers of a table at two offsets, side by side.
NIPREF_INLINE __m512d two_rows(const double* table, uint64_t first, uint64_t second) {
  return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(table + first)),
                            _mm256_load_pd(table + second), 1);
}

NIPREF_INLINE Columns<Vector> columns(const double* table, const uint64_t* offset) {
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

#elif defined(__AVX2__)

/// Two neighbouring numbers of a table at two offsets, side by side.
NIPREF_INLINE __m256d two_pairs(const double* table, uint64_t first, uint64_t second) {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(table + first)), _mm_load_pd(table + second),
                              1);
}

NIPREF_INLINE Columns<Vector> columns(const double* table, const uint64_t* offset) {
  const __m256d pairs02 = two_pairs(table, offset[0], offset[2]);
  const __m256d pairs13 = two_pairs(table, offset[1], offset[3]);
  const __m256d later02 = two_pairs(table + 2, offset[0], offset[2]);
  const __m256d later13 = two_pairs(table + 2, offset[1], offset[3]);
  return {{_mm256_unpacklo_pd(pairs02, pairs13), _mm256_unpackhi_pd(pairs02, pairs13),
           _mm256_unpacklo_pd(later02, later13), _mm256_unpackhi_pd(later02, later13)}};
}

#endif

}  // namespace nipref::fast::internal::NIPREF_ISA
