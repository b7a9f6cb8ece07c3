#pragma once
#include <Eigen/LU>
#include <optional>

namespace nipref::ref {

/// re + i im.
template <class Matrix>
struct ComplexMatrix {
  Matrix re, im;
};

/// The impedance M of a half-space, traction = -|q| M displacement, from the Barnett-Lothe integrals
///
///     [S H; -L S^T] = (1/pi) int_0^pi N(phi) dphi,   M = H^{-1} + i H^{-1} S,
///
/// of Stroh's 6x6 matrix N = N(0); no roots are needed, so degenerate (isotropic) solids are not special. As
/// N(phi) obeys the addition theorem of the tangent, the trapezoidal rule with 2^k points is k steps of Z <-
/// (Z - Z^{-1})/2 from Z = N: its error squares at each step once 2^k exceeds 1/(smallest Im s). Nothing if
/// `most_doublings` do not make the relative change of Z smaller than `small`, whose square is then the
/// error: too near or beyond the limiting speed.
template <class Matrix, class Scalar>
std::optional<ComplexMatrix<Matrix>> barnett_lothe_impedance(const Matrix& q, const Matrix& r,
                                                             const Matrix& t, const Scalar& small,
                                                             int most_doublings) {
  const Matrix compliance = t.inverse();
  Matrix z(6, 6);
  z.topLeftCorner(3, 3) = -compliance * r.transpose();
  z.topRightCorner(3, 3) = compliance;
  z.bottomLeftCorner(3, 3) = r * compliance * r.transpose() - q;
  z.bottomRightCorner(3, 3) = -r * compliance;
  for (int doubling = 0; doubling < most_doublings; ++doubling) {
    const Matrix next = (z - z.inverse()) / Scalar(2);
    const Scalar change = (next - z).squaredNorm();
    const Scalar size = next.squaredNorm();
    z = next;
    if (!(change < small * small * size)) continue;
    const Matrix re = z.topRightCorner(3, 3).inverse();
    const Matrix im = re * z.topLeftCorner(3, 3);
    return ComplexMatrix<Matrix>{(re + re.transpose()) / Scalar(2), (im - im.transpose()) / Scalar(2)};
  }
  return std::nullopt;
}

}  // namespace nipref::ref
