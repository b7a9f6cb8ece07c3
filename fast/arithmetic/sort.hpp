#pragma once

#include "fast/arithmetic/component.hpp"

#ifdef __AVX512F__
#include <immintrin.h>  // nothing but always-inlined functions, so safe here; see floating.hpp
#endif

namespace nipref::fast::internal::NIPREF_ISA {

/// Points handled at a time: the working arrays of a block stay in the first-level cache.
inline constexpr int kBlock = 512;

/// Loops over sorted points run in whole vectors of this many.
inline constexpr int kLanes = 8;

/// Room for one regime's points, and for one vector more that sorting may write beyond them.
inline constexpr int kRegimeCapacity = kBlock + kLanes;

/// Where each regime's range begins.
inline constexpr int32_t kFirst[3] = {0, kRegimeCapacity, 2 * kRegimeCapacity};

/// Absolute values of the arguments of a block, sorted by regime, each regime in a range of its own. The last
/// vector of a range is filled up with points that are harmless in any regime.
struct SortedPoints {
  int32_t count[3];
#ifdef __AVX512F__
  __mmask8 member[kBlock / kLanes][3];  ///< which of eight arguments belong to each regime
#else
  int32_t place[kBlock];
#endif
  alignas(64) double x[3 * kRegimeCapacity];
};

#ifdef __AVX512F__

/// The first `remaining` of eight lanes, or all of them.
NIPREF_INLINE __mmask8 present_lanes(int32_t remaining) {
  return static_cast<__mmask8>(remaining >= kLanes ? 0xffu : (1u << remaining) - 1);
}

template <Component component>
NIPREF_INLINE void find_members(__m512d x, unsigned present, __mmask8* member) {
  const bool logarithmic = kShape<component> == Shape::logarithmic;
  const unsigned near =
      logarithmic ? _mm512_cmp_pd_mask(x, _mm512_set1_pd(kNearEnd), _CMP_LT_OQ) & present : 0u;
  const unsigned tail = _mm512_cmp_pd_mask(x, _mm512_set1_pd(kPieceEnd), _CMP_GE_OQ);
  member[0] = static_cast<__mmask8>(near);
  member[1] = static_cast<__mmask8>(present & ~(near | tail));
  member[2] = static_cast<__mmask8>(tail);
}

/// |argument[0 .. n)| into regimes.
template <Component component>
NIPREF_INLINE void sort(const double* argument, int32_t n, SortedPoints& points) {
  int32_t end[3] = {kFirst[0], kFirst[1], kFirst[2]};
  for (int32_t i = 0; i < n; i += kLanes) {
    const __mmask8 present = present_lanes(n - i);
    const __m512d x = _mm512_abs_pd(_mm512_maskz_loadu_pd(present, argument + i));
    __mmask8* const member = points.member[i / kLanes];
    find_members<component>(x, present, member);
#pragma GCC unroll 3
    for (int regime = 0; regime < 3; ++regime) {
      _mm512_storeu_pd(points.x + end[regime], _mm512_maskz_compress_pd(member[regime], x));
      end[regime] += __builtin_popcount(member[regime]);
    }
  }
  for (int regime = 0; regime < 3; ++regime) points.count[regime] = end[regime] - kFirst[regime];
}

/// Puts values at the sorted points back into the order of the arguments; odd components take their signs.
template <Component component>
NIPREF_INLINE void restore_order(const double* argument, int32_t n, const SortedPoints& points,
                                 const double* sorted, double* value) {
  int32_t next[3] = {kFirst[0], kFirst[1], kFirst[2]};
  for (int32_t i = 0; i < n; i += kLanes) {
    const __mmask8 present = present_lanes(n - i);
    const __mmask8* const member = points.member[i / kLanes];
    __m512d result = _mm512_setzero_pd();
#pragma GCC unroll 3
    for (int regime = 0; regime < 3; ++regime) {
      result = _mm512_mask_expand_pd(result, member[regime], _mm512_loadu_pd(sorted + next[regime]));
      next[regime] += __builtin_popcount(member[regime]);
    }
    if constexpr (kShape<component> == Shape::odd) {
      const __m512d signs = _mm512_and_pd(_mm512_maskz_loadu_pd(present, argument + i), _mm512_set1_pd(-0.0));
      result = _mm512_or_pd(result, signs);  // odd components are positive on the right
    }
    _mm512_mask_storeu_pd(value + i, present, result);
  }
}

#else

/// |argument[0 .. n)| into regimes.
template <Component component>
NIPREF_INLINE void sort(const double* argument, int32_t n, SortedPoints& points) {
  int32_t near = kFirst[0];
  int32_t middle = kFirst[1];
  int32_t tail = kFirst[2];
  for (int32_t i = 0; i < n; ++i) {
    const double x = __builtin_fabs(argument[i]);
    const int32_t is_near = is_near_zero<component>(x) ? 1 : 0;
    const int32_t is_tail = x >= kPieceEnd ? 1 : 0;
    // By masks: a compiler makes branches of conditional expressions here, which random arguments mispredict.
    const int32_t place = middle ^ ((middle ^ near) & -is_near) ^ ((middle ^ tail) & -is_tail);
    points.x[place] = x;
    points.place[i] = place;
    near += is_near;
    tail += is_tail;
    middle += 1 - is_near - is_tail;
  }
  const int32_t end[3] = {near, middle, tail};
  for (int regime = 0; regime < 3; ++regime) {
    points.count[regime] = end[regime] - kFirst[regime];
    for (int lane = 0; lane < kLanes; ++lane) points.x[end[regime] + lane] = 1;
  }
}

/// Puts values at the sorted points back into the order of the arguments; odd components take their signs.
template <Component component>
NIPREF_INLINE void restore_order(const double* argument, int32_t n, const SortedPoints& points,
                                 const double* sorted, double* value) {
  for (int32_t i = 0; i < n; ++i) value[i] = with_symmetry<component>(sorted[points.place[i]], argument[i]);
}

#endif

}  // namespace nipref::fast::internal::NIPREF_ISA
