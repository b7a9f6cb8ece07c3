#pragma once

// Vectors of eight doubles with AVX-512 and of four with AVX2, and functions of vectors or doubles. Arithmetic and
// comparisons are GCC's own operators on vectors; this header adds the operations that GCC lacks.

#include <stddef.h>

#include <nipref/fast/sheet/arithmetic/floating.hpp>

#ifdef __AVX2__

#include <immintrin.h>  // it has only functions that are always inlined, which floating.hpp allows

namespace nipref::fast::internal::NIPREF_ISA {

#ifdef __AVX512F__
using Vector [[gnu::vector_size(64)]] = double;
#else
using Vector [[gnu::vector_size(32)]] = double;
#endif

/// Number of doubles in a vector; loops over points run in whole vectors.
inline constexpr int lanes = sizeof(Vector) / sizeof(double);

using VectorBits [[gnu::vector_size(sizeof(Vector))]] = uint64_t;

/// One bit for each lane.
using LaneBits = uint32_t;

/// The lanes that are not in the set.
NIPREF_INLINE LaneBits other_lanes(LaneBits set) { return set ^ ((1u << lanes) - 1); }

NIPREF_INLINE VectorBits bits_of(Vector x) { return __builtin_bit_cast(VectorBits, x); }
NIPREF_INLINE Vector from_bits(VectorBits bits) { return __builtin_bit_cast(Vector, bits); }

NIPREF_INLINE auto less(Vector a, Vector b) { return a < b; }
NIPREF_INLINE Vector select(decltype(Vector{} < Vector{}) where, Vector a, Vector b) { return where ? a : b; }

/// Positions in a table, in a register and in memory. With AVX2 they are loaded from memory, as extracting them from
/// the register would take more instructions.
struct TableIndex {
  VectorBits all;
  alignas(sizeof(Vector)) uint64_t lane[lanes];

  operator const uint64_t*() const { return lane; }
};
NIPREF_INLINE TableIndex table_index(VectorBits index) {
  TableIndex at;
  at.all = index;
  __builtin_memcpy(at.lane, &index, sizeof index);
#ifndef __AVX512F__
  asm("" : "+m"(at.lane));  // makes GCC load instead of extract
#endif
  return at;
}

#ifdef __AVX512F__

/// a b + c, c - a b and -a b - c with one rounding.
NIPREF_INLINE Vector mul_add(Vector a, Vector b, Vector c) { return _mm512_fmadd_pd(a, b, c); }
NIPREF_INLINE Vector minus_mul_add(Vector a, Vector b, Vector c) { return _mm512_fnmadd_pd(a, b, c); }
NIPREF_INLINE Vector minus_mul_subtract(Vector a, Vector b, Vector c) { return _mm512_fnmsub_pd(a, b, c); }

NIPREF_INLINE Vector magnitude(Vector x) { return _mm512_abs_pd(x); }
NIPREF_INLINE Vector smaller(Vector a, Vector b) { return _mm512_min_pd(a, b); }
NIPREF_INLINE LaneBits where_less(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }

NIPREF_INLINE Decomposed<Vector> decompose(Vector x) {
  return {_mm512_getexp_pd(x), _mm512_getmant_pd(x, _MM_MANT_NORM_1_2, _MM_MANT_SIGN_zero)};
}

/// table[index/8], lane by lane, where 8 divides all.
NIPREF_INLINE Vector gather_eighths(const double* table, const TableIndex& index) {
  return _mm512_i64gather_pd(__builtin_bit_cast(__m512i, index.all), table, 1);
}

/// table[index mod 16], from two registers.
NIPREF_INLINE Vector look_up(const double (&table)[16], const TableIndex& index) {
  return _mm512_permutex2var_pd(_mm512_load_pd(table), __builtin_bit_cast(__m512i, index.all),
                                _mm512_load_pd(table + 8));
}

/// Writes the wanted lanes one after the other, and unspecified numbers behind them up to a whole vector.
NIPREF_INLINE void compress(double* to, LaneBits wanted, Vector x) {
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(wanted), x));
}

/// Puts sorted[0], sorted[1], ... into the lanes that are not in the set; the others are unspecified. The load is a
/// separate instruction: expansion from memory that was not written, with an empty mask, doubles the time of a batch.
NIPREF_INLINE Vector expand_others(LaneBits set, const double* sorted) {
  Vector from = load<Vector>(sorted);
  asm("" : "+v"(from));
  return _mm512_maskz_expand_pd(static_cast<__mmask8>(~set), from);
}

/// Puts sorted[0], sorted[1], ... into the lanes that are wanted, and keeps the others.
NIPREF_INLINE Vector expand(Vector others, LaneBits wanted, const double* sorted) {
  Vector from = load<Vector>(sorted);
  asm("" : "+v"(from));
  return _mm512_mask_expand_pd(others, static_cast<__mmask8>(wanted), from);
}

#else

/// a b + c, c - a b and -a b - c with one rounding.
NIPREF_INLINE Vector mul_add(Vector a, Vector b, Vector c) { return _mm256_fmadd_pd(a, b, c); }
NIPREF_INLINE Vector minus_mul_add(Vector a, Vector b, Vector c) { return _mm256_fnmadd_pd(a, b, c); }
NIPREF_INLINE Vector minus_mul_subtract(Vector a, Vector b, Vector c) { return _mm256_fnmsub_pd(a, b, c); }

NIPREF_INLINE Vector magnitude(Vector x) { return _mm256_andnot_pd(all<Vector>(-0.0), x); }
NIPREF_INLINE Vector smaller(Vector a, Vector b) { return _mm256_min_pd(a, b); }
NIPREF_INLINE LaneBits where_less(Vector a, Vector b) {
  return static_cast<LaneBits>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
}

/// table[index], 0 <= index < 16; AVX2's own gather takes longer than four loads on many processors.
NIPREF_INLINE Vector look_up(const double (&table)[16], const TableIndex& index) {
  return Vector{table[index.lane[0]], table[index.lane[1]], table[index.lane[2]], table[index.lane[3]]};
}

/// table[index/8], lane by lane, where 8 divides all.
NIPREF_INLINE Vector gather_eighths(const double* table, const TableIndex& index) {
  const auto at = [&](int lane) {
    return *reinterpret_cast<const double*>(reinterpret_cast<const char*>(table) + index.lane[lane]);
  };
  return Vector{at(0), at(1), at(2), at(3)};
}

/// Permutations of the 32-bit halves of a vector's doubles for one set of lanes.
struct LaneOrder {
  alignas(32) uint32_t front[8];  ///< brings the set to the front
  alignas(32) uint32_t back[8];   ///< from the front back to the set; entries of the set have the sign bit
};

struct LaneOrders {
  LaneOrder of[16]{};

  constexpr LaneOrders() {
    for (uint32_t set = 0; set < 16; ++set) {
      for (uint32_t half = 0, count = 0; half < 8; ++half) {
        if ((set >> half / 2 & 1) == 0) continue;
        of[set].front[count] = half;
        of[set].back[half] = count++ | 0x80000000;
      }
    }
  }
};

inline constexpr LaneOrders orders;

NIPREF_INLINE Vector permute(Vector x, __m256i order) {
  return _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(x), order));
}

NIPREF_INLINE __m256i load_order(const uint32_t (&order)[8]) {
  __m256i loaded;
  __builtin_memcpy(&loaded, order, sizeof loaded);
  return loaded;
}

/// Writes the wanted lanes one after the other, and unspecified numbers behind them up to a whole vector.
NIPREF_INLINE void compress(double* to, LaneBits wanted, Vector x) {
  store(to, permute(x, load_order(orders.of[wanted].front)));
}

/// Puts sorted[0], sorted[1], ... into the lanes that are not in the set; the others are unspecified.
NIPREF_INLINE Vector expand_others(LaneBits set, const double* sorted) {
  return permute(load<Vector>(sorted), load_order(orders.of[other_lanes(set)].back));
}

/// Puts sorted[0], sorted[1], ... into the lanes that are wanted, and keeps the others.
NIPREF_INLINE Vector expand(Vector others, LaneBits wanted, const double* sorted) {
  const __m256i order = load_order(orders.of[wanted].back);
  return _mm256_blendv_pd(others, permute(load<Vector>(sorted), order), _mm256_castsi256_pd(order));
}

#endif

NIPREF_INLINE void compress_others(double* to, LaneBits set, Vector x) { compress(to, other_lanes(set), x); }

NIPREF_INLINE uint32_t count_lanes(LaneBits set) { return static_cast<uint32_t>(__builtin_popcount(set)); }

}  // namespace nipref::fast::internal::NIPREF_ISA

#else

namespace nipref::fast::internal::NIPREF_ISA {

using Vector = double;

/// Loops over points run in whole groups of this many, which the compiler may vectorise.
inline constexpr int lanes = 8;

}  // namespace nipref::fast::internal::NIPREF_ISA

#endif

namespace nipref::fast::internal::NIPREF_ISA {

/// c[0] + c[1] x + ... + c[degree] x^degree.
template <int degree, class Number>
NIPREF_INLINE Number horner(const double* c, Number x) {
  Number sum = all<Number>(c[degree]);
#pragma GCC unroll 16
  for (int k = degree - 1; k >= 0; --k) sum = mul_add(sum, x, all<Number>(c[k]));
  return sum;
}

template <class Number>
NIPREF_INLINE Decomposed<Number> decompose(Number x) {
  constexpr int scaling = 54;  // makes denormal numbers normal
  const auto bits = bits_of(x * 0x1p54);
  // An integer below 2^52 in the fraction bits of 2^52 makes the double 2^52 + integer; compilers vectorise this.
  const Number biased = from_bits((bits >> 52) | 0x4330000000000000);
  return {biased - all<Number>(0x1p52 + 1023 + scaling),
          from_bits((bits & 0x000fffffffffffff) | 0x3ff0000000000000)};
}

}  // namespace nipref::fast::internal::NIPREF_ISA
