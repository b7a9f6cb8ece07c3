#pragma once
#include <array>
#include <string_view>

#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

/// The functions G(z) whose Fourier transforms give the sheet kernels, by the kernels' names; S(z) = sinh 2z + 2z.
///
/// All are real on the real axis, even or odd, and meromorphic. Their poles are zeros of S: 0, if the table says so,
/// and zeros with |Im z| > 2.1. I1 also has the poles of tanh(3z/4), with |Im z| >= 2 pi/3 > 2.09.
///
///     I1              [2 sinh^2 z/S - tanh(3z/4)]/z   even   I1 = ln coth(pi a/3) + int_0^inf G cos(a x) dx
///     I3              2/S                             odd    simple pole at 0
///     I4              2 sinh z/(z S)                  odd    simple pole at 0
///     I5              2 cosh z/S                      odd    simple pole at 0
///     I6_alpha_part   2/(z S)                         even   double pole at 0; the part of I6 - I1 that depends on alpha
///     I6_eta_part     2 cosh z/(z S)                  even   double pole at 0; minus the part of I6 that depends on eta
///     I7              2 sinh z/S                      even
///
/// (thesis 4.9, 4.20; the tanh term removes the 1/z tail of I1's integrand, with
/// int_0^inf tanh(c x) cos(a x)/x dx = ln coth(pi a/(4c)).)
using Symbol = PlainKernel;

/// Constants that bound a symbol, each proven on an interval mesh by tests/ref/sheet/symbols.cpp: ref/sheet/README.md,
/// Kernels.
struct SymbolBounds {
  std::string_view name;
  bool is_odd;
  int pole;             ///< the order of the pole at 0
  double decay;         ///< r: |G(x)| = O(e^{-r x})
  double amplitude;     ///< C: min(1, x)^pole |G(x)| <= C e^{-r x} for x >= 0
  double origin_value;  ///< G_0 in G = 1/(2 z^2) + G_0 + ... (twofold pole), or G(0) of an even symbol
                        ///< without pole
  double integral;      ///< M >= int_R |G(x + iY)| dx, Y = 2 or 4 pi m
  double moment;        ///< M' Y/2 >= int |z G(z)| |dz| along Im z = Y, with the same Y; odd symbols
};

inline const SymbolBounds& bounds(Symbol symbol) {
  static constexpr std::array<SymbolBounds, 7> all{{
      {"I1", false, 0, 1.5, 1.5, -0.25, 7, 0},
      {"I3", true, 1, 2, 4.25, 0, 4, 8},
      {"I4", true, 1, 1, 2.5, 0, 3, 6},
      {"I5", true, 1, 1, 2.5, 0, 5, 12},
      {"I6_alpha_part", false, 2, 2, 2.75, -1.0 / 6, 2, 0},
      {"I6_eta_part", false, 2, 1, 1.75, 1.0 / 12, 2, 0},
      {"I7", false, 0, 1, 2.25, 0.5, 6, 0},
  }};
  return all[static_cast<std::size_t>(symbol)];
}
inline bool is_odd(Symbol symbol) { return bounds(symbol).is_odd; }

}  // namespace nipref::ref
