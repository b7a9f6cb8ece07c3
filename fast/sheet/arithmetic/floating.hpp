#pragma once

// Building blocks of the sheet arithmetic. Everything under arithmetic/ is compiled once for each instruction set, into the
// namespace NIPREF_ISA, so that the linker cannot confuse the inline functions of two instruction sets. For the same reason
// no header of the C++ library is included here. The compiler option -ffp-contract=off makes sure that only mul_add is a
// fused operation, on which the error-free transformations below rely.

#include <stdint.h>

#include <nipref/data/strict_arithmetic.hpp>

#define NIPREF_INLINE [[gnu::always_inline]] static inline

namespace nipref::fast::internal::NIPREF_ISA {

/// An unevaluated sum. |low| is small compared with |high|, but not necessarily below half a unit in its last place.
/// Here and below, Number is double or a vector of doubles.
template <class Number>
struct Sum {
  Number high, low;
};
using Pair = Sum<double>;

NIPREF_INLINE uint64_t bits_of(double x) { return __builtin_bit_cast(uint64_t, x); }
NIPREF_INLINE double from_bits(uint64_t bits) { return __builtin_bit_cast(double, bits); }

/// a b + c, with one rounding if the processor has the instruction, otherwise with two.
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

/// a b, exact with a fused multiply-add, otherwise to 2^-106. A mask splits the factors, which, unlike Dekker's
/// constant, cannot overflow.
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

/// The integer nearest to x, 0 <= x < 2^51, as a double, and its low bits as an integer. Adding the constant whose last
/// place is 1 rounds x; unlike a conversion, this vectorises on every instruction set.
struct Nearest {
  double value;
  int64_t integer;
};
NIPREF_INLINE Nearest nearest(double x) {
  constexpr double rounding_shift = 0x1p52;
  const double shifted = x + rounding_shift;
  return {shifted - rounding_shift, static_cast<int64_t>(bits_of(shifted) & 0xffffffff)};
}

/// ln 2 in two words. The first word is a multiple of 2^-42, so that its products with exponents are exact.
inline constexpr double ln2_high = 0x1.62e42fefa38p-1, ln2_low = 0x1.ef35793c7673p-45;

/// Coefficients sign^k/(first + k step)!, k = 0 to count - 1: the series of e^x, or of sine and cosine by powers of x^2.
template <unsigned count>
struct Taylor {
  double of[count];

  constexpr Taylor(unsigned first, unsigned step, double sign) : of{} {
    double divisor = 1;
    for (unsigned k = 0, n = 0; k < count; ++k, divisor *= sign) {
      while (n < first + k * step) divisor *= ++n;
      of[k] = 1 / divisor;
    }
  }
};

/// x as a Number: the double itself, or a vector with x in every lane.
template <class Number>
NIPREF_INLINE Number all(double x) {
  return x - Number{};
}

/// Loads without __builtin_memcpy, for which GCC uses integer instructions, which are slower among those for doubles.
template <class Number>
NIPREF_INLINE Number load(const double* from) {
  using InMemory [[gnu::aligned(8), gnu::may_alias]] = Number;
  return *reinterpret_cast<const InMemory*>(from);
}
template <class Place, class Number>
NIPREF_INLINE void store(Place* to, Number x) {
  using InMemory [[gnu::aligned(8), gnu::may_alias]] = Number;
  *reinterpret_cast<InMemory*>(to) = x;
}

/// x = 2^exponent * mantissa, 1 <= mantissa < 2, for 0 < x < 2^969, denormal x included. For other x it is unspecified.
template <class Number>
struct Decomposed {
  Number exponent, mantissa;
};

// For double, the functions that vector.hpp has for vectors, under the same names.

/// c - a b and -a b - c, rounded like mul_add.
NIPREF_INLINE double minus_mul_add(double a, double b, double c) { return mul_add(-a, b, c); }
NIPREF_INLINE double minus_mul_subtract(double a, double b, double c) { return -mul_add(a, b, c); }

NIPREF_INLINE double smaller(double a, double b) { return a < b ? a : b; }

/// Uses masks, as conditional expressions may be compiled to branches, which random arguments mispredict.
NIPREF_INLINE uint64_t less(double a, double b) { return a < b ? ~uint64_t{0} : 0; }
NIPREF_INLINE double select(uint64_t where, double a, double b) {
  return from_bits((bits_of(a) & where) | (bits_of(b) & ~where));
}

NIPREF_INLINE uint64_t table_index(uint64_t index) { return index; }
NIPREF_INLINE double gather_eighths(const double* table, uint64_t index) { return table[index / 8]; }
NIPREF_INLINE double look_up(const double (&table)[16], uint64_t index) { return table[index]; }

}  // namespace nipref::fast::internal::NIPREF_ISA
