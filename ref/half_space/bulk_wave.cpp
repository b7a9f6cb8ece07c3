#include <Eigen/Eigenvalues>
#include <array>

#include <nipref/ref/half_space/bulk_wave.hpp>
#include <nipref/ref/half_space/internal/acoustic_matrices.hpp>
#include <nipref/ref/half_space/internal/interval_float.hpp>

namespace nipref::ref {
namespace {

/// Numbers of the eigenvectors, in the order of BulkWave; eigenvalues ascend.
std::array<Eigen::Index, 3> in_order(const Matrix& vectors) {
  Eigen::Index upright = 0;
  vectors.row(2).cwiseAbs().maxCoeff(&upright);
  const Eigen::Index slower = upright == 0 ? 1 : 0, faster = upright == 2 ? 1 : 2;
  return {upright, faster, slower};
}

}  // namespace

Enclosure bulk_wave_speed(const ExactStiffness& solid, const SurfaceDirection& direction, BulkWave wave,
                          int digits) {
  check_digits(digits);
  const mpfr_prec_t precision = static_cast<mpfr_prec_t>(3.33 * digits) + 128;
  const WorkingDigits working(digits_of(precision));
  const IntervalMatrix q = acoustic_matrices(solid, direction, Interval(precision)).q;
  const Matrix matrix = middle(q).re;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
  const Eigen::Index number = in_order(solver.eigenvectors())[static_cast<std::size_t>(wave)];
  const Vector vector = solver.eigenvectors().col(number);
  const Float eigenvalue = solver.eigenvalues()(number);
  const Float residual = (matrix * vector - eigenvalue * vector).norm() / vector.norm();
  Float modulus, density;
  mpfr_set_q(modulus.backend().data(), solid.voigt[2][2].get_mpq_t(), MPFR_RNDN);
  mpfr_set_q(density.backend().data(), solid.density.get_mpq_t(), MPFR_RNDN);
  const Float speed = sqrt(eigenvalue * modulus / density);
  // Half the relative error of the eigenvalue, what rounded it included.
  const Float rounding = matrix.norm() * pow(Float(2), 16 - static_cast<long>(precision));
  const Float error = speed * (residual + rounding) / eigenvalue;
  return {to_real(speed), to_real(error), digits};
}

}  // namespace nipref::ref
