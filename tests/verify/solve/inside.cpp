#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <nipref/data/scene/file.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/solved_scene.hpp"

using namespace nipref;
using fast::Estimate;

TEST_SUITE_BEGIN("stresses inside the sheet of a solved contact");

namespace {

data::ElasticNip nip_of(double thickness) { return {6, thickness, {1.45e5, 0.3}}; }

data::Scene inside_example(const char* name, const data::SceneOverrides& overrides) {
  return data::load_scene(data::example_scene(name), overrides);
}

bool covered(const Estimate& mine, const Estimate& truth) {
  return std::fabs(mine.value - truth.value) <= mine.error + truth.error;
}

}  // namespace

TEST_CASE("a thick sheet's largest shear is Hertz's line contact's: 0.300 p0 at 0.786 half widths") {
  const auto nip = nip_of(1000);
  const auto contact = fast::converged_for_length(nip, data::Friction::none, 1e-4, 1e-10);
  const fast::GreatestShear found = contact.greatest_shear();
  const double below = (1 - found.depth.value) * 500 / 5e-5;
  MESSAGE("largest shear ", found.value.value / contact.peak_pressure().value, " p0 at ", below,
          " half widths");
  CHECK(found.value.value / contact.peak_pressure().value == doctest::Approx(0.30028).epsilon(2e-5));
  CHECK(below == doctest::Approx(0.78615).epsilon(1e-3));
  CHECK(std::fabs(found.y.value) < 1e-4);
}

TEST_CASE("in a thin sheet without friction the stress across is the pressure through the thickness") {
  const auto nip = nip_of(0.01);
  const auto contact = fast::converged_for_length(nip, data::Friction::none, 0.4, 1e-9);
  for (const double y : {0.0, 0.05, -0.1}) {
    const double pressure = contact.pressure(y).value;
    double worst = 0;
    for (const double depth : {-0.9, 0.0, 0.5}) {
      const auto inside = contact.inner_stresses(std::vector<fast::InnerPoint>{{y, depth}}).front();
      CHECK(inside.across.value == doctest::Approx(-pressure).epsilon(1e-11));
      worst = std::max(worst, std::fabs(inside.across.value / pressure + 1));
    }
    MESSAGE("L/B = 40, Y = ", y, ": sigma_x + p is ", worst, " of p");
  }
}

TEST_CASE("errors of the field cover a contact solved to 1e-13, on the faces too") {
  for (const char* const friction : {"none", "full"}) {
    for (const char* const thickness : {"0.05", "0.25", "5"}) {
      CAPTURE(friction);
      CAPTURE(thickness);
      data::SceneOverrides overrides{{"friction.model", friction},
                                     {"sheet.thickness", thickness},
                                     {"accuracy", "1e-7"},
                                     {"field.depths", "[0, 0.5, 0.9, 0.99, 1]"},
                                     {"field.positions", "[0, 0.03, 0.1, -0.2]"}};
      const auto mine = verify::solve(inside_example("inside-full-friction", overrides));
      overrides[2].second = "1e-13";
      const auto truth = verify::solve(inside_example("inside-full-friction", overrides));
      for (std::size_t r = 0; r < mine.results.size(); ++r) {
        CAPTURE(mine.results[r].what->name);
        for (std::size_t i = 0; i < mine.results[r].numbers.size(); ++i) {
          CAPTURE(i);
          CHECK(covered(mine.results[r].numbers[i], truth.results[r].numbers[i]));
        }
      }
    }
  }
}

TEST_CASE(
    "a viscoelastic sheet that rolls has the field of its pressure, an elastic one's in the elastic limit") {
  const data::SceneOverrides elastic_solid{{"material.relaxation_time", "1e6"},
                                           {"field.positions", "[0, 0.1, 0.3]"},
                                           {"field.depths", "[0, 0.6, -0.9]"}};
  const auto rolling = verify::solve(inside_example("inside-viscoelastic", elastic_solid));
  // Slower than it moves the solid answers with its instantaneous moduli: shear 5.4375e4, bulk 1.45e5.
  const auto problem =
      std::get<data::ViscoelasticNipProblem>(inside_example("inside-viscoelastic", {}).system);
  for (const char* const name : {"stress_across", "stress_along", "stress_shear"})
    CHECK(rolling.profile(name).size() == 9);
  CHECK(std::fabs(rolling["greatest_shear_position"].value) < 0.1);
  // Leading pressure leads inside too.
  const auto lagging = verify::solve(inside_example("inside-viscoelastic", {}));
  CHECK(lagging["greatest_shear_position"].value > rolling["greatest_shear_position"].value);
  // Across the middle plane the load is carried.
  const auto contact = fast::converged_for_load(problem.nip, 100, 1e-9);
  double carried = 0;
  constexpr double step = 1.0 / 128;
  std::vector<fast::InnerPoint> line;
  for (int i = -256; i <= 256; ++i) line.push_back({i * step, 0.2});
  for (const auto& inside : contact.inner_stresses(line)) carried += inside.across.value * step;
  CHECK(carried == doctest::Approx(-100).epsilon(1e-6));
}

TEST_CASE("scenes refuse what has no stresses inside the sheet") {
  const auto says = [](const data::SceneOverrides& overrides) {
    try {
      static_cast<void>(verify::solve(inside_example("inside-full-friction", overrides)));
    } catch (const data::BadInput& error) {
      return std::string(error.argument());
    }
    return std::string();
  };
  CHECK(says({{"field.depths", "[0, 1.5]"}}).ends_with("field.depths[1]"));
  CHECK(says({{"field.positions", "[]"}}).ends_with("field.positions"));
  CHECK(says({{"method.kind", "line-loads"},
              {"method.leading_elements", "5"},
              {"method.trailing_elements", "5"}})
            .ends_with("wanted[2]"));
  CHECK_THROWS_AS(static_cast<void>(verify::solve_by_ref(inside_example("inside-full-friction", {}), 20)),
                  data::BadInput);
}

TEST_SUITE_END();
