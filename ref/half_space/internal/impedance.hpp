#pragma once
#include <Eigen/LU>
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/internal/interval_matrix.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// q_ik = n_j C_ijkl n_l - inertia delta_ik, r_ik = n_j C_ijkl m_l and t_ik = m_j C_ijkl m_l, in units of C33, with the
/// direction n of the line in the surface, m = e3, and inertia = density (speed cos(psi - theta))^2/C33. Fields
/// a exp(i kappa (n.x + s x3)) satisfy [q + s (r + r^T) + s^2 t] a = 0.
struct AcousticMatrices {
  IntervalMatrix q, r, t;
};

AcousticMatrices acoustic_matrices(const ExactStiffness& solid, const SurfaceDirection& psi,
                                   const Interval& inertia);

/// density (speed cosine)^2/C33.
Interval inertia_of(const ExactStiffness& solid, const Exact& speed, const Interval& cosine);

/// The impedance M of a half-space (Hermitian, unit C33, axes 1, 2, 3): a surface displacement u exp(i kappa n.x),
/// kappa > 0, has the traction sigma_i3 = -kappa M_ik u_k. Nothing if no enclosure is proven at the precision of the
/// matrices. An enclosure also proves that the speed is below the limiting speed. Proof: ref/half_space/README.md, The
/// response of lines; M0 and X of the proof are found in floating point, the rest is interval arithmetic.
std::optional<IntervalMatrix> surface_impedance(const AcousticMatrices& matrices);

/// A complex matrix by its parts.
template <class Scalar>
struct ComplexMatrix {
  DenseMatrix<Scalar> re, im;
};

/// The middle of an interval matrix, to the working precision.
inline ComplexMatrix<Float> middle(const IntervalMatrix& x) {
  ComplexMatrix<Float> result{Matrix(3, 3), Matrix(3, 3)};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Matrix::Index>(i), column = static_cast<Matrix::Index>(k);
      result.re(row, column) = middle_of(x(i, k).re);
      result.im(row, column) = middle_of(x(i, k).im);
    }
  }
  return result;
}

/// The impedance M of a half-space, traction = -kappa M displacement, from the Barnett-Lothe integrals
///
///     [S H; -L S^T] = (1/pi) int_0^pi N(phi) dphi,   M = H^{-1} + i H^{-1} S,
///
/// of Stroh's 6x6 matrix N = N(0). As N(phi) obeys the addition theorem of the tangent, the trapezoidal rule with 2^k
/// points is k steps of Z <- (Z - Z^{-1})/2 from Z = N. They end when the relative change of Z is below `small`; the
/// error is then about the square of `small`. Nothing after `most_doublings` steps, near the limiting speed and beyond.
template <class Scalar>
std::optional<ComplexMatrix<Scalar>> barnett_lothe_impedance(const DenseMatrix<Scalar>& q,
                                                             const DenseMatrix<Scalar>& r,
                                                             const DenseMatrix<Scalar>& t,
                                                             const Scalar& small, int most_doublings) {
  using Square = DenseMatrix<Scalar>;
  const Square compliance = t.inverse(), right = r.transpose(), above = compliance * right;
  Square z(6, 6);
  z.topLeftCorner(3, 3) = -above;
  z.topRightCorner(3, 3) = compliance;
  z.bottomLeftCorner(3, 3) = r * above - q;
  z.bottomRightCorner(3, 3) = -(r * compliance);
  for (int doubling = 0; doubling < most_doublings; ++doubling) {
    const Square next = (z - z.inverse()) / Scalar(2);
    const Scalar change = (next - z).squaredNorm();
    z = next;
    if (!(change < small * small * z.squaredNorm())) continue;
    const Square re = z.topRightCorner(3, 3).inverse();
    const Square im = re * Square(z.topLeftCorner(3, 3));
    return ComplexMatrix<Scalar>{(re + re.transpose()) / Scalar(2), (im - im.transpose()) / Scalar(2)};
  }
  return std::nullopt;
}

}  // namespace nipref::ref
