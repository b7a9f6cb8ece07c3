// What a solution's last coefficients tell of what it leaves out.
#include <doctest/doctest.h>

#include <nipref/fast/nip/internal/expansion_tail.hpp>

using namespace nipref::fast;

namespace {

/// Two expansions of four terms, and another unknown; the twins differ by `noise` in the last coefficients of both.
SolutionAndTwins found(double noise) {
  SolutionAndTwins result;
  result.solution = Eigen::VectorXd{{1, 0.1, 0.03, 1e-9, 2, 0.2, 0.1, -0.01, 7}};
  result.twins = result.solution.replicate(1, 2);
  for (const int last : {3, 7}) {
    result.twins(last, 0) += noise;
    result.twins(last, 1) -= noise;
  }
  return result;
}

}  // namespace

TEST_CASE("an expansion's tail is its last coefficients, of which one may be small by chance") {
  const std::vector<double> tails = expansion_tails(found(0), 4, 2);
  REQUIRE(tails.size() == 2);
  CHECK(tails[0] == doctest::Approx(0.03 / 5));
  CHECK(tails[1] == doctest::Approx(0.1 / 5));
  // a fifth of the first: there are no more
  CHECK(expansion_tails(found(0), 2, 1).front() == doctest::Approx(0.2));
}

TEST_CASE("where twins differ by as much as an expansion's last coefficients it tells nothing") {
  CHECK(expansion_tails(found(0.1 * 0.1 / 5), 4, 2) == std::vector<double>{0, 0});
  const std::vector<double> tails = expansion_tails(found(0.05 * 0.03 / 5), 4, 2);
  CHECK(tails[0] == doctest::Approx(0.03 / 5));
  CHECK(tails[1] == doctest::Approx(0.1 / 5));
}

TEST_CASE("expansions converge at best as the kernels' singularities and their neighbours let them") {
  CHECK(fastest_on_panels(0.1) == 8);
  // Two half-thicknesses beside a panel from -1.25 to 1.25: i 8/5 of its half.
  for (const double half_length : {2.5, 5.0, 640.0})
    CHECK(fastest_on_panels(half_length) == doctest::Approx(1.2 * (1.6 + std::sqrt(1 + 1.6 * 1.6))));
}
