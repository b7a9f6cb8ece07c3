#include <nipref/ref/number/internal/linear_algebra.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

namespace {

/// The largest difference divided by the largest entry.
double difference(const Vector& x, const Vector& y) {
  Float apart = 0, largest = 0;
  for (Vector::Index i = 0; i < x.size(); ++i) {
    apart = std::max(apart, abs(x(i) - y(i)));
    largest = std::max(largest, abs(y(i)));
  }
  return static_cast<double>(apart / largest);
}

}  // namespace

TEST_CASE("a refined solution is the eliminated one, of random and of nearly singular matrices") {
  const WorkingDigits working(60);
  const long n = 30;
  std::mt19937 random(3);
  const auto entry = [&] { return std::uniform_real_distribution<>(-1, 1)(random); };
  Vector truth(n);
  for (long i = 0; i < n; ++i) truth(i) = entry() / Float(3);
  Matrix well(n, n), hilbert(n, n);
  for (long i = 0; i < n; ++i) {
    for (long k = 0; k < n; ++k) {
      well(i, k) = entry() / Float(7);
      hilbert(i, k) = 1 / Float(1 + i + k);
    }
  }
  CHECK(difference(refined_solution(well, well * truth), truth) <= 1e-56);
  // The condition number of Hilbert's matrix is 1e44 here.
  CHECK(difference(refined_solution(hilbert, hilbert * truth), truth) <= 1e-14);
  const Vector nothing(n);
  CHECK(refined_solution(well, nothing).squaredNorm() == 0);
}

TEST_CASE("a solution whose residual is not a number is refused") {
  const WorkingDigits working(50);
  DenseMatrix<double> identity(1, 1);
  identity(0, 0) = 1;
  Vector right(1);
  right(0) = 1;
  const Float zero = 0;
  CHECK_FALSE(refined_solution(EliminatedInDouble(identity), right, [&](const Vector&) {
                Vector none(1);
                none(0) = zero / zero;
                return none;
              }).has_value());
}
