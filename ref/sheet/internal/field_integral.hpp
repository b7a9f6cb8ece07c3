#pragma once
#include <gmpxx.h>

#include <vector>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The functions in the integrands of the field inside the sheet, S(z) = sinh 2z + 2z.
enum class FieldSymbol { sinh_over_S, cosh_over_S };  ///< 2 sinh z/S and 2 cosh z/S

/// factor z^power (symbol) (cosh sz or sinh sz), s the depth.
struct FieldTerm {
  mpq_class factor;
  int power;  ///< -1, 0 or 1
  FieldSymbol symbol;
  bool sinh;
};

/// A stress or a displacement: (1/pi) int_0^inf (sum of terms) (cos or sin)(alpha z) dz. Every term has the parity in
/// z of the cosine or sine. The sum of the factors' magnitudes is at most 4. If `odd_in_depth`, each term contains
/// sinh sz or a factor s; otherwise each contains cosh sz or both. Where 1/z (2 cosh z/S) cosh sz has a twofold pole
/// at 0, which is that of K5 below, the finite part of the integral is meant.
struct FieldIntegrand {
  bool sine;
  bool odd_in_depth;
  std::vector<FieldTerm> terms;
};

/// A point of the field: 0 <= alpha <= 1000, 0 <= depth <= 1, alpha > 0 where depth is 1.
struct FieldPoint {
  Exact alpha, depth;
};

/// The integral for alpha < 1: the parts of the symbols that are singular at the loads in closed form, the others by the
/// trapezoidal rule. Its aliasing is bounded on the line Im z = field_line by field_line_integral, its truncation by
/// field_sum_remainder: ref/sheet/README.md, Inside the sheet.
Interval field_by_summation(const FieldIntegrand& integrand, const FieldPoint& at, double nats);
inline constexpr double field_line_integral = 64;  ///< proven by tests/ref/sheet/field.cpp
inline constexpr double field_line = 1.25;
inline constexpr long field_sum_remainder = 25;

/// The integral for alpha >= 1 from the roots. The truncation error after the first N >= 1 is below field_series_remainder
/// (N + 1)^2 e^{-(N + 1/2) pi alpha}, times s if odd in depth. Proof: the same page.
Interval field_by_residues(const FieldIntegrand& integrand, const FieldPoint& at, double nats);
inline constexpr long field_series_remainder = 1300;

/// The integral with an error of about e^{-nats}, times alpha where it is odd in alpha and alpha < 1, times depth
/// where it is odd in depth. By residues from alpha = 1 on, by summation below.
inline Interval field_integral(const FieldIntegrand& integrand, const FieldPoint& at, double nats) {
  return at.alpha.value() >= 1 ? field_by_residues(integrand, at, nats)
                               : field_by_summation(integrand, at, nats);
}

}  // namespace nipref::ref
