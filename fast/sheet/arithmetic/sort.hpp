#pragma once

#include <nipref/fast/sheet/arithmetic/component.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// Points handled at a time: the working arrays of a block stay in the first-level cache.
inline constexpr int block_size = 512;

/// Room for one regime's points, and for one vector more that sorting may write beyond them.
inline constexpr int regime_capacity = block_size + lanes;

/// Where each regime's range begins.
inline constexpr int32_t first_of_regime[3] = {0, regime_capacity, 2 * regime_capacity};

/// Absolute values of the arguments of a block, sorted by regime, each regime in a range of its own. The last
/// vector of a range is filled up with points that are harmless in any regime.
struct SortedPoints {
  int32_t count[3];
#ifdef NIPREF_WIDE
  LaneBits is_near[block_size / lanes];  ///< which of a vector's arguments are near zero
  LaneBits is_tail[block_size / lanes];  ///< which of a vector of others are in the residue tail
  int32_t far_count;                     ///< others
#else
  int32_t place[block_size];
#endif
  alignas(64) double x[3 * regime_capacity];
};

#ifdef NIPREF_WIDE

/// Fills up the last vector of a range that ends here: what stood there before could be beyond every table.
NIPREF_INLINE void fill_up(double* end) { store(end, all(1.0)); }

/// Separates the points near zero from the others.
template <Component component>
NIPREF_INLINE void separate_near_zero(const double* argument, int32_t n, SortedPoints& points) {
  int32_t near_count = 0;
  for (int32_t i = 0; i < n; i += lanes) {
    const Wide x = magnitude(load(argument + i));
    const LaneBits is_near =
        shape_of<component> == Shape::logarithmic ? where_less(x, all(near_end)) : LaneBits{0};
    points.is_near[i / lanes] = is_near;
    if constexpr (shape_of<component> == Shape::logarithmic) compress(points.x + near_count, is_near, x);
    compress(points.x + first_of_regime[1] + (i - near_count), other_lanes(is_near), x);
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
    const Wide x = load(points.x + first_of_regime[1] + i);
    const LaneBits is_tail = other_lanes(where_less(x, all(piece_end)));
    points.is_tail[i / lanes] = is_tail;
    compress(points.x + first_of_regime[2] + count, is_tail, x);
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
NIPREF_INLINE Wide with_signs(Wide magnitude, Wide argument) {
  return from_bits(bits_of(magnitude) | (bits_of(argument) & bits_of(-0.0)));
}

NIPREF_INLINE void return_tail(const SortedPoints& points, double* sorted) {
  const double* tail = sorted + first_of_regime[2];
  for (int32_t i = 0; i < points.far_count; i += lanes) {
    double* const far = sorted + first_of_regime[1] + i;
    const LaneBits is_tail = points.is_tail[i / lanes];
    store(far, expand(load(far), is_tail, tail));
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
    const LaneBits is_near = points.is_near[i / lanes];
    const double* const far = sorted + first_of_regime[1] + (i - near_count);
    Wide result = load(far);
    if constexpr (shape_of<component> == Shape::logarithmic) {
      result = expand(expand(result, other_lanes(is_near), far), is_near, sorted + near_count);
      near_count += __builtin_popcount(is_near);
    }
    if constexpr (shape_of<component> == Shape::odd) result = with_signs(result, load(argument + i));
    store(value + i, result);
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
