#pragma once
#include <optional>

namespace nipref::ref {

/// re + i im.
template <class Matrix>
struct Impedance {
  Matrix re, im;
};

/// Rows and columns of a 6x6 matrix by halves.
template <class Matrix>
Matrix quarter(const Matrix& whole, int lower, int right) {
  Matrix result(3, 3);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result(i, k) = whole(3 * lower + i, 3 * right + k);
  }
  return result;
}

template <class Matrix>
void set_quarter(Matrix& whole, int lower, int right, const Matrix& part) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) whole(3 * lower + i, 3 * right + k) = part(i, k);
  }
}

/// The sum of the squares of the entries of a 6x6 matrix.
template <class Matrix, class Scalar>
Scalar squared_size(const Matrix& x) {
  Scalar sum(0);
  for (int k = 0; k < 6; ++k) {
    for (int i = 0; i < 6; ++i) sum += x(i, k) * x(i, k);
  }
  return sum;
}

/// The impedance M of a half-space, traction = -|q| M displacement, from the Barnett-Lothe integrals
///
///     [S H; -L S^T] = (1/pi) int_0^pi N(phi) dphi,   M = H^{-1} + i H^{-1} S,
///
/// of Stroh's 6x6 matrix N = N(0); no roots are needed, so degenerate (isotropic) solids are not special. As
/// N(phi) obeys the addition theorem of the tangent, the trapezoidal rule with 2^k points is k steps of Z <-
/// (Z - Z^{-1})/2 from Z = N: its error squares at each step once 2^k exceeds 1/(smallest Im s). Nothing if
/// `most_doublings` do not make the relative change of Z smaller than `small`, whose square is then the
/// error: too near or beyond the limiting speed. Matrix is ref::Matrix or Eigen's in double.
template <class Matrix, class Scalar>
std::optional<Impedance<Matrix>> barnett_lothe_impedance(const Matrix& q, const Matrix& r, const Matrix& t,
                                                         const Scalar& small, int most_doublings) {
  const Matrix compliance = t.inverse();
  Matrix z(6, 6);
  set_quarter<Matrix>(z, 0, 0, -(compliance * r.transpose()));
  set_quarter<Matrix>(z, 0, 1, compliance);
  set_quarter<Matrix>(z, 1, 0, r * compliance * r.transpose() - q);
  set_quarter<Matrix>(z, 1, 1, -(r * compliance));
  for (int doubling = 0; doubling < most_doublings; ++doubling) {
    const Matrix next = (z - z.inverse()) / Scalar(2);
    const Scalar change = squared_size<Matrix, Scalar>(next - z);
    const Scalar size = squared_size<Matrix, Scalar>(next);
    z = next;
    if (!(change < small * small * size)) continue;
    const Matrix re = quarter(z, 0, 1).inverse();
    const Matrix im = re * quarter(z, 0, 0);
    return Impedance<Matrix>{(re + re.transpose()) / Scalar(2), (im - im.transpose()) / Scalar(2)};
  }
  return std::nullopt;
}

}  // namespace nipref::ref
