#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>

#include "support/line_load_sums.hpp"
#include "support/test.hpp"

using namespace nipref;
using fast::LineLoadNip;
using namespace line_load_tests;

namespace {

const data::ElasticNip nip = data::seed::nip(1.0);

}  // namespace

TEST_CASE("a load is carried by the shortest length that carries it, however wide its elements are") {
  // The loads grow beyond all bounds towards half an element of about 1.24 half-thicknesses, where their kernel
  // changes its sign; behind that they are nonsense, but may be as large.
  const data::ElasticNip film{6, 0.01, {1.45e5, 1.0 / 3}};
  for (const int m : {1, 3, 9}) {
    for (const double half_element : {0.3, 1.0, 1.1, 1.2, 1.23}) {
      CAPTURE(m);
      CAPTURE(half_element);
      const LineLoadNip wanted =
          fast::line_loads_for_length(film, m, 4 * m * half_element * film.half_thickness());
      REQUIRE(wanted.load() > 0);
      const LineLoadNip found = fast::line_loads_for_load(film, m, wanted.load());
      CHECK(found.contact_length() == approx(wanted.contact_length(), 1e-10));
    }
  }
}

TEST_CASE("inside the sheet, on the line through the centres, the shear of line loads is exactly 0") {
  const fast::InnerPoint points[] = {{0, 0.3}, {0, -0.7}, {0.01, 0.3}};
  for (const data::Grip& grip : {data::Grip{}, grip_with(1e-3)}) {
    const LineLoadNip solution = fast::line_loads_for_length(nip, 7, 0.1, grip);
    const auto stresses = fast::line_load_stresses(solution.loads, nip.half_thickness(), points);
    CHECK(stresses[0].shear.value == 0);
    CHECK(stresses[1].shear.value == 0);
    CHECK(stresses[2].shear.value != 0);
  }
}

TEST_CASE("length for a load and load for a length are inverse, over twelve decades of load") {
  for (double length = 1e-6; length < 2; length *= 10) {
    // The creep of a thick nip is proportional to its length.
    for (const data::Grip& grip : {data::Grip{}, grip_with(-1e-2 * length)}) {
      CAPTURE(length);
      const LineLoadNip solution = fast::line_loads_for_length(nip, 4, length, grip);
      const LineLoadNip again = fast::line_loads_for_load(nip, 4, solution.load(), grip);
      CHECK(again.load() == approx(solution.load(), 1e-12));
      CHECK(again.contact_length() == approx(length, 1e-9));
    }
  }
}

TEST_CASE("coarser kernels change the result by no more than their tolerance times the condition") {
  const double full = fast::line_loads_for_length(nip, 5, 0.1).indentation;
  const double coarse = fast::line_loads_for_length(nip, {5, 0, fast::Accuracy(1e-9)}, 0.1).indentation;
  CHECK(coarse != full);
  CHECK(coarse == approx(full, 1e-7));
}

TEST_CASE("bad input to line loads is refused by name") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    const char* says;
    std::function<void()> solve;
  };
  const auto of_length = [](const fast::LineLoadMethod& method, double length, const data::Grip& grip = {}) {
    return [=] { (void)fast::line_loads_for_length(nip, method, length, grip); };
  };
  const auto of_nip = [](const data::ElasticNip& other) {
    return [=] { (void)fast::line_loads_for_load(other, 2, 1.0); };
  };
  for (const auto& [says, solve] : {
           Row{"elements_per_side = 0: must be from 1 to 10000", of_length(0, 0.1)},
           Row{"elements_per_side = -3: must be from 1 to 10000", of_length(-3, 0.1, grip_with(0))},
           Row{"residue_terms = -1", of_length({2, -1}, 0.1)},
           Row{"residue_terms = 501", of_length({2, 501}, 0.1)},
           Row{"contact_length = 0", of_length(2, 0)},
           Row{"contact_length = nan", of_length(2, nan)},
           Row{"creep = nan: must be finite", of_length(2, 0.1, grip_with(nan))},
           Row{"load = -1", [] { (void)fast::line_loads_for_load(nip, 2, -1.0); }},
           Row{"tolerance = 0",
               [] { (void)fast::line_loads_for_load(nip, 2, 1, grip_with(0), {.tolerance = 0}); }},
           Row{"roller_radius = 0", of_nip({0.0, 1.0, nip.material})},
           Row{"sheet_thickness = nan", of_nip({6.0, nan, nip.material})},
           Row{"poisson = 0.6", of_nip({6.0, 1.0, {1.0, 0.6}})},
           Row{"young = -1", of_nip({6.0, 1.0, {-1.0, 0.3}})},
           // Elements so wide that their loads no longer reach the next matching point.
           Row{"contact_length = ",
               [] { (void)fast::line_loads_for_length(data::seed::nip(0.005), 1, 301 * 2 * 0.005); }},
       })
    CHECK_THROWS_WITH_AS(solve(), doctest::Contains(says), data::BadInput);
}
