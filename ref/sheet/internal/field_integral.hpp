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
/// sinh sz or a factor s; otherwise each term contains cosh sz, or both sinh sz and s. For the term 1/z (2 cosh z/S)
/// cosh sz, which has a double pole at 0, the finite part of the integral is meant.
struct FieldIntegrand {
  bool sine;
  bool odd_in_depth;
  std::vector<FieldTerm> terms;
};

/// A point of the field: 0 <= alpha <= 1000, 0 <= depth <= 1, alpha > 0 where depth is 1.
struct FieldPoint {
  Exact alpha, depth;
};

/// The integral for alpha < 1. The parts of the symbols that make it singular at the loads are integrated in closed
/// form, the other parts by the trapezoidal rule. field_line_integral bounds the aliasing of the rule on the line Im z
/// = field_line, and field_sum_remainder its truncation: ref/sheet/README.md, Inside the sheet.
Interval field_by_summation(const FieldIntegrand& integrand, const FieldPoint& at, double nats);
inline constexpr double field_line_integral = 64;  ///< proven by tests/ref/sheet/field.cpp
inline constexpr double field_line = 1.25;
inline constexpr long field_sum_remainder = 25;

/// The integral for alpha >= 1 from the residues at the roots. The truncation error after N >= 1 roots is below
/// field_series_remainder (N + 1)^2 e^{-(N + 1/2) pi alpha}, times s if odd in depth. Proof on the same page.
Interval field_by_residues(const FieldIntegrand& integrand, const FieldPoint& at, double nats);
inline constexpr long field_series_remainder = 1300;

/// The integral with an error of about e^{-nats}, times alpha if it is odd in alpha and alpha < 1, times the depth if
/// it is odd in depth.
inline Interval field_integral(const FieldIntegrand& integrand, const FieldPoint& at, double nats) {
  return at.alpha.value() >= 1 ? field_by_residues(integrand, at, nats)
                               : field_by_summation(integrand, at, nats);
}

}  // namespace nipref::ref
