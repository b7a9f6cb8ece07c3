// The thesis's own method for the viscoelastic nip: its plain sums against exact displacements, its line loads at
// their matching points, its search for m2.
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

#include "support/softening_sheet.hpp"
#include "support/test.hpp"

using namespace nipref;
using namespace nipref::test;
using data::ViscoelasticLineLoads;
using fast::LineLoadNip;

namespace {

/// Line loads that start so long before the nip that the start is forgotten.
ViscoelasticLineLoads method(int leading, std::optional<int> trailing, int terms = 500) {
  return {leading, trailing, 30, terms};
}

LineLoadNip for_length(double relaxation_length, const ViscoelasticLineLoads& how, double length) {
  return fast::line_loads_for_length(nip(relaxation_length), how, length);
}

}  // namespace

TEST_CASE("plain sums: before the load they are exact, after it their rest falls like 0.2/N of the kernel") {
  const double speed = 3, half = 0.5, unit = half / speed;
  const data::ViscoelasticMaterial material = solid(2 * unit);
  const fast::MovingLoad exact(material, speed, half);
  const auto error = [&](int terms, double t, double T) {
    const fast::PlainMovingLoad plain(material, speed, half, terms);
    return (plain.normal_displacement(t, T) - exact.normal_displacement(t * unit, T * unit)) /
           (material.functions()->normal_compliance().terms[0].amplitude.real() * unit / std::acos(-1.0));
  };
  CHECK(std::fabs(error(500, 1, 2)) < 1e-13);
  CHECK(std::fabs(error(500, 2, -1)) < 1e-13);  // the load passed before it started
  const double t = 2.5, T = 1;
  CHECK(std::fabs(error(500, t, T)) == doctest::Approx(0.2 / 500 * std::exp(-(t - T) / 2)).epsilon(0.05));
  CHECK(error(100, t, T) / error(200, t, T) == approx(2, 0.05));
  CHECK(error(200, t, T) / error(400, t, T) == approx(2, 0.05));
}

TEST_CASE("the surface has the roller's shape where it was matched, and the creep between its ends") {
  for (const int terms : {0, 300}) {
    CAPTURE(terms);
    const LineLoadNip found = for_length(0.1, method(4, 3, terms), 0.06);
    for (int i = 0; i <= 7; ++i) {
      const double y = found.leading_length - i * found.element_width();
      CHECK(found.normal_displacement(y) == approx(found.indentation - y * y / (2 * radius), 1e-10));
    }
    CHECK(found.tangential_displacement(0) == 0);
    const double stretch = found.tangential_displacement(found.leading_length) -
                           found.tangential_displacement(-found.trailing_length());
    CHECK(stretch / found.contact_length() == approx(found.creep_ratio(), 1e-10));
  }
}

TEST_CASE("the load found is the load asked for") {
  CHECK(fast::line_loads_for_load(nip(0.1), method(5, 4), load).load() == approx(load, 1e-9));
  // No length below the roller's radius carries this load.
  data::ViscoelasticNip small = nip(0.1);
  small.roller_radius = 0.2;
  CHECK_THROWS_AS(fast::line_loads_for_load(small, method(2, 2, 0), 1e12), data::BadInput);
}

TEST_CASE("the search for m2 finds the first number from m1 down that leaves no tension") {
  const auto at = [](double relaxation_length, int trailing) {
    return fast::line_loads_for_load(nip(relaxation_length), method(10, trailing), load);
  };
  const auto searched = [](double relaxation_length) {
    return fast::line_loads_for_load(nip(relaxation_length), method(10, {}), load);
  };
  CHECK(searched(1e4).loads.size() == 20);  // nearly elastic: symmetric
  const LineLoadNip found = searched(0.1);
  const int trailing = found.trailing_elements();
  REQUIRE(trailing < 10);
  CHECK(trailing > 0);
  CHECK(found.presses_everywhere());
  for (int more = trailing + 1; more <= 10; ++more) CHECK(!at(0.1, more).presses_everywhere());
  CHECK(found.leading_length == approx(at(0.1, trailing).leading_length, 1e-9));
}

TEST_CASE("line loads refuse what is outside their domain") {
  const auto refuses = [](const ViscoelasticLineLoads& how, double length) {
    CHECK_THROWS_AS(for_length(0.1, how, length), data::BadInput);
  };
  refuses({0, 1, 5, 500}, 0.1);
  refuses({501, 1, 5, 500}, 0.1);
  refuses({2, -1, 5, 500}, 0.1);
  refuses({2, 2, 0, 500}, 0.1);
  refuses({2, 2, not_a_number, 500}, 0.1);
  refuses({2, 2, 5, 501}, 0.1);
  refuses({2, 2, 5, -1}, 0.1);
  refuses(method(2, 2), 0);
  refuses(method(2, 2), not_a_number);
  refuses(method(2, 2), 7);
  const LineLoadNip found = for_length(0.1, method(4, 3, 0), 0.06);
  CHECK_THROWS_AS((void)found.normal_displacement(found.loads[0].y), data::BadInput);
  CHECK_THROWS_AS((void)found.normal_displacement(0.06 + 31 * thickness / 2), data::BadInput);
  CHECK_THROWS_AS((void)found.pressure(HUGE_VAL), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load(nip(0.1), method(2, 2), -1), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load(nip(0.1), method(2, {}), 0), data::BadInput);
  CHECK_THROWS_AS(fast::PlainMovingLoad(solid(1), 1, 1, 0), data::BadInput);
  CHECK_THROWS_AS(fast::PlainMovingLoad(solid(1), 0, 1, 10), data::BadInput);
  CHECK_THROWS_AS(fast::PlainMovingLoad(solid(1), 1, not_a_number, 10), data::BadInput);
}
