#include <doctest/doctest.h>

#include <string>

#include <nipref/verify/support/text.hpp>

using namespace nipref::verify;

TEST_CASE("text is folded at spaces, below its last column or a little to the right") {
  const std::string word(30, 'w');
  CHECK(folded("short\n\n  as it stands\n") == "short\n\n  as it stands\n");
  CHECK(folded("  " + word + " " + word + " " + word + "\nnext") ==
        "  " + word + " " + word + "\n      " + word + "\nnext");
  CHECK(folded("name     " + word + " " + word + " " + word) ==
        "name     " + word + " " + word + "\n         " + word);
  const std::string number(200, '7');
  CHECK(folded("value  " + number) == "value  " + number);
  CHECK(folded(std::string(80, 'w')) == std::string(80, 'w'));
  CHECK(folded("a " + number + " b") == "a " + number + "\n    b");
}

TEST_CASE("colours take no columns, and can be taken away") {
  const std::string coloured = good("kept") + " and " + bad("BROKEN");
  CHECK(coloured != plain(coloured));
  CHECK(plain(coloured) == "kept and BROKEN");
  CHECK(width_of(coloured) == 15);
  CHECK(width_of("\u03bd = 1") == 5);
  const std::string wide = coloured + " " + std::string(60, 'w');
  CHECK(folded(wide) == wide);
}
