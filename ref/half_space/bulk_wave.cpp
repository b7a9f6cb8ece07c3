#include <array>

#include <nipref/ref/half_space/bulk_wave.hpp>
#include <nipref/ref/half_space/internal/acoustic_matrices.hpp>
#include <nipref/ref/half_space/internal/complex_matrix.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

/// The indices of the eigenvectors in the order of BulkWave; the eigenvalues are in ascending order.
std::array<Matrix::Index, 3> in_order(const Matrix& vectors) {
  Matrix::Index upright = 0;
  for (const Matrix::Index k : {1, 2}) {
    if (abs(vectors(2, k)) > abs(vectors(2, upright))) upright = k;
  }
  const Matrix::Index slower = upright == 0 ? 1 : 0, faster = upright == 2 ? 1 : 2;
  return {upright, faster, slower};
}

}  // namespace

Estimate bulk_wave_speed(const ExactStiffness& solid, const SurfaceDirection& direction, BulkWave wave,
                         int digits) {
  check_digits(digits);
  const mpfr_prec_t precision = static_cast<mpfr_prec_t>(3.33 * digits) + 128;
  const WorkingDigits working(digits_of(precision));
  const IntervalMatrix q = acoustic_matrices(solid, direction, Interval(precision)).q;
  const Matrix matrix = middle(q).re;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Float, 3, 3>> eigen(matrix);
  const Matrix vectors = eigen.eigenvectors();
  const Matrix::Index number = in_order(vectors)[static_cast<std::size_t>(wave)];
  const Vector vector = vectors.col(number);
  const Float eigenvalue = eigen.eigenvalues()(number);
  const Float residual = (matrix * vector - eigenvalue * vector).norm() / vector.norm();
  const Float modulus = to_float(solid.voigt[2][2]);
  const Float density = to_float(solid.density);
  const Float speed = sqrt(eigenvalue * modulus / density);
  // The speed has half the relative error of the eigenvalue, rounding included.
  const Float rounding = matrix.norm() * pow(Float(2), 16 - static_cast<long>(precision));
  const Float error = speed * (residual + rounding) / eigenvalue;
  return {speed, error, digits};
}

}  // namespace nipref::ref
