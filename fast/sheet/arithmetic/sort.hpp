#pragma once

#include <nipref/fast/sheet/arithmetic/component.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Number of points handled at a time; the working arrays of a block stay in the first-level cache.
inline constexpr int block_size = 512;

/// Room for the points of one regime, and for one more vector that sorting may write beyond them.
inline constexpr int regime_capacity = block_size + lanes;

/// The index at which the range of each regime begins.
inline constexpr int32_t first_of_regime[3] = {0, regime_capacity, 2 * regime_capacity};

/// Absolute values of the arguments of a block, sorted by regime, each regime in a range of its own. The last vector
/// of a range is padded with points that are valid in every regime.
struct SortedPoints {
  int32_t count[3];
#ifdef __AVX2__
  uint8_t is_near[block_size / lanes];  ///< which of a vector's arguments are near zero
  uint8_t is_tail[block_size / lanes];  ///< which arguments in a vector of far ones are in the residue tail
  int32_t far_count;                    ///< number of arguments not near zero
#else
  int32_t place[block_size];
#endif
  alignas(64) double x[3 * regime_capacity];
};

#ifdef __AVX2__

/// Pads the last vector of a range that ends here; otherwise its lanes could index beyond a table.
NIPREF_INLINE void fill_up(double* end) { store(end, all<Vector>(1.0)); }

/// Separates the points near zero from the far ones.
NIPREF_INLINE void separate_near_zero(const double* argument, int32_t n, SortedPoints& points) {
  size_t near_count = 0;
  for (size_t i = 0; i < static_cast<size_t>(n); i += lanes) {
    const Vector x = magnitude(load<Vector>(argument + i));
    const LaneBits is_near = where_less(x, all<Vector>(near_end));
    points.is_near[i / lanes] = static_cast<uint8_t>(is_near);
    compress(points.x + near_count, is_near, x);
    compress_others(points.x + first_of_regime[1] + (i - near_count), is_near, x);
    near_count += count_lanes(is_near);
  }
  points.count[0] = static_cast<int32_t>(near_count);
  points.far_count = n - points.count[0];
  fill_up(points.x + near_count);
  fill_up(points.x + first_of_regime[1] + points.far_count);
}

NIPREF_INLINE void take_all_as_far(const double* argument, int32_t n, SortedPoints& points) {
  for (size_t i = 0; i < static_cast<size_t>(n); i += lanes)
    store(points.x + first_of_regime[1] + i, magnitude(load<Vector>(argument + i)));
  points.count[0] = 0;
  points.far_count = n;
}

/// Separates the points of the residue tail from the pieces.
NIPREF_INLINE void separate_tail(SortedPoints& points) {
  size_t count = 0;
  const auto far_count = static_cast<size_t>(points.far_count);
  double* const far = points.x + first_of_regime[1];
  for (size_t i = 0; i < far_count; i += lanes) {
    const Vector x = load<Vector>(far + i);
    const LaneBits is_tail = other_lanes(where_less(x, all<Vector>(piece_end)));
    points.is_tail[i / lanes] = static_cast<uint8_t>(is_tail);
    compress(points.x + first_of_regime[2] + count, is_tail, x);
    compress_others(far + (i - count), is_tail, x);
    count += count_lanes(is_tail);
  }
  points.count[2] = static_cast<int32_t>(count);
  points.count[1] = points.far_count - points.count[2];
  fill_up(points.x + first_of_regime[2] + count);
  fill_up(far + points.count[1]);
}

/// Sorts |argument[0 .. n)| by regime; n is a multiple of lanes.
template <Component component>
NIPREF_INLINE void sort(const double* argument, int32_t n, SortedPoints& points) {
  if constexpr (shape_of<component> == Shape::logarithmic) {
    separate_near_zero(argument, n, points);
  } else {
    take_all_as_far(argument, n, points);
  }
  separate_tail(points);
}

/// Gives values of an odd component the signs of the arguments.
NIPREF_INLINE Vector with_signs(Vector magnitude, Vector argument) {
  return from_bits(bits_of(magnitude) | (bits_of(argument) & bits_of(-0.0)));
}

/// Puts values at the points that are not near zero into their order. For an odd component these are all points, and
/// the values get the signs of the arguments.
template <Component component>
NIPREF_INLINE void merge_tail(const double* argument, const SortedPoints& points, const double* sorted,
                              double* value) {
  const double* const piece = sorted + first_of_regime[1];
  const double* const tail = sorted + first_of_regime[2];
  size_t count = 0;
  for (size_t i = 0; i < static_cast<size_t>(points.far_count); i += lanes) {
    const LaneBits is_tail = points.is_tail[i / lanes];
    Vector result = expand(expand_others(is_tail, piece + (i - count)), is_tail, tail + count);
    if constexpr (shape_of<component> == Shape::odd) result = with_signs(result, load<Vector>(argument + i));
    store(value + i, result);
    count += count_lanes(is_tail);
  }
}

/// Puts values at the sorted points back into the order of the arguments; for odd components also their signs.
template <Component component>
NIPREF_INLINE void restore_order(const double* argument, int32_t n, const SortedPoints& points,
                                 const double* sorted, double* value) {
  if (points.count[0] == 0) return merge_tail<component>(argument, points, sorted, value);
  alignas(64) double merged[regime_capacity];
  if (points.count[2] != 0) merge_tail<component>(argument, points, sorted, merged);
  const double* const far = points.count[2] != 0 ? merged : sorted + first_of_regime[1];
  size_t near_count = 0;
  for (size_t i = 0; i < static_cast<size_t>(n); i += lanes) {
    const LaneBits is_near = points.is_near[i / lanes];
    store(value + i, expand(expand_others(is_near, far + (i - near_count)), is_near, sorted + near_count));
    near_count += count_lanes(is_near);
  }
}

#else

/// Sorts |argument[0 .. n)| by regime; n is a multiple of lanes.
template <Component component>
NIPREF_INLINE void sort(const double* argument, int32_t n, SortedPoints& points) {
  int32_t near = first_of_regime[0];
  int32_t middle = first_of_regime[1];
  int32_t tail = first_of_regime[2];
  for (int32_t i = 0; i < n; ++i) {
    const double x = __builtin_fabs(argument[i]);
    const int32_t is_near = is_near_zero<component>(x) ? 1 : 0;
    const int32_t is_tail = x >= piece_end ? 1 : 0;
    // Masks are used because conditional expressions are compiled to branches here, which random arguments mispredict.
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

/// Puts values at the sorted points back into the order of the arguments; for odd components also their signs.
template <Component component>
NIPREF_INLINE void restore_order(const double* argument, int32_t n, const SortedPoints& points,
                                 const double* sorted, double* value) {
  for (int32_t i = 0; i < n; ++i) value[i] = with_symmetry<component>(sorted[points.place[i]], argument[i]);
}

#endif

}  // namespace nipref::fast::internal::NIPREF_ISA
