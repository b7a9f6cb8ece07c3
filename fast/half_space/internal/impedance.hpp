#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include <nipref/fast/number/internal/two_words_algebra.hpp>

namespace nipref::fast::internal {

template <class Number, std::size_t size>
using Square = std::array<std::array<Number, size>, size>;

/// The matrix with the entries entry(i, k).
template <class Number, class Entry>
Square<Number, 3> matrix_of(const Entry& entry) {
  Square<Number, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = entry(i, k);
  return result;
}

/// The inverse of a regular matrix.
Square<Two, 3> inverse(Square<Two, 3> matrix);

/// A Hermitian matrix M = re + i im.
template <class Number>
struct Impedance {
  Square<Number, 3> re, im;

  struct Complex {
    Number re, im;
  };
  /// An entry of adj(M), which is Hermitian.
  [[nodiscard]] Complex adjugate(std::size_t i, std::size_t k) const {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    // The minor without row k and column i.
    return {
        re[k1][i1] * re[k2][i2] - im[k1][i1] * im[k2][i2] - re[k1][i2] * re[k2][i1] + im[k1][i2] * im[k2][i1],
        re[k1][i1] * im[k2][i2] + im[k1][i1] * re[k2][i2] - re[k1][i2] * im[k2][i1] -
            im[k1][i2] * re[k2][i1]};
  }
  [[nodiscard]] Number determinant() const {
    Number sum = re[0][0] * adjugate(0, 0).re;
    for (const std::size_t k : {1UL, 2UL}) {
      const Complex minor = adjugate(k, 0);
      sum = sum + re[0][k] * minor.re - im[0][k] * minor.im;
    }
    return sum;
  }
};

/// Stroh's blocks of a line for the unit vector along it: Q at rest, R, and the inverse of T.
struct StrohBlocks {
  Square<Two, 3> q, r, t_inverse;
};

/// The impedance of a line whose stress density is X, or nothing unless the load is slower than the limiting speed.
///
/// Stroh's matrix N has the eigenvalues p. The matrix with the same eigenvectors and the eigenvalue i where Im p > 0, -i
/// otherwise, is the matrix sign function over i. Newton's iteration X -> (X - 1/X)/2 computes it, for degenerate solids,
/// too. Beyond the limiting speed some p are real and the iteration does not converge. The blocks S, H of this matrix are
/// Barnett and Lothe's tensors, and M = H^-1 (1 + i S).
std::optional<Impedance<double>> impedance(const StrohBlocks& blocks, double X);
/// The impedance in two words: M in double is refined by Newton's method for the Riccati equation P^H T^-1 P = Q - X,
/// P = M + i R^T (Fu and Mielke 2002). If it does not converge, close to the limiting speed, the sign function is used.
std::optional<Impedance<Two>> impedance(const StrohBlocks& blocks, Two X);

}  // namespace nipref::fast::internal
