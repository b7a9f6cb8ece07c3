// The thesis's own way through the viscoelastic nip: its plain sums against exact displacements, its line
// loads against the elastic ones, its search for m2.
#include <optional>
#include <tuple>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

#include "support/softening_sheet.hpp"
#include "support/test.hpp"

using namespace nipref;
using namespace nipref::test;
using data::ViscoelasticLineLoads;
using data::ViscoelasticMaterial;
using data::ViscoelasticNip;
using fast::LineLoadNip;

namespace {

/// Started so long before the nip that the start is forgotten.
ViscoelasticLineLoads method(int leading, std::optional<int> trailing, int terms = 500) {
  return {leading, trailing, 30, terms};
}

LineLoadNip for_length(double relaxation_length, const ViscoelasticLineLoads& how, double length) {
  return fast::line_loads_for_length(nip(relaxation_length), how, length);
}

void check_close(double found, double truth, double relative) { CHECK(found == approx(truth, relative)); }

}  // namespace

TEST_CASE("plain sums: before the load they are exact, after it their rest falls like 0.2/N of the kernel") {
  const double speed = 3, half = 0.5, unit = half / speed;
  const ViscoelasticMaterial material = solid(2 * unit);
  const fast::MovingLoad exact(material, speed, half);
  const auto error = [&](int terms, double t, double T) {
    const fast::PlainMovingLoad plain(material, speed, half, terms);
    return (plain.normal_displacement(t, T) - exact.normal_displacement(t * unit, T * unit)) /
           (material.functions()->normal_compliance().terms[0].amplitude.real() * unit / std::acos(-1.0));
  };
  CHECK(std::fabs(error(500, 1, 2)) < 1e-13);
  CHECK(std::fabs(error(500, 2, -1)) < 1e-13);  // passed before it started
  const double t = 2.5, T = 1;
  CHECK(std::fabs(error(500, t, T)) == doctest::Approx(0.2 / 500 * std::exp(-(t - T) / 2)).epsilon(0.05));
  check_close(error(100, t, T) / error(200, t, T), 2, 0.05);
  check_close(error(200, t, T) / error(400, t, T), 2, 0.05);
}

TEST_CASE("plain sums of the tangential displacement agree with the exact one as far as they go") {
  const ViscoelasticMaterial material = solid(2);
  const fast::MovingLoad exact(material, 1, 1);
  const fast::PlainMovingLoad plain(material, 1, 1, 500);
  const double scale = material.functions()->theta1.long_time();
  for (const auto& [t, T, t0] :
       {std::tuple(1.0, 2.0, 1.5), std::tuple(2.0, 1.0, 1.5), std::tuple(2.0, 1.0, 2.5),
        std::tuple(1.5, -0.5, 2.0), std::tuple(0.5, -1.0, -1.5)}) {
    CAPTURE(t);
    CAPTURE(T);
    CAPTURE(t0);
    CHECK(std::fabs(plain.tangential_displacement(t, T, t0) - exact.tangential_displacement(t, T, t0)) <
          1e-3 * scale);
  }
}

TEST_CASE("fast and slow relaxation give the elastic line loads") {
  const double length = 0.08;
  for (const int terms : {0, 500}) {
    CAPTURE(terms);
    for (const auto& [relaxation_length, compliance] : {std::pair(1e7, 1.0), std::pair(1e-7, 2.0)}) {
      CAPTURE(relaxation_length);
      const LineLoadNip found = for_length(relaxation_length, method(5, 5, terms), length);
      const auto truth = fast::line_loads_for_length(elastic(compliance), {5, terms}, 2 * length);
      // After 500 terms what is quickly relaxed still lacks up to 0.2/500 of the kernel.
      const double accuracy = terms > 0 && relaxation_length < 1 ? 3e-3 : 1e-5;
      check_close(found.load(), truth.load(), accuracy);
      check_close(found.indentation, truth.indentation, accuracy);
      check_close(found.leading_displacement(), truth.leading_displacement(), accuracy);
      check_close(found.trailing_displacement(), truth.leading_displacement(), accuracy);
      check_close(found.peak_pressure(), truth.peak_pressure(), accuracy);
      CHECK(std::fabs(found.rolling_resistance()) < accuracy * length / radius);
    }
    const LineLoadNip slow = for_length(1e7, method(5, 5, terms), length);
    check_close(slow.creep_ratio(),
                fast::line_loads_for_length(elastic(1), {5, terms}, 2 * length).creep_ratio(), 1e-5);
  }
}

TEST_CASE("with enough residues line loads are those of exact displacements") {
  const LineLoadNip plain = for_length(0.1, method(5, 4), 0.08);
  const LineLoadNip exact = for_length(0.1, method(5, 4, 0), 0.08);
  CHECK(plain.load() != exact.load());
  check_close(plain.load(), exact.load(), 2e-3);
  check_close(plain.indentation, exact.indentation, 2e-3);
  check_close(plain.peak_pressure(), exact.peak_pressure(), 5e-3);
  check_close(plain.creep_ratio(), exact.creep_ratio(), 2e-2);
}

TEST_CASE("the contact is linear: a stiffer sheet carries as much more at the same lengths") {
  const auto stiffer = [](data::MaterialFunction function) {
    function.instantaneous /= 7;
    for (auto& term : function.terms) term.amplitude /= 7;
    return function;
  };
  ViscoelasticNip stiff = nip(0.1);
  stiff.material = {stiffer(stiff.material.functions()->theta1), stiffer(stiff.material.functions()->theta2)};
  const LineLoadNip soft = for_length(0.1, method(4, 3), 0.05);
  const LineLoadNip hard = fast::line_loads_for_length(stiff, method(4, 3), 0.05);
  check_close(hard.load(), 7 * soft.load(), 1e-12);
  check_close(hard.indentation, soft.indentation, 1e-12);
  check_close(hard.rolling_resistance(), soft.rolling_resistance(), 1e-11);
  check_close(hard.creep_ratio(), soft.creep_ratio(), 1e-11);
}

TEST_CASE("what the loads leave: the roller's shape at every matching point, and the moment (7.15)") {
  ViscoelasticNip rolling = nip(0.1);
  rolling.speed = 3;
  const ViscoelasticLineLoads how = method(4, 3, 0);
  const LineLoadNip found = fast::line_loads_for_length(rolling, how, 0.06);
  const double half = rolling.half_thickness(), element = found.element_width() / 2;
  CHECK(found.loads.size() == 7);
  check_close(found.trailing_length(), 0.06 * 3 / 4, 1e-14);
  const fast::MovingLoad sheet(rolling.material, rolling.speed, half);
  const double start = how.approach_lengths * half;
  double moment = 0;
  for (int i = 0; i <= 7; ++i) {
    double u = 0;
    for (int j = 0; j < 7; ++j)
      u += found.loads[static_cast<std::size_t>(j)].normal *
           sheet.normal_displacement((start + 2 * i * element) / rolling.speed,
                                     (start + (2 * j + 1) * element) / rolling.speed);
    const double y = 0.06 - 2 * i * element;
    check_close(u, found.indentation - y * y / (2 * radius), 1e-10);
    if (i < 7) moment += found.loads[static_cast<std::size_t>(i)].normal * (y - element);
  }
  check_close(found.rolling_resistance(), moment / (found.load() * radius), 1e-12);
  CHECK(found.rolling_resistance() > 0);
}

TEST_CASE("the surface has the roller's shape where it was matched, and the creep between its ends") {
  for (const int terms : {0, 300}) {
    CAPTURE(terms);
    const LineLoadNip found = for_length(0.1, method(4, 3, terms), 0.06);
    for (int i = 0; i <= 7; ++i) {
      const double y = found.leading_length - i * found.element_width();
      check_close(found.normal_displacement(y), found.indentation - y * y / (2 * radius), 1e-10);
    }
    CHECK(found.tangential_displacement(0) == 0);
    const double stretch = found.tangential_displacement(found.leading_length) -
                           found.tangential_displacement(-found.trailing_length());
    check_close(stretch / found.contact_length(), found.creep_ratio(), 1e-10);
  }
}

TEST_CASE("the load found is the load asked for") {
  check_close(fast::line_loads_for_load(nip(0.1), method(5, 4), load).load(), load, 1e-9);
  // As much as no length below the roller's radius carries.
  ViscoelasticNip small = nip(0.1);
  small.roller_radius = 0.2;
  CHECK_THROWS_AS(fast::line_loads_for_load(small, method(2, 2, 0), 1e12), data::BadInput);
}

TEST_CASE("the search for m2: the first from m1 down that leaves no tension") {
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
  check_close(found.leading_length, at(0.1, trailing).leading_length, 1e-9);
}

TEST_CASE("line loads refuse what is outside their domain") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](const ViscoelasticLineLoads& how, double length) {
    CHECK_THROWS_AS(for_length(0.1, how, length), data::BadInput);
  };
  refuses({0, 1, 5, 500}, 0.1);
  refuses({501, 1, 5, 500}, 0.1);
  refuses({2, -1, 5, 500}, 0.1);
  refuses({2, 2, 0, 500}, 0.1);
  refuses({2, 2, nan, 500}, 0.1);
  refuses({2, 2, 5, 501}, 0.1);
  refuses({2, 2, 5, -1}, 0.1);
  refuses(method(2, 2), 0);
  refuses(method(2, 2), nan);
  refuses(method(2, 2), 7);
  const LineLoadNip found = for_length(0.1, method(4, 3, 0), 0.06);
  CHECK_THROWS_AS((void)found.normal_displacement(found.loads[0].y), data::BadInput);
  CHECK_THROWS_AS((void)found.normal_displacement(0.06 + 31 * thickness / 2), data::BadInput);
  CHECK_THROWS_AS((void)found.pressure(HUGE_VAL), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load(nip(0.1), method(2, 2), -1), data::BadInput);
  CHECK_THROWS_AS(fast::line_loads_for_load(nip(0.1), method(2, {}), 0), data::BadInput);
  CHECK_THROWS_AS(fast::PlainMovingLoad(solid(1), 1, 1, 0), data::BadInput);
  CHECK_THROWS_AS(fast::PlainMovingLoad(solid(1), 0, 1, 10), data::BadInput);
  CHECK_THROWS_AS(fast::PlainMovingLoad(solid(1), 1, nan, 10), data::BadInput);
}
