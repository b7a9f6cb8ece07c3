#include <doctest/doctest.h>

#include <nipref/verify/support/text.hpp>

using namespace nipref::verify;

TEST_CASE("a table's columns stay aligned whatever is in them") {
  TextTable table({"verdict", ">points", "name"});
  CHECK(table.empty());
  table.add({good("kept"), "7", "short"});
  table.add_below("worst at x = 1");
  table.add({bad("BROKEN"), "123456789", ""});
  CHECK(plain(table.text()) ==
        "verdict     points  name\n"
        "kept             7  short\n"
        "    worst at x = 1\n"
        "BROKEN   123456789\n");
  CHECK_FALSE(table.empty());
}
