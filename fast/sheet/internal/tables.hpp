#pragma once

// Layout of the tables that generator/ writes at build time. They are not for callers of the library.

#include <nipref/fast/number/internal/tiers.hpp>

namespace nipref::fast::internal {

/// Functions of one argument x >= 0 of which every sheet kernel consists. The first five are kernels;
/// I6(a, e) = (pi/4)(e - a) + alpha_part_of_I6(a) - eta_part_of_I6(e).
enum class Component { I1, I3, I4, I5, I7, eta_part_of_I6, alpha_part_of_I6 };
inline constexpr int component_count = 7;

/// The behaviour at x = 0, on which the tables near 0 depend.
enum class Shape { logarithmic, odd, even };

constexpr Shape shape(Component component) {
  switch (component) {
    case Component::I1:
    case Component::alpha_part_of_I6:
      return Shape::logarithmic;
    case Component::I3:
    case Component::I4:
    case Component::I5:
      return Shape::odd;
    case Component::I7:
    case Component::eta_part_of_I6:
      break;
  }
  return Shape::even;
}

/// The shape for the sheet arithmetic, which may call no function that another translation unit compiles, too.
template <Component component>
inline constexpr Shape shape_of = shape(component);

// Regimes of x. Below near_end logarithmic components are -ln x + remainder; up to piece_end there are local polynomials;
// from there on the first residue alone is right to 0.1 ulp, as the second is smaller by a factor e^(-3.25 x) < 1.2e-17.
inline constexpr double near_end = 0.5;
inline constexpr double piece_end = 12;
inline constexpr double underflown = 400;  ///< from this x on the residue is 0: e^(-2.1 x) < 2^-1215

// Pieces are centred on multiples of 1/64 below x = 1, where singularities at x = 0 and x = +-i are close, and on
// multiples of 1/32 above. Row i is centred on i/64 for i <= 64, on (i - 32)/32 otherwise.
inline constexpr double fine_end = 1;
inline constexpr double fine_pieces = 64;
inline constexpr double coarse_pieces = 32;
inline constexpr int coarse_offset = 32;
inline constexpr int rows = 417;

// Rows of the coarse tiers: pieces centred on multiples of 1/32 in [0, 12], then ln m for mantissas about
// multiples of 1/32 in [1, 2].
inline constexpr int coarse_piece_rows = 385;
inline constexpr int coarse_log_rows = 33;
inline constexpr int coarse_rows = coarse_piece_rows + coarse_log_rows;

inline constexpr int log_cells = 128;
inline constexpr int short_log_cells = 16;  ///< few enough for two vector registers
inline constexpr int exponential_cells = 32;
inline constexpr int phase_cells = 64;
inline constexpr int tabulated_roots = 16;

/// The table of one component f. A number with "high" and "low" words has about 106 bits.
struct ComponentTable {
  /// In each row, f(centre + t), or f(x)/x for odd f, = power[0] + constant_low + power[1] t + ... + power[7] t^7.
  alignas(64) double power[rows][piece_degree + 1];
  double constant_low[rows];

  /// Cubics of the coarse tiers: f or f(x)/x about the centre of a piece, or (f + ln x at x -> 0) - ln(centre + t)
  /// about the centre of a mantissa.
  alignas(32) double coarse[coarse_rows][coarse_degree + 1];

  // Logarithmic components, x = 2^k (1 + mantissa) < near_end:
  //   f = log_high[cell] + log_low[cell] - k ln 2 - ln(1 + r) + odd * x + x^2 even[tier](x^2).
  double log_high[log_cells];  ///< (f + ln x at x -> 0) - ln(centre of the cell), a multiple of 2^-42
  double log_low[log_cells];
  alignas(64) double short_log_high[short_log_cells];  ///< log_high for centres 1/short_log_reciprocal
  alignas(64) double short_log_low[short_log_cells];
  double odd;
  double even[tier_count][even_degree];

  // First residue: f = limit + 2^-k (exponential[j])(cosine[p] cos b - sine[p] sin b).
  double limit_high;
  double limit_low;
  double exponential_high[exponential_cells];  ///< amplitude * 2^(-j/32)
  double exponential_low[exponential_cells];
  double cosine_high[phase_cells];  ///< cos(2 pi p/64 + phase of the residue)
  double cosine_low[phase_cells];
  double sine[phase_cells];

  double amplitude[tabulated_roots][2];  ///< A_n, real and imaginary, in f = limit + Re sum A_n e^(i z_n x)
};

/// The numbers that all components share.
struct CommonTable {
  double log_reciprocal[log_cells];                          ///< 1/centre of the cell, centre in [1, 2)
  alignas(64) double short_log_reciprocal[short_log_cells];  ///< 1/centre of the wide cell, which it defines
  double decay_high;  ///< 32 Im z_1/ln 2: cells of the exponential for unit x
  double decay_low;
  double phase_high;  ///< 64 Re z_1/(2 pi): cells of the phase for unit x
  double phase_low;
};

/// z_n = frequency + i decay, each in two words, as a distance of up to some hundreds multiplies their rounding errors.
struct RootTable {
  double frequency_high[tabulated_roots], frequency_low[tabulated_roots];
  double decay_high[tabulated_roots], decay_low[tabulated_roots];
};

extern const ComponentTable component_tables[component_count];
extern const CommonTable common_table;
extern const RootTable root_table;

}  // namespace nipref::fast::internal
