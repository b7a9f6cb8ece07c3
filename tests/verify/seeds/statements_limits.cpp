#include <nipref/verify/seeds/internal/solved.hpp>
#include <nipref/verify/seeds/statements.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::LimitRow;
using verify::LimitSample;
using verify::Propagated;

namespace {

/// Found values off by `distance` of a limit of 1.
LimitRow row_with(double order, double before, double last, double error = 0) {
  return {"limit.test",
          "",
          "",
          "size",
          order,
          {LimitSample{0.2, {1 + before, error}, Propagated::exact(1)},
           LimitSample{0.1, {1 - last, error}, Propagated::exact(1)}}};
}

}  // namespace

TEST_CASE("the solvers approach every limit with the power of the first term that it leaves out") {
  const std::vector<LimitRow> rows = verify::limits();
  CHECK(rows.size() >= 15);
  for (const LimitRow& row : rows) {
    CAPTURE(std::string(row.name));
    CAPTURE(row.measured_order().value_or(0).value());
    CHECK(row.approached());
    CHECK(row.samples.back().distance().value() < 0.01);
  }
}

TEST_CASE(
    "a limit that is approached too slowly, too fast, not at all, or within the error's haze is missed") {
  CHECK(row_with(2, 0.04, 0.01).approached());
  CHECK(row_with(2, 0.04, 0.01).measured_order()->value() == doctest::Approx(2));
  CHECK_FALSE(row_with(2, 0.04, 0.02).approached());
  CHECK_FALSE(row_with(1, 0.04, 0.01).approached());
  CHECK_FALSE(row_with(1, 0.02, 0.02).approached());
  CHECK_FALSE(row_with(2, 0.04, 0.01, 0.005).approached());
  CHECK(row_with(0, 0.04, 0.0001).approached());
  CHECK_FALSE(row_with(0, 0.04, 0.01).approached());
}
