#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/line_load_sums.hpp"
#include "support/test.hpp"

using namespace nipref;
using fast::LineLoadNip;
using namespace line_load_tests;

namespace {

const data::ElasticNip nip = data::seed::nip(1.0);

/// Contact length of Hertz's rigid cylinder on a half-space.
double hertz_length(const data::ElasticNip& where, double load) {
  const double modulus = where.material.young / (1 - where.material.poisson * where.material.poisson);
  return 2 * std::sqrt(4 * load * where.roller_radius / (std::numbers::pi * modulus));
}

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

TEST_CASE("on a very thick sheet the contact tends to Hertz's, like ln(m)/m") {
  const data::ElasticNip thick{1.0, 1e4, {1.0, 0.25}};
  const double load = 1e-3;
  const double hertz = hertz_length(thick, load);
  const auto scaled_shortfall = [&](int m) {
    return m * (1 - fast::line_loads_for_load(thick, m, load).contact_length() / hertz);
  };
  // m times the error grows by the same amount at each doubling of m: had Hertz's length been missed by a
  // part in a thousand, it would double instead.
  const double first = scaled_shortfall(80);
  const double second = scaled_shortfall(160);
  const double third = scaled_shortfall(320);
  CHECK(third < 0.8);
  CHECK((third - second) / (second - first) == approx(1, 0.05));
}

TEST_CASE("results scale with the units of length and of stress") {
  const LineLoadNip one = fast::line_loads_for_load(nip, 3, 60.0);
  const data::ElasticNip rescaled{
      25.4 * nip.roller_radius, 25.4, {7 * nip.material.young, nip.material.poisson}};
  const LineLoadNip other = fast::line_loads_for_load(rescaled, 3, 60.0 * 25.4 * 7);
  CHECK(other.contact_length() == approx(25.4 * one.contact_length(), 1e-11));
  CHECK(other.indentation == approx(25.4 * one.indentation, 1e-11));
  CHECK(other.peak_pressure() == approx(7 * one.peak_pressure(), 1e-11));
  CHECK(other.creep_ratio() == approx(one.creep_ratio(), 1e-10));
}

TEST_CASE("the creep is the tangential displacement of the end, relative to the middle of the nip") {
  const LineLoadNip solution = fast::line_loads_for_load(nip, 5, 100.0);
  const double end = solution.contact_length() / 2;
  double centre_line = 0;
  for (const fast::FaceLoad& load : solution.loads)
    centre_line += load.normal * fast::F1(-load.y / nip.half_thickness(), nip.material.poisson);
  CHECK(solution.creep_ratio() == approx(displacement(nip, solution, end).v / end, 1e-12));
  CHECK(std::abs(centre_line) < 1e-12 * solution.load());  // odd terms cancel in a symmetric nip
  // A thick sheet's surface is drawn in (negative), a thin one's squeezed out.
  CHECK(solution.creep_ratio() < 0);
  const data::ElasticNip thin = data::seed::nip(0.005);
  CHECK(fast::line_loads_for_load(thin, 10, 100.0).creep_ratio() > 0);
}

TEST_CASE("coarser kernels change the result by no more than their tolerance times the condition") {
  const double full = fast::line_loads_for_length(nip, 5, 0.1).indentation;
  const double coarse = fast::line_loads_for_length(nip, {5, 0, fast::Accuracy(1e-9)}, 0.1).indentation;
  CHECK(coarse != full);
  CHECK(coarse == approx(full, 1e-7));
}

TEST_CASE("bad input to the contact is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(fast::line_loads_for_length(nip, 0, 0.1),
                       "elements_per_side = 0: must be from 1 to 10000", data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_length(nip, 2, 0.0), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_length(nip, 2, nan), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load(nip, 2, -1.0), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load({0.0, 1.0, nip.material}, 2, 1.0), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load({6.0, nan, nip.material}, 2, 1.0), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load({6.0, 1.0, {1.0, 0.6}}, 2, 1.0), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load({6.0, 1.0, {-1.0, 0.3}}, 2, 1.0), data::BadInput);
}
