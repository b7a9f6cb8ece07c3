#include "support/test.hpp"

using nipref::data::BadInput;

TEST_CASE("the parts of a refusal come back as they were given, whatever separators are in them") {
  const BadInput error("a = b: c", "x: y = z", "must be = or: not");
  CHECK(error.argument() == "a = b: c");
  CHECK(error.value() == "x: y = z");
  CHECK(error.allowed() == "must be = or: not");
  CHECK(std::string(error.what()) == "a = b: c = x: y = z: must be = or: not");
}

TEST_CASE("a refusal is one line, whatever it is about") {
  const BadInput error("a\n", "x\r\ny", "must be\tz");
  CHECK(error.value() == "x\r\ny");
  CHECK(std::string(error.what()) == "a  = x  y: must be z");
}

TEST_CASE("a refused number is written as the shortest text that is read back as it") {
  const BadInput error("alpha", 0.1, "must be a whole number");
  CHECK(error.value() == "0.1");
  CHECK(std::string(error.what()) == "alpha = 0.1: must be a whole number");
}
