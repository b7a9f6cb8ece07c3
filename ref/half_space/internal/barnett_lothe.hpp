#pragma once
#include <optional>

#include <nipref/ref/half_space/internal/complex_matrix.hpp>

namespace nipref::ref {

/// The impedance M of a half-space, traction = -|q| M displacement, from the Barnett-Lothe integrals
///
///     [S H; -L S^T] = (1/pi) int_0^pi N(phi) dphi,   M = H^{-1} + i H^{-1} S,
///
/// of Stroh's 6x6 matrix N = N(0). As N(phi) obeys the addition theorem of the tangent, the trapezoidal rule with 2^k points
/// is k steps of Z <- (Z - Z^{-1})/2 from Z = N. They end when the relative change of Z is below `small`, and the error is then
/// about the square of `small`; nothing if that takes more than `most_doublings`, near the limiting speed and beyond.
template <class Scalar>
std::optional<ComplexMatrix<Scalar>> barnett_lothe_impedance(const DenseMatrix<Scalar>& q,
                                                             const DenseMatrix<Scalar>& r,
                                                             const DenseMatrix<Scalar>& t,
                                                             const Scalar& small, int most_doublings) {
  using Square = DenseMatrix<Scalar>;
  const Square compliance = t.inverse();
  Square z(6, 6);
  z.topLeftCorner(3, 3) = -compliance * r.transpose();
  z.topRightCorner(3, 3) = compliance;
  z.bottomLeftCorner(3, 3) = r * compliance * r.transpose() - q;
  z.bottomRightCorner(3, 3) = -r * compliance;
  for (int doubling = 0; doubling < most_doublings; ++doubling) {
    const Square next = (z - z.inverse()) / Scalar(2);
    const Scalar change = (next - z).squaredNorm();
    z = next;
    if (!(change < small * small * z.squaredNorm())) continue;
    const Square re = z.topRightCorner(3, 3).inverse();
    const Square im = re * z.topLeftCorner(3, 3);
    return ComplexMatrix<Scalar>{(re + re.transpose()) / Scalar(2), (im - im.transpose()) / Scalar(2)};
  }
  return std::nullopt;
}

}  // namespace nipref::ref
