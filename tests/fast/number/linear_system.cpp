#include <doctest/doctest.h>

#include <cmath>

#include <nipref/fast/number/internal/linear_system.hpp>

using namespace nipref::fast;

TEST_CASE("a solution's twins spread as its condition lets rounding act") {
  // x + y = 2, x + (1 + gap) y = 2 + gap: what rounding does to the rows, y has over the gap.
  for (const double gap : {1e-2, 1e-5, 1e-8}) {
    const Eigen::MatrixXd matrix{{1, 1}, {1, 1 + gap}};
    const Eigen::VectorXd right{{2, 2 + gap}};
    const auto [solution, twins] = solution_and_twins(matrix, matrix, right);
    CHECK(solution(1) == doctest::Approx(1).epsilon(1e-15 / gap));
    REQUIRE(twins.cols() >= 4);
    const double spread = std::sqrt((twins.row(1).array() - solution(1)).square().mean()) * gap / 0x1p-52;
    CHECK(spread > 0.5);
    CHECK(spread < 20);
  }
}

TEST_CASE("twins know of summands that have cancelled in the matrix") {
  const Eigen::MatrixXd matrix{{1, 0}, {0, 1}};
  const Eigen::VectorXd right{{1, 1}};
  const Eigen::MatrixXd size{{1e6, 0}, {0, 1}};
  const auto [solution, twins] = solution_and_twins(matrix, size, right);
  const Eigen::VectorXd spread = (twins.colwise() - solution).rowwise().norm();
  CHECK(spread(0) > 1e4 * spread(1));
}
