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

TEST_CASE("a thin sheet with memory: springs at both ends of the memory, and most resistance between") {
  // Without memory left, or with none yet, the contact is symmetric: p is a parabola about the middle.
  for (const double memory : {1e-5, 1e5}) {
    CAPTURE(memory);
    CHECK(verify::thin_standard_solid(memory).leading_share.value() == doctest::Approx(0.5).epsilon(1e-4));
    CHECK(verify::thin_standard_solid(memory).resistance.value() < 1e-4);
  }
  // A short memory's resistance is F0 tau/(2 R).
  CHECK(verify::thin_standard_solid(1e-3).resistance.value() == doctest::Approx(0.5e-3).epsilon(3e-3));
}
