#pragma once

#include <nipref/fast/sheet/arithmetic/vector.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal::NIPREF_ISA {

/// The product of x and a constant of two words, as the nearest integer, `cell`, and the rest, -1/2 <= offset <= 1/2.
struct Position {
  int64_t cell;
  double offset;
};

template <int tier>
NIPREF_INLINE Position position(double x, double constant_high, double constant_low) {
  if constexpr (tier_works[tier].compensated) {
    // x times the constant reaches 4700, where one double would leave an error of 1e-12 in the phase.
    const Pair product = two_product(x, constant_high);
    const Nearest cell = nearest(product.high);
    return {cell.integer, (product.high - cell.value) + mul_add(x, constant_low, product.low)};
  } else {
    const double product = x * constant_high;
    const Nearest cell = nearest(product);
    return {cell.integer, product - cell.value};
  }
}

/// amplitude * 2^(-position/32) without the power of two 2^-(cell/32), where cell/32 is the integer quotient.
template <Component component, int tier>
NIPREF_INLINE Pair decay(Position where) {
  constexpr double ln2_cell = 0x1.62e42fefa39efp-1 / exponential_cells;
  constexpr Taylor<6> series(1, 1, 1);
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const int64_t j = where.cell & (exponential_cells - 1);
  const double y = -ln2_cell * where.offset;
  double low = table.exponential_high[j] * (y * horner<tier_works[tier].exponential - 1>(series.of, y));
  if constexpr (tier_works[tier].compensated) low += table.exponential_low[j];
  return {table.exponential_high[j], low};
}

/// cos(2 pi position/64 + phase of the residue).
template <Component component, int tier>
NIPREF_INLINE Pair oscillation(Position where) {
  constexpr double turn_cell = 0x1.921fb54442d18p+2 / phase_cells;
  constexpr Taylor<4> sine_series(1, 2, -1);
  constexpr Taylor<5> cosine_series(0, 2, -1);
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  const int64_t p = where.cell & (phase_cells - 1);
  const double b = turn_cell * where.offset;
  const double square = b * b;
  const double sine = b * horner<tier_works[tier].sine / 2>(sine_series.of, square);
  const double cosine_minus_one =
      square * horner<tier_works[tier].cosine / 2 - 1>(cosine_series.of + 1, square);
  double low = mul_add(table.cosine_high[p], cosine_minus_one, -table.sine[p] * sine);
  if constexpr (tier_works[tier].compensated) low += table.cosine_low[p];
  return {table.cosine_high[p], low};
}

/// Multiplies by 2^-k, 0 <= k < 2000, in two halves. Each factor is a normal number, and only the second product can be
/// rounded, if it is denormal.
NIPREF_INLINE double scale_down(double x, int64_t k) {
  const int64_t half = static_cast<int64_t>(static_cast<uint64_t>(k) >> 1);
  const double first = from_bits(static_cast<uint64_t>(1023 - half) << 52);
  const double second = from_bits(static_cast<uint64_t>(1023 - (k - half)) << 52);
  return x * first * second;
}

/// A component for x >= piece_end: the sum of its limit and its first residue, which underflows gradually.
template <Component component, int tier>
NIPREF_INLINE Pair residue_tail(double x) {
  const double bounded = x < underflown ? x : underflown;
  const CommonTable& common = common_table;
  const Position decayed = position<tier>(bounded, common.decay_high, common.decay_low);
  const Pair size = decay<component, tier>(decayed);
  const Pair wave =
      oscillation<component, tier>(position<tier>(bounded, common.phase_high, common.phase_low));
  const double small = mul_add(size.high, wave.low, size.low * (wave.high + wave.low));
  const int64_t exponent = static_cast<int64_t>(static_cast<uint64_t>(decayed.cell) / exponential_cells);
  const double residue = scale_down(mul_add(size.high, wave.high, small), exponent);
  if constexpr (shape_of<component> != Shape::odd) return {residue, 0};
  const ComponentTable& table = component_tables[static_cast<int>(component)];
  return {table.limit_high, table.limit_low + residue};
}

}  // namespace nipref::fast::internal::NIPREF_ISA
