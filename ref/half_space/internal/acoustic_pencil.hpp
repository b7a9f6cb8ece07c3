#pragma once
#include <nipref/ref/half_space/internal/acoustic_matrices.hpp>
#include <nipref/ref/half_space/internal/complex_matrix.hpp>

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

/// From the middles.
template <class Scalar>
AcousticPencil<Scalar> pencil_of(const AcousticMatrices& x) {
  return {middle(x.q).re.cast<Scalar>(), middle(x.r).re.cast<Scalar>(), middle(x.t).re.cast<Scalar>()};
}

/// The s = tan(phi), in a scan of half a turn, for which the smallest eigenvalue is smallest, and its neighbours; in double.
struct Valley {
  double left, right;
  double eigenvalue;
};

/// The valley for matrices at rest.
Valley lowest_valley(const AcousticMatrices& matrices);

/// The minimum of a function between `left` and `right`, by bisection with the sign of its slope.
template <class Scalar, class Slope>
Scalar lowest_point(const Slope& slope, Scalar left, Scalar right, int bisections) {
  for (int step = 0; step < bisections; ++step) {
    const Scalar middle = (left + right) / 2;
    (slope(middle) < 0 ? left : right) = middle;
  }
  return (left + right) / 2;
}

}  // namespace nipref::ref
