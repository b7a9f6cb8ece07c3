#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>

#include "support/test.hpp"

using nipref::data::BadInput;
using namespace nipref::verify;

TEST_CASE("a range is gone through evenly, by its logarithm or by the doubles in it, and its ends are met") {
  const Range linear = parse_range("alpha", "-1..3");
  CHECK(linear.spacing == Spacing::linear);
  CHECK(linear.at(0.25) == 0);
  const Range logarithmic = parse_range("alpha", "1e-4..1");
  CHECK(logarithmic.spacing == Spacing::log);
  CHECK(logarithmic.at(0.5) == doctest::Approx(1e-2));
  CHECK(parse_range("alpha", "-1..-1e-4:log").at(0.5) == doctest::Approx(-1e-2));
  CHECK(parse_range("alpha", "1..3:linear").at(0.5) == 2);
  const Range bits = parse_range("alpha", "1..4:bits");  // as many doubles from 1 to 2 as from 2 to 4
  CHECK(bits.at(0.5) == 2);
  CHECK(bits.at(0.75) == 3);
  CHECK(parse_range("alpha", "-1e10..1e10:bits").at(0.5) == 0);
  for (const char* const text :
       {"0x1p-1..0.7", "-3..1e300", "1e-300..0.3:log", "-1e308..1e308:bits", "-2..-1:bits"}) {
    CAPTURE(text);
    const Range range = parse_range("alpha", text);
    CHECK(range.at(0) == range.lower);
    CHECK(range.at(1) == range.upper);
    for (double fraction = 0; fraction < 1; fraction += 0x1p-7) {
      CHECK(range.contains(range.at(fraction)));
      CHECK(range.at(fraction) <= range.at(fraction + 0x1p-7));
    }
  }
}

TEST_CASE("a single number is a range of one, and the name of a choice its number") {
  const Range one = parse_range("alpha", "0.73");
  CHECK(one.fixed());
  CHECK(one.at(0.3) == 0.73);
  const Quantity& quantity = find_quantity("ti.rayleigh");
  const Ranges ranges = parse_ranges(quantity, {{"axis", "in-plane"}});
  REQUIRE(ranges.size() == quantity.arguments.size());
  const auto axis =
      std::ranges::find(quantity.arguments, "axis", &Argument::name) - quantity.arguments.begin();
  const auto& range = ranges[static_cast<std::size_t>(axis)];
  REQUIRE(range.has_value());
  CHECK(range->fixed());
  CHECK(quantity.arguments[static_cast<std::size_t>(axis)].choice(range->lower) == "in-plane");
  CHECK_FALSE(ranges[0].has_value());
}

TEST_CASE("a point is in the ranges if each of its numbers is") {
  const Ranges ranges = parse_ranges(find_quantity("I6"), {{"eta", "1..2"}});
  CHECK(contains(ranges, {1e9, 1.5}));
  CHECK_FALSE(contains(ranges, {1e9, 2.5}));
  CHECK(contains({}, {1e9, 2.5}));
}

TEST_CASE("what is no range is refused by the argument's name") {
  for (const char* const text : {"", "..", "1..", "..2", "2..1", "a..b", "1..2:", "1..2:cubic", "0..1:log",
                                 "-1..1:log", "1..1e400", "1e400", "nan", "1..inf", "1,2"})
    CHECK_REFUSED(parse_range("alpha", text), "alpha = " + std::string(text) + ": ");
  const Quantity& quantity = find_quantity("I6");
  CHECK_THROWS_AS(static_cast<void>(parse_ranges(quantity, {{"beta", "1..2"}})), BadInput);
  CHECK_THROWS_AS(static_cast<void>(parse_ranges(quantity, {{"eta", "1"}, {"eta", "2"}})), BadInput);
  CHECK_THROWS_AS(static_cast<void>(parse_ranges(find_quantity("ti.rayleigh"), {{"axis", "1..2"}})),
                  BadInput);
}
