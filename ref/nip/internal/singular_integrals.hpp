#pragma once
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

// Integrals of t^m T_k(2t - 1) over 0 <= t <= 1, k < count, alone and times functions that are singular at x. A matrix
// has a row for each k: real part, imaginary part. m is 0, or 1/2 - i epsilon at an end. The integrals follow from
// recurrences: ref/nip/README.md, Tractions on panels. That of the principal values C_k with 1/(x - t) is C_{k+1} =
// 2 (2x - 1) C_k - C_{k-1} - 4 int t^m T_k. It takes more digits for x outside 0 .. 1, where its other solution grows.

Matrix plain_integrals(const ComplexFloat& m, int count);

/// If x is 0 or 1, `inverse` would be infinite and is meaningless. If x is 1, `logarithm` is meaningful only for m = 0.
struct SingularIntegrals {
  Matrix plain, logarithm, sign, inverse;
};
SingularIntegrals singular_integrals(const ComplexFloat& m, const Float& x, int count);

}  // namespace nipref::ref
