// Positions of maxima and of sure changes of sign, for functions with known positions.
#include <nipref/fast/nip/internal/places.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

std::vector<double> even_places(double a, double b, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(std::lerp(a, b, static_cast<double>(i) / (count - 1)));
  return all;
}

/// f with the given error everywhere.
fast::PlaceFunction known_to(double error, double (*f)(double)) {
  return {f, [=](double x) { return fast::Estimate{f(x), error}; }};
}

}  // namespace

TEST_CASE("a local slope is the derivative to rounding over its reach") {
  for (const double x : {0.1, 1.0, 7.0})
    CHECK(fast::LocalSlope()([](double y) { return std::sqrt(y); }, x, x / 4) ==
          approx(0.5 / std::sqrt(x), 1e-13));
  // 16 points do not resolve this polynomial of degree 29.
  const auto swings = [](double y) { return std::cos(29 * std::acos(y)); };
  const double slope = 29 * std::sin(29 * std::acos(0.1)) / std::sin(std::acos(0.1));
  CHECK(fast::LocalSlope(30)(swings, 0.1, 0.9) == approx(slope, 1e-12));
  CHECK(fast::LocalSlope(16)(swings, 0.1, 0.9) != approx(slope, 1e-3));
}

TEST_CASE("zeros lie within their errors, which are the function's over its slope") {
  const auto zeros = fast::places_of_sure_zeros(known_to(1e-6, [](double x) { return std::sin(x); }),
                                                even_places(1, 12, 57));
  REQUIRE(zeros.size() == 3);
  for (std::size_t k = 0; k < zeros.size(); ++k) {
    CHECK(zeros[k].value == doctest::Approx(std::acos(-1.0) * static_cast<double>(k + 1)).epsilon(1e-14));
    CHECK(zeros[k].error >= 1e-6);
    CHECK(zeros[k].error < 1.5e-6);
  }
}

TEST_CASE("changes of sign that may not be there are not told") {
  // The minimum is 1e-3. With a larger error the function may cross 0 there or not.
  const auto touching = [](double x) { return 1.001 - std::cos(x); };
  CHECK(fast::places_of_sure_zeros(known_to(1e-2, touching), even_places(-1, 1, 41)).empty());
  const auto crossing = [](double x) { return 0.999 - std::cos(x); };
  CHECK(fast::places_of_sure_zeros(known_to(1e-4, crossing), even_places(-1, 1, 400)).size() == 2);
  CHECK(fast::places_of_sure_zeros(known_to(1e-2, crossing), even_places(-1, 1, 400)).empty());
}

TEST_CASE("a maximum lies within its error, and a second one that may be the larger one is in it") {
  const auto one = known_to(1e-7, [](double x) { return std::cos(x - 0.3); });
  const auto slope = known_to(1e-7, [](double x) { return -std::sin(x - 0.3); });
  const auto maxima = fast::local_maxima(one.value, even_places(-1, 1.5, 21));
  const auto found = fast::place_of_maximum(maxima, slope, one.estimate, 3);
  CHECK(found.value == doctest::Approx(0.3).epsilon(1e-14));
  CHECK(found.error >= 1e-7);
  CHECK(found.error < 1.5e-7);

  const auto two = [](double x) { return 2 + std::cos(2 * x) + 1e-5 * x; };
  const auto two_slope = known_to(1e-7, [](double x) { return -2 * std::sin(2 * x) + 1e-5; });
  const auto two_maxima = fast::local_maxima(two, even_places(-1, 4.5, 56));
  const auto sure = fast::place_of_maximum(two_maxima, two_slope, known_to(5e-7, two).estimate, 6);
  CHECK(sure.value == doctest::Approx(std::numbers::pi).epsilon(1e-5));
  CHECK(sure.error < 1e-6);
  CHECK(fast::place_of_maximum(two_maxima, two_slope, known_to(5e-5, two).estimate, 6).error >
        std::numbers::pi);
}

TEST_CASE("local maxima are found between samples, and at the ends of what is looked at") {
  const auto maxima = fast::local_maxima([](double x) { return 2 + std::sin(x); }, even_places(-4, 9, 41));
  REQUIRE(maxima.size() == 3);
  CHECK(fast::largest_of(maxima).value == doctest::Approx(3).epsilon(1e-14));
  CHECK(maxima[0].place == -4);
  CHECK(maxima[1].place == doctest::Approx(std::numbers::pi / 2).epsilon(1e-7));
  CHECK(maxima[2].place == doctest::Approx(2.5 * std::numbers::pi).epsilon(1e-7));
}
