#pragma once

// Building blocks of the sheet arithmetic. Everything under arithmetic/ is compiled once for each instruction
// set, into the namespace NIPREF_ISA, so that the linker can never take one set's inline function for
// another's. For the same reason no header of the C++ library is included here. Compiled with
// -ffp-contract=off: a fused operation happens where mul_add is written and nowhere else, which the
// error-free transformations below rely on.

#include <stdint.h>

#include <nipref/data/strict_arithmetic.hpp>

#define NIPREF_INLINE [[gnu::always_inline]] static inline

namespace nipref::fast::internal::NIPREF_ISA {

/// An unevaluated sum; |low| is small against |high|, though not necessarily below half a unit of it.
struct Pair {
  double high;
  double low;
};

NIPREF_INLINE uint64_t bits_of(double x) { return __builtin_bit_cast(uint64_t, x); }
NIPREF_INLINE double from_bits(uint64_t bits) { return __builtin_bit_cast(double, bits); }

/// a b + c, with one rounding where the processor has the instruction, else with two.
NIPREF_INLINE double mul_add(double a, double b, double c) {
#ifdef __FP_FAST_FMA
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

/// a + b exactly (Knuth).
NIPREF_INLINE Pair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a b, exactly with a fused multiply-add, to 2^-106 otherwise. Splitting by mask instead of Dekker's
/// constant: no overflow.
NIPREF_INLINE Pair two_product(double a, double b) {
  const double product = a * b;
#ifdef __FP_FAST_FMA
  return {product, __builtin_fma(a, b, -product)};
#else
  constexpr uint64_t upper_half = ~((uint64_t{1} << 27) - 1);
  const double a_high = from_bits(bits_of(a) & upper_half);
  const double b_high = from_bits(bits_of(b) & upper_half);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
#endif
}

/// c[0] + c[1] x + ... + c[degree] x^degree.
template <int degree>
NIPREF_INLINE double horner(const double* c, double x) {
  double sum = c[degree];
#pragma GCC unroll 16
  for (int k = degree - 1; k >= 0; --k) sum = mul_add(sum, x, c[k]);
  return sum;
}

/// Nearest integer of 0 <= x < 2^51 as a double, and its low bits as an integer, by the shift that makes the
/// last place 1: unlike a conversion this runs in vectors on every instruction set.
struct Nearest {
  double value;
  int64_t integer;
};
NIPREF_INLINE Nearest nearest(double x) {
  constexpr double rounding_shift = 0x1p52;
  const double shifted = x + rounding_shift;
  return {shifted - rounding_shift, static_cast<int64_t>(bits_of(shifted) & 0xffffffff)};
}

}  // namespace nipref::fast::internal::NIPREF_ISA
