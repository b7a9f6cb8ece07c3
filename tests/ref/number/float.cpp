#include <doctest/doctest.h>

#include <cmath>

#include <nipref/ref/number/internal/float.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

using namespace nipref::ref;

namespace {

/// 1/(i + k + 1), whose inverse has whole entries.
Matrix hilbert(Matrix::Index size) {
  Matrix result(size, size);
  for (Matrix::Index i = 0; i < size; ++i) {
    for (Matrix::Index k = 0; k < size; ++k) result(i, k) = Float(1) / (i + k + 1);
  }
  return result;
}

double largest(const Matrix& x) {
  double result = 0;
  for (Matrix::Index k = 0; k < x.size(); ++k)
    result = std::fmax(result, std::fabs(static_cast<double>(x(k))));
  return result;
}

}  // namespace

TEST_CASE("a Float has the working digits, or those of its operands where they are more") {
  const auto bits = [](const Float& x) { return mpfr_get_prec(x.get()); };
  const WorkingDigits many(60);
  const Float third = Float(1) / 3;
  CHECK(bits(third) >= 200);
  CHECK(abs(3 * third - 1) <= std::numeric_limits<Float>::epsilon());
  {
    const WorkingDigits few(20);
    CHECK(bits(Float(1) / 3) < 80);
    CHECK(bits(Float(third)) == bits(third));
    CHECK(bits(third + 1) == bits(third));
    CHECK(bits(third.at_working_precision()) < 80);
    CHECK(third.at_working_precision() != third);
  }
  CHECK(bits(Float(1) / 3) == bits(third));
  CHECK(to_exact(third).value() != mpq_class(1, 3));
  CHECK(to_float(to_exact(third)) == third);
  CHECK(to_float(to_real(third)) == third);
}

TEST_CASE("Floats compare as numbers do, and nothing with what is none") {
  CHECK(Float(2) > Float(1.5));
  CHECK(Float(-1) < 0);
  const Float none = sqrt(Float(-1));
  CHECK(none != none);
  CHECK_FALSE(none < 1);
  CHECK_FALSE(none >= 1);
}

TEST_CASE("linear systems are solved to the working digits") {
  const WorkingDigits working(60);
  for (const Matrix::Index size : {1, 6, 20}) {
    CAPTURE(size);
    const Matrix matrix = hilbert(size);
    const double loss =
        std::pow(10, 1.55 * static_cast<double>(size));  // Hilbert's matrices are ill-conditioned
    CHECK(largest(matrix * matrix.inverse() - Matrix::identity(size)) <= 1e-60 * loss);
    Vector known(size);
    for (Matrix::Index k = 0; k < size; ++k) known(k) = 1 + k;
    CHECK(largest(solve(matrix, matrix * known) - known) <= 1e-59 * loss);
  }
  CHECK(std::fabs(static_cast<double>(hilbert(5).inverse()(4, 4) - 44100)) < 1e-45);
}

TEST_CASE("symmetric matrices have ascending eigenvalues and orthonormal vectors") {
  const WorkingDigits working(60);
  Matrix matrix(3, 3);
  matrix(0, 0) = matrix(1, 1) = matrix(2, 2) = 2;
  matrix(0, 1) = matrix(1, 0) = matrix(1, 2) = matrix(2, 1) = 1;
  const auto [values, vectors] = symmetric_eigen(matrix);
  const Float root = sqrt(Float(2));
  CHECK(static_cast<double>(abs(values(0) - (2 - root))) < 1e-57);
  CHECK(static_cast<double>(abs(values(1) - 2)) < 1e-57);
  CHECK(static_cast<double>(abs(values(2) - (2 + root))) < 1e-57);
  CHECK(largest(vectors.transpose() * vectors - Matrix::identity(3)) < 1e-57);
  CHECK(largest(matrix * vectors.column(0) - values(0) * vectors.column(0)) < 1e-57);
}
