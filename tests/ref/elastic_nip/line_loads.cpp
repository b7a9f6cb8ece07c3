// Line loads in multiprecision: bounds, independent routes, and what the double path loses against them.
#include <doctest/doctest.h>

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
    CHECK(u == doctest::Approx(solution.indentation.to_double() - y * y / 12).scale(0).epsilon(1e-12));
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
