#pragma once

#include <nipref/fast/sheet/arithmetic/batch.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// A block of arguments for the coarse tiers. The few points of the residue tail are collected and evaluated
/// separately; all others keep their positions.
struct CoarseBlock {
  int32_t tail_count;
  alignas(64) double tail_argument[regime_capacity];
  alignas(64) double tail_value[regime_capacity];
#ifdef __AVX2__
  uint8_t is_tail[block_size / lanes];  ///< which of a vector's arguments belong to the tail
  alignas(64) uint64_t offset[block_size];
  alignas(64) double t[block_size];
  alignas(64) double rest[block_size];
#else
  int32_t tail_place[regime_capacity];
#endif
};

#ifdef __AVX2__

/// Collects the points of the tail and locates all points. The offsets of rows are stored to memory long before they are
/// loaded, because a scalar load soon after a vector store waits for it and extraction from a vector register is slow.
template <Component component, int tier>
NIPREF_INLINE void prepare(const double* argument, int32_t n, CoarseBlock& block) {
  size_t tail_count = 0;
  for (size_t i = 0; i < static_cast<size_t>(n); i += lanes) {
    const Vector x = load<Vector>(argument + i);
    const LaneBits is_tail = other_lanes(where_less(magnitude(x), all<Vector>(piece_end)));
    block.is_tail[i / lanes] = static_cast<uint8_t>(is_tail);
    compress(block.tail_argument + tail_count, is_tail, x);
    tail_count += count_lanes(is_tail);
    const CoarsePoint<Vector> at = locate_coarsely<component, tier>(magnitude(x));
    store(block.offset + i, at.offset);
    store(block.t + i, at.t);
    if constexpr (shape_of<component> == Shape::logarithmic) store(block.rest + i, at.rest);
  }
  fill_up(block.tail_argument + tail_count);
  block.tail_count = static_cast<int32_t>(tail_count);
}

template <Component component, int tier>
NIPREF_INLINE void evaluate_around_tail(const CoarseBlock& block, const double* argument, int32_t n,
                                        double* value) {
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const double* tail = block.tail_value;
  for (size_t i = 0; i < static_cast<size_t>(n); i += lanes) {
    Vector result =
        cubics<tier_works[tier].piece>(table.coarse[0], block.offset + i, load<Vector>(block.t + i));
    if constexpr (shape_of<component> == Shape::logarithmic) result += load<Vector>(block.rest + i);
    if constexpr (shape_of<component> == Shape::odd) result *= load<Vector>(argument + i);
    const LaneBits is_tail = block.is_tail[i / lanes];
    store(value + i, expand(result, is_tail, tail));
    tail += count_lanes(is_tail);
  }
}

#else

template <Component, int>
NIPREF_INLINE void prepare(const double* argument, int32_t n, CoarseBlock& block) {
  int32_t count = 0;
  for (int32_t i = 0; i < n; ++i) {
    block.tail_argument[count] = argument[i];
    block.tail_place[count] = i;
    count += __builtin_fabs(argument[i]) >= piece_end ? 1 : 0;
  }
  for (int lane = 0; lane < lanes; ++lane) block.tail_argument[count + lane] = piece_end;
  block.tail_count = count;
}

template <Component component, int tier>
NIPREF_INLINE void evaluate_around_tail(const CoarseBlock& block, const double* argument, int32_t n,
                                        double* value) {
  for (int32_t i = 0; i < n; ++i)
    value[i] = with_symmetry<component>(coarse<component, tier>(__builtin_fabs(argument[i])), argument[i]);
  for (int32_t i = 0; i < block.tail_count; ++i) value[block.tail_place[i]] = block.tail_value[i];
}

#endif

template <Component component, int tier>
NIPREF_INLINE void evaluate_tail(CoarseBlock& block) {
  const int32_t n = (block.tail_count + lanes - 1) & ~(lanes - 1);
  for (int32_t i = 0; i < n; ++i) {
    const Pair result = residue_tail<component, tier>(__builtin_fabs(block.tail_argument[i]));
    block.tail_value[i] = with_symmetry<component>(result.high + result.low, block.tail_argument[i]);
  }
}

/// A component at n <= block_size arguments of either sign, n a multiple of lanes; value may be the arguments' own array.
template <Component component, int tier>
NIPREF_INLINE void coarse_block(const double* argument, int32_t n, CoarseBlock& block, double* value) {
  prepare<component, tier>(argument, n, block);
  evaluate_tail<component, tier>(block);
  evaluate_around_tail<component, tier>(block, argument, n, value);
}

}  // namespace nipref::fast::internal::NIPREF_ISA
