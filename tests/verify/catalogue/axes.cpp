#include <nipref/verify/catalogue/axes.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::axis_of;
using verify::AxisValue;

namespace {

std::vector<std::string> shown(const verify::Axis& axis) {
  std::vector<std::string> texts;
  for (const AxisValue& value : axis.values) texts.push_back(value.shown);
  return texts;
}

}  // namespace

TEST_CASE("an axis is a list as it stands there, or a range by as many doubles as are asked for") {
  CHECK(shown(axis_of("alpha", "0.10,2e3,0x1p-1", 7)) == std::vector<std::string>{"0.10", "2e3", "0x1p-1"});
  CHECK(shown(axis_of("alpha", "normal", 7)) == std::vector<std::string>{"normal"});
  CHECK(shown(axis_of("alpha", "0..1:linear", 5)) ==
        std::vector<std::string>{"0", "0.25", "0.5", "0.75", "1"});
  CHECK(shown(axis_of("alpha", "1..2", 1)) == std::vector<std::string>{"1"});
}

TEST_CASE("both texts of a range's value are the same double, and no value comes twice") {
  const verify::Axis axis = axis_of("alpha", "1e-6..20:log", 1000);
  CHECK(axis.values.size() == 1000);
  for (const AxisValue& value : axis.values)
    CHECK(std::strtod(value.shown.c_str(), nullptr) == std::strtod(value.exact.c_str(), nullptr));
  CHECK(axis_of("alpha", "1..0x1.0000000000003p0:bits", 1000).values.size() == 4);
}

TEST_CASE("a product goes through all combinations, the last axis fastest") {
  const verify::AxesProduct product({axis_of("a", "1, 2", 0), axis_of("b", "x,y,z", 0)});
  REQUIRE(product.size() == 6);
  std::string all;
  for (std::size_t i = 0; i < product.size(); ++i) {
    for (const auto& [name, value] : product.assignments(i, &AxisValue::exact)) all += name + value;
    all += ' ';
  }
  CHECK(all == "a1bx a1by a1bz a2bx a2by a2bz ");
}

TEST_CASE("a comma between digits alone may be a decimal one, and is refused") {
  for (const char* text : {"1,5", "-1,5", "+0,25", "1,5e-3", "1,000,000", "0.5,1,5", "1,5, 2,5", " 1,5 "})
    CHECK_THROWS_AS((void)axis_of("alpha", text, 3), data::BadInput);
  CHECK_REFUSED(
      axis_of("alpha", "-1,5e-3", 3),
      "alpha = -1,5e-3: must be -1.5e-3 if that is one number, or '-1, 5e-3', with a blank, if it is two");
  CHECK(shown(axis_of("alpha", "1, 5", 3)) == std::vector<std::string>{"1", "5"});
  for (const char* text : {"1 ,5", "1.0,5.0", "1.,5", "1,5.", "1,-5", "1e0,5", "1,0x5"}) {
    CAPTURE(text);
    CHECK(axis_of("alpha", text, 3).values.size() == 2);
  }
}

TEST_CASE("axes that cannot be gone through are refused") {
  for (const char* text : {"1,,2", ",", "1,", "2..1", "0..1:log", "1..x"})
    CHECK_THROWS_AS((void)axis_of("alpha", text, 3), data::BadInput);
  for (const std::size_t points : {std::size_t{0}, std::size_t{10'000'001}, ~std::size_t{0}})
    CHECK_THROWS_AS((void)axis_of("alpha", "0..1:linear", points), data::BadInput);
  const verify::Axis long_one = axis_of("alpha", "0..1:linear", 4000);
  CHECK_THROWS_AS(verify::AxesProduct({long_one, long_one}), data::BadInput);
}
