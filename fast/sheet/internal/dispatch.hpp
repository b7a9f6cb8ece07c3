#pragma once

// The sheet arithmetic is compiled once for each instruction set (arithmetic/entry_points.cpp). SheetCode is the table of
// its entry points. They expect checked arguments: finite, and not 0 if the component is infinite at 0.

#include <stddef.h>

#include <nipref/fast/number/internal/instruction_level.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal {

/// The arguments for which a kernel is defined.
enum class Domain { finite, finite_nonzero };

inline constexpr int batch_components = 5;   ///< I1, I3, I4, I5, I7
inline constexpr int scalar_components = 6;  ///< and eta_part_of_I6

struct SheetCode {
  const char* instruction_set;
  bool (*all_in_domain)(const double*, size_t, Domain);
  double (*scalar[scalar_components][tier_count])(double);
  void (*batch[batch_components][tier_count])(const double*, double*, size_t);
  double (*scalar_i6[tier_count])(double, double);
  void (*batch_i6[tier_count])(const double*, const double*, double*, size_t);
  /// value[i] = e^(-rate at[i]), 0 <= rate at[i] <= 708.
  void (*decays)(double rate, const double* at, double* value, size_t count);
  /// e^(i z_n distance) for the first `count` tabulated roots, 0 <= distance <= 500; 0 if its modulus is e^-708 or less.
  void (*waves)(double distance_high, double distance_low, double* real, double* imaginary, size_t count);
  /// For a logarithmic component f: value[i] is f(x) + ln|x| minus its limit at 0 and minus the odd term, at
  /// x = from + length at[i], |x| <= 1/2.
  void (*even_rest)(Component, double from, double length, const double* at, double* value, size_t count);
};

namespace baseline {
extern const SheetCode code;
}
namespace v3 {
extern const SheetCode code;
}
namespace v4 {
extern const SheetCode code;
}

/// The code for each instruction set; null where none was compiled.
extern const SheetCode* const sheet_codes[instruction_set_count];
inline const SheetCode& sheet_code() { return *sheet_codes[chosen_instruction_set]; }

}  // namespace nipref::fast::internal
