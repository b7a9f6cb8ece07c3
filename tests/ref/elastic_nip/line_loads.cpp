// Line loads in multiprecision: bounds, independent routes, and what the double path loses against them.
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/sheet/displacements.hpp>

#include "support/reference_values.hpp"
#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using data::ElasticNip;
using test::quarter_inch_nip;

TEST_CASE("ref line loads: fewer digits enclose more digits") {
  for (const double length : {1e-3, 0.1, 2.0}) {
    const auto coarse =
        ref::line_loads_for_length(quarter_inch_nip, 4, length, 20, {ref::Grip::Creep::given, 1e-3});
    const auto fine =
        ref::line_loads_for_length(quarter_inch_nip, 4, length, 60, {ref::Grip::Creep::given, 1e-3});
    CHECK(difference(coarse.indentation, fine.indentation) <=
          error(coarse.indentation) + error(fine.indentation));
    CHECK(error(coarse.indentation) <= 1e-20 * std::fabs(coarse.indentation.to_double()) * 1e3);
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(difference(coarse.line_loads[k], fine.line_loads[k]) <= error(coarse.line_loads[k]));
      CHECK(difference(coarse.shear_loads[k], fine.shear_loads[k]) <= error(coarse.shear_loads[k]));
    }
  }
}

TEST_CASE("ref line loads displace the sheet to the roller, summed load by load without the symmetry") {
  const int m = 3;
  const ref::Exact young(quarter_inch_nip.material.young), poisson(quarter_inch_nip.material.poisson);
  const double length = 0.375, creep = -0.0009765625;  // exact in binary, so that all distances are
  const auto solution =
      ref::line_loads_for_length(quarter_inch_nip, m, length, 40, {ref::Grip::Creep::given, creep});
  for (int i = -m; i <= m; ++i) {
    double u = 0, v = 0;
    for (int k = -m; k < m; ++k) {
      const auto index = static_cast<std::size_t>(k < 0 ? -k - 1 : k);
      const double force = solution.line_loads[index].to_double();
      const double shear = (k < 0 ? -1 : 1) * solution.shear_loads[index].to_double();
      const ref::Exact alpha((2 * (i - k) - 1) * length / (4 * m) / 0.125);
      const ref::Exact eta(-(2 * k + 1) * length / (4 * m) / 0.125);
      u += force * ref::un(alpha, young, poisson, 20).to_double() +
           shear * ref::us(alpha, young, poisson, 20).to_double();
      v += force * ref::vn(alpha, eta, young, poisson, 20).to_double() +
           shear * ref::vs(alpha, eta, young, poisson, 20).to_double();
    }
    const double y = i * length / (2 * m);
    CHECK(u == approx(solution.indentation.to_double() - y * y / 12, 1e-12));
    CHECK(std::fabs(v - creep * y) < 1e-12 * std::fabs(creep) * length);
  }
}

TEST_CASE(
    "fast line loads are within their condition of the truth, and the error splits into kernels and "
    "rounding") {
  for (const int m : {2, 10, 40}) {
    for (const double length : {0.01, 0.1, 1.0}) {
      CAPTURE(m);
      CAPTURE(length);
      const auto truth = ref::line_loads_for_length(quarter_inch_nip, m, length, 30);
      const auto computed = fast::line_loads_for_length(quarter_inch_nip, m, length);
      CHECK(relative_error(truth.indentation, computed.indentation) < 1e-16 * truth.condition + 4e-16);
      CHECK(relative_error(truth.load, computed.load) < 1e-16 * truth.condition + 4e-16);

      std::vector<double> kernel;
      for (int q = 0; q < 2 * m; ++q) kernel.push_back(fast::I1((2 * q + 1) * length / (4 * m) / 0.125));
      const auto exact_solve = ref::line_loads_from_kernel_values(quarter_inch_nip, kernel, length, 30);
      const double by_kernels = difference(exact_solve.load, truth.load);
      const double by_rounding = std::fabs(exact_solve.load.error_of(computed.load));
      CHECK(std::fabs(truth.load.error_of(computed.load)) <= 1.01 * (by_kernels + by_rounding));
    }
    const auto truth =
        ref::line_loads_for_length(quarter_inch_nip, m, 0.1, 30, {ref::Grip::Creep::given, 1e-4});
    const auto computed = fast::gripped_line_loads_for_length(quarter_inch_nip, m, 0.1, 1e-4);
    CHECK(relative_error(truth.load, computed.load) < 1e-15 * truth.condition);
  }
}

TEST_CASE("ref line loads refuse bad input by name") {
  using data::BadInput;
  CHECK_THROWS_WITH_AS(ref::line_loads_for_length(quarter_inch_nip, 0, 0.1, 30),
                       doctest::Contains("elements_per_side"), BadInput);
  CHECK_THROWS_WITH_AS(ref::line_loads_for_load(quarter_inch_nip, 2, -1, 30), doctest::Contains("load = -1"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(ref::line_loads_for_length(quarter_inch_nip, {2, 501}, 0.1, 30),
                       doctest::Contains("residue_terms = 501"), data::BadInput);
  CHECK_THROWS_WITH_AS(ref::line_loads_for_length(quarter_inch_nip, 2, -0.1, 30),
                       doctest::Contains("contact_length"), BadInput);
  CHECK_THROWS_WITH_AS(ref::line_loads_for_length(quarter_inch_nip, 2, 0.1, 5), doctest::Contains("digits"),
                       BadInput);
  CHECK_THROWS_WITH_AS(
      ref::line_loads_for_length(quarter_inch_nip, 2, 0.1, 30, {ref::Grip::Creep::given, HUGE_VAL}),
      doctest::Contains("creep"), BadInput);
  const std::array<double, 3> odd{1, 2, 3};
  CHECK_THROWS_WITH_AS(ref::line_loads_from_kernel_values(quarter_inch_nip, odd, 0.1, 30),
                       doctest::Contains("kernel"), BadInput);
  // One value for all distances: every row of the matrix is the same, and no digits make up for that.
  const std::array<double, 4> singular{1, 1, 1, 1};
  CHECK_THROWS_WITH_AS(ref::line_loads_from_kernel_values(quarter_inch_nip, singular, 0.1, 30),
                       doctest::Contains("kernel = 1"), BadInput);
}

TEST_CASE("ref line loads: a given load is carried at a length that is proven, whatever the digits") {
  for (const auto kind : {ref::Grip::Creep::none, ref::Grip::Creep::given, ref::Grip::Creep::thesis}) {
    const ref::Grip grip{kind, kind == ref::Grip::Creep::given ? 1e-4 : 0};
    const auto coarse = ref::line_loads_for_load(quarter_inch_nip, 3, 100, 18, grip);
    const auto fine = ref::line_loads_for_load(quarter_inch_nip, 3, 100, 34, grip);
    CHECK(difference(coarse.contact_length, fine.contact_length) <= error(coarse.contact_length));
    CHECK(difference(coarse.indentation, fine.indentation) <= error(coarse.indentation));
    CHECK(difference(coarse.peak_pressure, fine.peak_pressure) <= error(coarse.peak_pressure));
    CHECK(error(coarse.contact_length) <= 1e-18 * coarse.contact_length.to_double());
    CHECK(std::fabs(fine.load.to_double() - 100) <= 1e-13);
    CHECK(error(fine.load) <= 1e-30);
  }
}

TEST_CASE("ref line loads: the thesis's creep is that in double") {
  for (const double length : {0.05, 0.1, 0.3}) {
    const auto solve = [&] {
      return ref::line_loads_for_length(quarter_inch_nip, 3, length, 20, {ref::Grip::Creep::thesis});
    };
    const auto theirs = fast::thesis_line_loads_for_length(quarter_inch_nip, 3, length);
    REQUIRE(theirs.has_value() == (length < 0.2));
    if (!theirs) {
      CHECK_THROWS_AS(solve(), data::BadInput);
      continue;
    }
    const auto mine = solve();
    CHECK(mine.gripped_creep->to_double() == doctest::Approx(*theirs->gripped_creep).epsilon(1e-9));
    CHECK(mine.load.to_double() == doctest::Approx(theirs->load).epsilon(1e-9));
    CHECK(mine.peak_shear.to_double() == doctest::Approx(theirs->peak_shear).epsilon(1e-9));
  }
}
