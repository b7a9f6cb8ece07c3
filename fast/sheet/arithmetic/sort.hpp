#pragma once

#include <nipref/fast/sheet/arithmetic/component.hpp>

#ifdef __AVX512F__
#include <immintrin.h>  // nothing but always-inlined functions, so safe here; see floating.hpp
#endif

namespace nipref::fast::internal::NIPREF_ISA {

/// Points handled at a time: the working arrays of a block stay in the first-level cache.
inline constexpr int block_size = 512;

/// Loops over sorted points run in whole vectors of this many.
inline constexpr int lanes = 8;

/// Room for one regime's points, and for one vector more that sorting may write beyond them.
inline constexpr int regime_capacity = block_size + lanes;

/// Where each regime's range begins.
inline constexpr int32_t first_of_regime[3] = {0, regime_capacity, 2 * regime_capacity};

/// Absolute values of the arguments of a block, sorted by regime, each regime in a range of its own. The last
/// vector of a range is filled up with points that are harmless in any regime.
struct SortedPoints {
  int32_t count[3];
#ifdef __AVX512F__
  __mmask8 is_near[block_size / lanes];  ///< which of eight arguments are near zero
  __mmask8 is_tail[block_size / lanes];  ///< which of eight others are in the residue tail
  int32_t far_count;                     ///< others
#else
  int32_t place[block_size];
#endif
  alignas(64) double x[3 * regime_capacity];
};

#ifdef __AVX512F__

/// Fills up the last vector of a range that ends here: what stood there before could be beyond every table.
NIPREF_INLINE void fill_up(double* end) { _mm512_storeu_pd(end, _mm512_set1_pd(1)); }

/// Separates the points near zero from the others.
template <Component component>
NIPREF_INLINE void separate_near_zero(const double* argument, int32_t n, SortedPoints& points) {
  int32_t near_count = 0;
  for (int32_t i = 0; i < n; i += lanes) {
    const __m512d x = _mm512_abs_pd(_mm512_loadu_pd(argument + i));
    const unsigned near = shape_of<component> == Shape::logarithmic
                              ? _mm512_cmp_pd_mask(x, _mm512_set1_pd(near_end), _CMP_LT_OQ)
                              : 0u;
    const auto is_near = static_cast<__mmask8>(near);
    const auto is_far = static_cast<__mmask8>(~near);
    points.is_near[i / lanes] = is_near;
    if constexpr (shape_of<component> == Shape::logarithmic)
      _mm512_storeu_pd(points.x + near_count, _mm512_maskz_compress_pd(is_near, x));
    _mm512_storeu_pd(points.x + first_of_regime[1] + (i - near_count), _mm512_maskz_compress_pd(is_far, x));
    near_count += __builtin_popcount(is_near);
  }
  points.count[0] = near_count;
  points.far_count = n - near_count;
  fill_up(points.x + near_count);
  fill_up(points.x + first_of_regime[1] + points.far_count);
}

/// Copies the points of the residue tail from the range of the pieces, where their places remain; there they
/// are evaluated in vain, unless there is nothing else.
NIPREF_INLINE void copy_tail(SortedPoints& points) {
  int32_t count = 0;
  for (int32_t i = 0; i < points.far_count; i += lanes) {
    const __m512d x = _mm512_load_pd(points.x + first_of_regime[1] + i);
    const __mmask8 is_tail = _mm512_cmp_pd_mask(x, _mm512_set1_pd(piece_end), _CMP_GE_OQ);
    points.is_tail[i / lanes] = is_tail;
    _mm512_storeu_pd(points.x + first_of_regime[2] + count, _mm512_maskz_compress_pd(is_tail, x));
    count += __builtin_popcount(is_tail);
  }
  fill_up(points.x + first_of_regime[2] + count);
  points.count[1] = count == points.far_count ? 0 : points.far_count;
  points.count[2] = count;
}

/// |argument[0 .. n)| into regimes; n is a multiple of lanes.
template <Component component>
NIPREF_INLINE void sort(const double* argument, int32_t n, SortedPoints& points) {
  separate_near_zero<component>(argument, n, points);
  copy_tail(points);
}

/// Odd components are positive on the right.
NIPREF_INLINE __m512d with_signs(__m512d magnitude, __m512d argument) {
  return _mm512_or_pd(magnitude, _mm512_and_pd(argument, _mm512_set1_pd(-0.0)));
}

/// Takes from sorted[0], sorted[1], ... for the lanes wanted, keeps the others. The load is kept apart: where
/// a regime has no points, expansions straight from its unwritten range with an empty mask doubled the time
/// of a batch.
NIPREF_INLINE __m512d expand(__m512d others, __mmask8 wanted, const double* sorted) {
  __m512d from = _mm512_loadu_pd(sorted);
  asm("" : "+v"(from));
  return _mm512_mask_expand_pd(others, wanted, from);
}

NIPREF_INLINE void return_tail(const SortedPoints& points, double* sorted) {
  const double* tail = sorted + first_of_regime[2];
  for (int32_t i = 0; i < points.far_count; i += lanes) {
    double* const far = sorted + first_of_regime[1] + i;
    const __mmask8 is_tail = points.is_tail[i / lanes];
    _mm512_store_pd(far, expand(_mm512_load_pd(far), is_tail, tail));
    tail += __builtin_popcount(is_tail);
  }
}

/// Puts values at the sorted points back into the order of the arguments; odd components take their signs.
template <Component component>
NIPREF_INLINE void restore_order(const double* argument, int32_t n, const SortedPoints& points,
                                 double* sorted, double* value) {
  return_tail(points, sorted);
  int32_t near_count = 0;
  for (int32_t i = 0; i < n; i += lanes) {
    const __mmask8 is_near = points.is_near[i / lanes];
    const double* const far = sorted + first_of_regime[1] + (i - near_count);
    __m512d result = _mm512_loadu_pd(far);
    if constexpr (shape_of<component> == Shape::logarithmic) {
      result = expand(expand(result, static_cast<__mmask8>(~is_near), far), is_near, sorted + near_count);
      near_count += __builtin_popcount(is_near);
    }
    if constexpr (shape_of<component> == Shape::odd) {
      result = with_signs(result, _mm512_loadu_pd(argument + i));
    }
    _mm512_storeu_pd(value + i, result);
  }
}

#else

/// |argument[0 .. n)| into regimes; n is a multiple of lanes.
template <Component component>
NIPREF_INLINE void sort(const double* argument, int32_t n, SortedPoints& points) {
  int32_t near = first_of_regime[0];
  int32_t middle = first_of_regime[1];
  int32_t tail = first_of_regime[2];
  for (int32_t i = 0; i < n; ++i) {
    const double x = __builtin_fabs(argument[i]);
    const int32_t is_near = is_near_zero<component>(x) ? 1 : 0;
    const int32_t is_tail = x >= piece_end ? 1 : 0;
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
    points.count[regime] = end[regime] - first_of_regime[regime];
    for (int lane = 0; lane < lanes; ++lane) points.x[end[regime] + lane] = 1;
  }
}

/// Puts values at the sorted points back into the order of the arguments; odd components take their signs.
template <Component component>
NIPREF_INLINE void restore_order(const double* argument, int32_t n, const SortedPoints& points,
                                 double* sorted, double* value) {
  for (int32_t i = 0; i < n; ++i) value[i] = with_symmetry<component>(sorted[points.place[i]], argument[i]);
}

#endif

}  // namespace nipref::fast::internal::NIPREF_ISA
