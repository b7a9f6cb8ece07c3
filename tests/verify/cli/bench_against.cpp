#include <doctest/doctest.h>

#include <nipref/verify/cli/report_parts.hpp>

#include "support/run_nipref.hpp"

using nipref::verify::AgainstRow;

TEST_CASE("slower is what is so in every round") {
  const AgainstRow row{"I1", "all", "fast full", 10, 12, 1.2, 1.15, 1.3, {}, {}};
  CHECK(row.slower_by(0.1));
  CHECK_FALSE(row.slower_by(0.15));
  CHECK_FALSE(AgainstRow{"I1", "all", "fast full", 10, 12, 1.2, 0.9, 1.3, {}, {}}.slower_by(0.1));
}

TEST_CASE("what is no older program, or no share, is refused") {
  check_call_refused("bench I7 --against /nowhere/nipref", "against = /nowhere/nipref: must be a nipref");
  check_call_refused("bench I7 --against /bin/true", "against = /bin/true: must be a nipref");
  check_call_refused("bench I7 --with /nowhere.so", "/nowhere.so");
  check_call_refused("bench I7 --max-slowdown 10%", "max-slowdown = 10%: must be given with --against");
  check_call_refused("bench I7 --against x --max-slowdown ten",
                     "max-slowdown = ten: must be");
}
