#pragma once
#include <nipref/fast/sheet/arithmetic/vector.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

// Exponentials and waves for the integrals of kernels: at all nodes of a Gauss rule, or for all roots, at once.

namespace nipref::fast::internal::NIPREF_ISA {

/// e^-x for 0 <= x <= 708, to a unit in the last place: 2^-k e^r with |r| <= ln 2/2, where e^r is a Taylor polynomial.
NIPREF_INLINE double decay(double x) {
  constexpr double per_ln2 = 0x1.71547652b82fep+0;
  constexpr double rounding_shift =
      0x1.8p52;  // its addition rounds to an integer, which is then in the low bits
  constexpr Taylor<14> series(0, 1, 1);
  const double shifted = mul_add(-x, per_ln2, rounding_shift);
  const double k = shifted - rounding_shift;
  const double r = mul_add(-k, ln2_low, mul_add(-k, ln2_high, -x));
  const double power = from_bits((bits_of(shifted) + 1023) << 52);
  return horner<13>(series.of, r) * power;
}

/// value[i] = e^(-rate at[i]).
NIPREF_INLINE void decays(double rate, const double* at, double* value, size_t count) {
  for (size_t i = 0; i < count; ++i) value[i] = decay(rate * at[i]);
}

/// The even remainder of a logarithmic component, x^2 times a polynomial in x^2, at x = from + length at[i], |x| <= 1/2.
NIPREF_INLINE void even_rest(Component component, double from, double length, const double* at, double* value,
                             size_t count) {
  const double* even = component_tables[static_cast<int>(component)].even[full_tier];
  for (size_t i = 0; i < count; ++i) {
    const double x = from + length * at[i];
    value[i] = x * x * horner<tier_works[full_tier].even - 1>(even, x * x);
  }
}

/// Cosine and sine of a phase, |phase| <= 2000, with absolute error 2^-53. A multiple of pi/2 is subtracted in three words.
struct Turn {
  double cosine, sine;
};
NIPREF_INLINE Turn turn(Pair phase) {
  constexpr double per_quarter = 0x1.45f306dc9c883p-1;
  constexpr double quarter_high = 0x1.921fb54400000p+0;
  constexpr double quarter_middle = 0x1.0b4611a600000p-34;
  constexpr double quarter_low = 0x1.3198a2e037073p-69;
  constexpr double rounding_shift = 0x1.8p52;
  constexpr Taylor<8> sine_series(1, 2, -1);
  constexpr Taylor<9> cosine_series(0, 2, -1);
  const double shifted = phase.high * per_quarter + rounding_shift;
  const double quarters = shifted - rounding_shift;
  const uint64_t quadrant = bits_of(shifted);
  const double r = ((phase.high - quarters * quarter_high) - quarters * quarter_middle) +
                   (phase.low - quarters * quarter_low);
  const double sine = r * horner<7>(sine_series.of, r * r), cosine = horner<8>(cosine_series.of, r * r);
  const bool odd = (quadrant & 1) != 0;
  const double c = odd ? sine : cosine, s = odd ? cosine : sine;
  return {from_bits(bits_of(c) ^ ((quadrant + 1) >> 1 << 63)), from_bits(bits_of(s) ^ (quadrant >> 1 << 63))};
}

NIPREF_INLINE void waves(double distance_high, double distance_low, double* real, double* imaginary,
                         size_t count) {
  const RootTable& roots = root_table;
  const Pair distance = {distance_high, distance_low};
  for (size_t i = 0; i < count; ++i) {
    Pair exponent = two_product(roots.decay_high[i], distance.high);
    exponent.low += roots.decay_high[i] * distance.low + roots.decay_low[i] * distance.high;
    Pair phase = two_product(roots.frequency_high[i], distance.high);
    phase.low += roots.frequency_high[i] * distance.low + roots.frequency_low[i] * distance.high;
    const double bounded = exponent.high < 708 ? exponent.high : 708;
    const double size = exponent.high < 708 ? decay(bounded) * (1 - exponent.low) : 0;
    const Turn at = turn(phase);
    real[i] = size * at.cosine;
    imaginary[i] = size * at.sine;
  }
}

}  // namespace nipref::fast::internal::NIPREF_ISA
