#pragma once
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

// Integrals of t^m T_k(2t - 1) over 0 <= t <= 1, k < count, alone and times what is singular at x: a row for each k, of the real and
// the imaginary part. m is 0, or 1/2 - i epsilon at an end. They follow from each other: ref/nip/README.md, Tractions on panels.
// Those of 1/(x - t), principal values, are C_{k+1} = 2 (2x - 1) C_k - C_{k-1} - 4 int t^m T_k, with more digits beyond the ends,
// where the other solution of that grows.

Matrix plain_integrals(const ComplexFloat& m, int count);

/// With x = 0 or 1 the inverse ones, which are infinite, mean nothing; with x = 1 the logarithmic ones only if m is 0.
struct SingularIntegrals {
  Matrix plain, logarithm, sign, inverse;
};
SingularIntegrals singular_integrals(const ComplexFloat& m, const Float& x, int count);

}  // namespace nipref::ref
