#include <nipref/verify/cli/report_parts.hpp>

#include "support/test.hpp"

using nipref::verify::AgainstRow;

TEST_CASE("slower is what is so in every round") {
  const auto row = [](double second_round) {
    return AgainstRow{"I1", "all", "fast full", {{11.5, second_round, 13}, {10, 10, 10}, 0}, {}, {}};
  };
  CHECK(row(12).slower_by(0.1));
  CHECK_FALSE(row(12).slower_by(0.15));
  CHECK_FALSE(row(9).slower_by(0.1));
}
