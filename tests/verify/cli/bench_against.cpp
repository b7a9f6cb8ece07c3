#include <nipref/verify/cli/report_parts.hpp>

#include "support/test.hpp"

using nipref::verify::AgainstRow;

TEST_CASE("slower is what is so in every round") {
  const AgainstRow row{"I1", "all", "fast full", 10, 12, 1.2, 1.15, 1.3, {}, {}};
  CHECK(row.slower_by(0.1));
  CHECK_FALSE(row.slower_by(0.15));
  CHECK_FALSE(AgainstRow{"I1", "all", "fast full", 10, 12, 1.2, 0.9, 1.3, {}, {}}.slower_by(0.1));
}
