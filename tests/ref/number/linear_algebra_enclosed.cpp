#include <nipref/ref/number/internal/linear_algebra.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

TEST_CASE("a system that may be singular within its errors is not solved") {
  const WorkingDigits working(30);
  NearlyKnownSystem system{Matrix(2, 2), Matrix(2, 1)};
  system.matrix(0, 0) = system.matrix(0, 1) = system.matrix(1, 0) = 1;
  system.right(0) = 1;
  for (const double apart : {1e-3, 1e-6}) {
    system.matrix(1, 1) = 1 + Float(apart);
    // The determinant is `apart`. Errors of the entries change it by up to four times their bound.
    system.error = apart / 2;
    CHECK_FALSE(enclosed_solutions(system));
    system.error = apart / 1000;
    CHECK(enclosed_solutions(system));
  }
}

TEST_CASE("the solutions of all systems within the errors are enclosed") {
  const WorkingDigits working(30);
  const long n = 3;
  NearlyKnownSystem system{Matrix(n, n), Matrix(n, 1)};
  for (long i = 0; i < n; ++i) {
    for (long k = 0; k < n; ++k) system.matrix(i, k) = 1 / Float(1 + i + k);
    system.right(i) = 1 + i;
  }
  for (const double coefficient : {0.0, 1e-9}) {
    for (const double right : {0.0, 1e-9}) {
      system.error = coefficient;
      system.right_error = Vector(1);
      system.right_error(0) = right;
      const auto enclosed = enclosed_solutions(system);
      REQUIRE(enclosed);
      for (int signs = 0; signs < 1 << n; ++signs) {
        Matrix matrix = system.matrix;
        Vector moved = system.right;
        for (long i = 0; i < n; ++i) {
          const int sign = (signs >> i) % 2 == 0 ? 1 : -1;
          for (long k = 0; k < n; ++k) matrix(i, k) += coefficient * sign * (k == 1 ? -1 : 1);
          moved(i) += right * sign;
        }
        const Vector solution = solve(matrix, moved);
        for (long k = 0; k < n; ++k) {
          const Interval& found = enclosed->unknowns[0][static_cast<std::size_t>(k)];
          CHECK(mpfr_cmp(found.lower(), raw(solution(k))) <= 0);
          CHECK(mpfr_cmp(found.upper(), raw(solution(k))) >= 0);
        }
      }
    }
  }
}
