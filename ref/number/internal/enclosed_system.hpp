#pragma once
#include <optional>
#include <vector>

#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// A linear system whose coefficients are known to an error.
struct NearlyKnownSystem {
  Matrix matrix;
  Matrix right;             ///< a column for each right-hand side
  Float error = 0;          ///< of each coefficient of the matrix
  Vector right_error = {};  ///< of each coefficient of a column, beyond rounding; a row for each column

  /// With all coefficients 0.
  static NearlyKnownSystem of_size(Matrix::Index unknowns, Matrix::Index right_sides) {
    return {Matrix(unknowns, unknowns), Matrix(unknowns, right_sides), 0, Vector(right_sides)};
  }
  /// Make a coefficient the middle of what contains it.
  void set(Matrix::Index row, Matrix::Index column, const Interval& value);
  void set_right(Matrix::Index row, Matrix::Index column, const Interval& value);
};

/// Enclosures of the solutions of all systems within those errors, none of which is singular.
struct EnclosedSolutions {
  std::vector<std::vector<Interval>> unknowns;  ///< by column of the right-hand side
  Float error;                                  ///< the largest radius of an unknown
  Float largest;                                ///< the largest magnitude of an unknown's middle
  Float condition;                              ///< of the matrix, in the row-sum norm
};

/// Solves with an approximate inverse C: |x - truth| <= |C (b - A x)|/(1 - |1 - C A|), with the coefficients'
/// errors and all rounding added. Nothing if the working precision does not suffice for |1 - C A| < 1/2.
std::optional<EnclosedSolutions> enclosed_solutions(const NearlyKnownSystem& system);

}  // namespace nipref::ref
