#include <nipref/fast/elastic_nip/line_loads.hpp>

#include "support/line_load_sums.hpp"
#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using fast::LineLoadNip;
using namespace line_load_tests;
using test::middling_nip;
using test::thick_nip;
using test::thin_nip;

TEST_CASE("u follows the cylinder and with full friction v the creep, at all 2m + 1 points, both sides") {
  const double creep = 2e-3;
  for (const data::ElasticNip& nip : {thick_nip, middling_nip, thin_nip}) {
    for (const int m : {1, 2, 5, 30}) {
      for (const data::Grip& grip : {data::Grip{}, grip_with(creep)}) {
        const double length = 1.3 * nip.sheet_thickness;
        CAPTURE(nip.sheet_thickness);
        CAPTURE(m);
        const LineLoadNip solution = fast::line_loads_for_length(nip, m, length, grip);
        const double scale =
            std::abs(solution.indentation) + solution.peak_pressure() / nip.material.young * length;
        for (int i = -m; i <= m; ++i) {
          const double y = i * length / (2 * m);
          const auto [u, v] = displacement(nip, solution, y);
          CHECK(u == doctest::Approx(solution.indentation - y * y / (2 * nip.roller_radius))
                         .epsilon(1e-10)
                         .scale(scale));
          if (solution.gripped_creep)
            CHECK(v == doctest::Approx(creep * y).epsilon(1e-10).scale(creep * length));
        }
        CHECK(solution.leading_displacement() == approx(displacement(nip, solution, length / 2).u, 1e-9));
        double total = 0;
        for (const double load : normal_loads(solution)) total += 2 * load;
        CHECK(solution.load() == approx(total, 1e-13));
      }
    }
  }
}

TEST_CASE("displacements between, outside and at the end are those of all loads together") {
  const double length = 0.1;
  const LineLoadNip gripped = fast::line_loads_for_length(middling_nip, 5, length, grip_with(1e-3));
  const LineLoadNip slipping = fast::line_loads_for_length(middling_nip, 5, length);
  for (const double y : {0.0, 0.013, -0.041, 0.05, 0.0501, -0.08, 1.5}) {
    CAPTURE(y);
    for (const LineLoadNip& solution : {gripped, slipping}) {
      const auto [u, v] = displacement(middling_nip, solution, y);
      const double scale = solution.indentation;
      CHECK(solution.normal_displacement(y) == doctest::Approx(u).epsilon(1e-11).scale(scale));
      CHECK(solution.tangential_displacement(y) == doctest::Approx(v).epsilon(1e-11).scale(scale));
    }
  }
  CHECK(gripped.tangential_displacement(length / 2) == approx(1e-3 * length / 2, 1e-11));
  CHECK_THROWS_AS((void)slipping.normal_displacement(0.005), data::BadInput);
  CHECK_THROWS_AS((void)gripped.tangential_displacement(std::nan("")), data::BadInput);
}

TEST_CASE("an element's tractions are its loads over its width, opposite shear on the other side") {
  const LineLoadNip solution = fast::line_loads_for_length(thick_nip, 3, 0.12, grip_with(-1e-3));
  const double width = 0.02;
  CHECK(solution.pressure(0.021) == approx(normal_loads(solution)[1] / width, 1e-14));
  CHECK(solution.pressure(-0.021) == solution.pressure(0.021));
  CHECK(solution.shear(0.06) == approx(shear_loads(solution)[2] / width, 1e-14));
  CHECK(solution.shear(-0.06) == -solution.shear(0.06));
  CHECK(solution.pressure(0.0601) == 0);
  CHECK(fast::line_loads_for_length(thick_nip, 3, 0.12).shear(0.01) == 0);
  CHECK_THROWS_AS((void)solution.pressure(std::nan("")), data::BadInput);
}

TEST_CASE("inside the sheet, on the line through the centres, the shear of line loads is exactly 0") {
  const fast::InnerPoint points[] = {{0, 0.3}, {0, -0.7}, {0.01, 0.3}};
  for (const data::Grip& grip : {data::Grip{}, grip_with(1e-3)}) {
    const LineLoadNip solution = fast::line_loads_for_length(thick_nip, 7, 0.1, grip);
    const auto stresses = fast::line_load_stresses(solution.loads, thick_nip.half_thickness(), points);
    CHECK(stresses[0].shear.value == 0);
    CHECK(stresses[1].shear.value == 0);
    CHECK(stresses[2].shear.value != 0);
  }
}

TEST_CASE("length for a load and load for a length are inverse, over twelve decades of load") {
  for (double length = 1e-6; length < 2; length *= 10) {
    // The creep of a thick_nip nip is proportional to its length.
    for (const data::Grip& grip : {data::Grip{}, grip_with(-1e-2 * length)}) {
      CAPTURE(length);
      const LineLoadNip solution = fast::line_loads_for_length(thick_nip, 4, length, grip);
      const LineLoadNip again = fast::line_loads_for_load(thick_nip, 4, solution.load(), grip);
      CHECK(again.load() == approx(solution.load(), 1e-12));
      CHECK(again.contact_length() == approx(length, 1e-9));
    }
  }
}
