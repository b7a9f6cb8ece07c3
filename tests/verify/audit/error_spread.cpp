#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/error_spread.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>

#include "support/test.hpp"

using namespace nipref::verify;

namespace {

/// The spread of errors in ulps, each given with its point.
ErrorSpread spread_of(const std::vector<std::pair<Point, double>>& errors) {
  return error_spread(find_quantity("I6"), mapped(errors, [](const auto& error) -> Finding {
                        const auto& [point, ulps] = error;
                        return {point, ulps, ulps * 1e-16, ulps / 10};
                      }));
}

}  // namespace

TEST_CASE("errors are sorted by decades of the first argument that varies") {
  const ErrorSpread spread =
      spread_of({{{2, 0}, 1}, {{2, 0.05}, 2}, {{2, -0.07}, 20}, {{2, 3}, 4}, {{2, 9.99}, 3}, {{2, 10}, 5}});
  CHECK(spread.along == 1);
  REQUIRE(spread.decades.size() == 4);
  CHECK_FALSE(spread.decades[0].exponent.has_value());
  CHECK(*spread.decades[1].exponent == -2);
  CHECK(spread.decades[1].points == 2);
  CHECK(spread.decades[1].above == 1);
  CHECK(spread.decades[1].max_ulp == 20);
  CHECK(*spread.decades[2].exponent == 0);
  CHECK(spread.decades[2].median_ulp == 3);
  CHECK(*spread.decades[3].exponent == 1);
}

TEST_CASE("where the promise is broken is said by the smallest box of arguments") {
  const auto wrong = spread_of({{{1, 1}, 1}, {{2, 5}, 11}, {{3, 2}, 12}, {{4, 3}, 1}, {{2.5, 4}, 2}}).wrong;
  REQUIRE(wrong.has_value());
  CHECK(wrong->lower == Point{2, 2});
  CHECK(wrong->upper == Point{3, 5});
  CHECK(wrong->above == 2);
  CHECK(wrong->points == 3);
  CHECK_FALSE(spread_of({{{1, 1}, 1}}).wrong.has_value());
}

TEST_CASE("dots for a plot hold the largest error of each part of the axis, spikes among them") {
  std::vector<std::pair<Point, double>> errors;
  for (int i = 0; i < 5000; ++i)
    errors.push_back({{std::pow(10, i / 1000.0), 1}, i == 1234 ? 7 : 0.1 + 1e-5 * i});
  const auto dots = spread_of(errors).dots;
  CHECK(dots.size() > 200);
  CHECK(dots.size() <= 300);
  CHECK(std::ranges::is_sorted(dots, {}, &ErrorDot::at));
  CHECK(std::ranges::count_if(dots, &ErrorDot::largest) == 100);
  const auto spike = std::ranges::find(dots, 7.0, &ErrorDot::ulps);
  REQUIRE(spike != dots.end());
  CHECK(spike->largest);
  CHECK(spike->at == errors[1234].first[0]);
}

TEST_CASE("in a plot arguments beyond their axis lie at its ends, and errors without a number nowhere") {
  const auto dots =
      spread_of({{{0, 1}, 1}, {{-1e-300, 1}, 2}, {{-2, 1}, 3}, {{3, 1}, infinite}, {{1e300, 1}, 4}}).dots;
  REQUIRE(dots.size() == 4);
  CHECK(dots[0].at == 1e-12);
  CHECK(dots[1].at == 1e-12);
  CHECK(dots[2].at == 2);
  CHECK(dots[3].at == 1e12);
  CHECK(place_on_axis(ArgumentKind::degrees, -30) == -30);
}
