#pragma once
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

/// q + s (r + r^T) + s^2 t at rest, in floating point.
template <class Scalar>
struct AcousticPencil {
  DenseMatrix<Scalar> q, r, t;

  [[nodiscard]] DenseMatrix<Scalar> at(const Scalar& s) const {
    return q + s * (r + r.transpose()) + s * s * t;
  }
  [[nodiscard]] Scalar lowest_value(const Scalar& s) const {
    return Eigen::SelfAdjointEigenSolver<Square>(at(s), Eigen::EigenvaluesOnly).eigenvalues()(0);
  }
  /// The eigenvector of the smallest eigenvalue.
  [[nodiscard]] DenseMatrix<Scalar> lowest_vector(const Scalar& s) const {
    return Eigen::SelfAdjointEigenSolver<Square>(at(s)).eigenvectors().col(0);
  }
  /// Half the derivative of the smallest eigenvalue, x.((r + r^T) + 2 s t).x/2.
  [[nodiscard]] Scalar half_slope(const Scalar& s) const {
    const Eigen::Matrix<Scalar, 3, 1> x = lowest_vector(s);
    return x.dot(r * x) + s * x.dot(t * x);
  }

 private:
  using Square = Eigen::Matrix<Scalar, 3, 3>;
};

}  // namespace nipref::ref
