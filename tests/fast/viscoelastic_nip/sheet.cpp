// The sheet under line loads: plain sums or exact, each in its own units, and the surface they leave.
#include <initializer_list>

#include <nipref/fast/viscoelastic_nip/internal/sheet.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

#include "support/test.hpp"

using namespace nipref;
using fast::MovingLoad;
using fast::PlainMovingLoad;
using fast::ViscoelasticLineLoadMethod;
using fast::ViscoelasticSheet;

namespace {

constexpr double speed = 3, half = 0.125, unit = half / speed;
const data::ViscoelasticNip rolled_nip{
    6, 2 * half, {{1e-5, {{4e-4, 40.0}}}, {3e-6, {{1.2e-4, 40.0}}}}, speed};

}  // namespace

TEST_CASE("sheet: the plain sums and the exact displacements, whichever it was made for") {
  const ViscoelasticSheet plain(rolled_nip, 300), exact(rolled_nip, 0);
  const PlainMovingLoad plain_load(rolled_nip.material, speed, half, 300);
  const MovingLoad exact_load(rolled_nip.material, speed, half);
  CHECK(plain.plain() != nullptr);
  CHECK(exact.plain() == nullptr);
  for (const double T : {-1.0, 0.4, 5.0}) {
    CAPTURE(T);
    CHECK(plain.normal_displacement(2, T) == plain_load.normal_displacement(2, T));
    CHECK(exact.normal_displacement(2, T) == exact_load.normal_displacement(2 * unit, T * unit));
    CHECK(plain.tangential_displacement(2, T, 1) == plain_load.tangential_displacement(2, T, 1));
    CHECK(exact.tangential_displacement(2, T, 1) ==
          exact_load.tangential_displacement(2 * unit, T * unit, unit));
  }
}

TEST_CASE("surface under line loads: the roller's shape where it was matched, the creep between its ends") {
  for (const int terms : {0, 300}) {
    CAPTURE(terms);
    const ViscoelasticLineLoadMethod method{4, 3, 30, terms};
    const auto loads = fast::line_loads_for_length(rolled_nip, method, 0.06);
    for (int i = 0; i <= 7; ++i) {
      const double y = loads.leading_length - i * loads.element_width();
      CHECK(loads.normal_displacement(y) ==
            approx(loads.indentation - y * y / (2 * rolled_nip.roller_radius), 1e-10));
    }
    CHECK(loads.tangential_displacement(0) == 0);
    const double stretch = loads.tangential_displacement(loads.leading_length) -
                           loads.tangential_displacement(-loads.trailing_length());
    CHECK(stretch / loads.contact_length() == approx(loads.creep_ratio(), 1e-10));
  }
}

TEST_CASE("surface under line loads: bad input") {
  const ViscoelasticLineLoadMethod method{4, 3, 30, 0};
  const auto loads = fast::line_loads_for_length(rolled_nip, method, 0.06);
  CHECK_THROWS_AS((void)loads.normal_displacement(loads.loads[0].y), data::BadInput);
  CHECK_THROWS_AS((void)loads.normal_displacement(0.06 + 31 * half), data::BadInput);
  CHECK_THROWS_AS((void)loads.pressure(HUGE_VAL), data::BadInput);
}
