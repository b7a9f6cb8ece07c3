#include <nipref/data/scene/file.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/covered.hpp"
#include "support/refusal.hpp"
#include "support/solved_scene.hpp"
#include "support/test.hpp"

using namespace nipref;
using fast::Estimate;

TEST_SUITE_BEGIN("stresses and displacements inside the sheet of a solved contact");

namespace {

data::ElasticNip nip_of(double thickness) { return {6, thickness, {1.45e5, 0.3}}; }

data::Scene inside_example(const char* name, const data::SceneOverrides& overrides) {
  return data::load_scene(data::example_scene(name), overrides);
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
      check_covered(mine, truth);
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
  for (const data::ResultId id :
       {data::ResultId::stress_across, data::ResultId::stress_along, data::ResultId::stress_shear})
    CHECK(rolling.profile(id).size() == 9);
  CHECK(std::fabs(rolling[data::ResultId::greatest_shear_position].value) < 0.1);
  // Leading pressure leads inside too.
  const auto lagging = verify::solve(inside_example("inside-viscoelastic", {}));
  CHECK(lagging[data::ResultId::greatest_shear_position].value >
        rolling[data::ResultId::greatest_shear_position].value);
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
    return refusal_of([&] { return verify::solve(inside_example("inside-full-friction", overrides)); });
  };
  CHECK(contains(says({{"field.depths", "[0, 1.5]"}}), "field.depths[1] = "));
  CHECK(contains(says({{"field.positions", "[]"}}), "field.positions = "));
  CHECK(contains(says({{"method.kind", "line-loads"},
                       {"method.leading_elements", "5"},
                       {"method.trailing_elements", "5"}}),
                 "wanted[2] = "));
  data::Scene far = inside_example("inside-full-friction", {{"field.positions", "[1e4]"}});
  far.wanted = {data::ResultId::stress_across};
  CHECK_THROWS_AS(static_cast<void>(verify::solve_by_ref(far, 16)), data::BadInput);
}

TEST_CASE("the largest shear of a contact with full friction is found where it is, beside an end on a face") {
  for (const double length : {0.0085, 0.05}) {
    const data::ElasticNip nip{6, 1, {1.45e5, -0.13}};
    const auto contact = fast::converged_for_length(nip, data::Friction::full, length, 1e-9);
    const fast::GreatestShear found = contact.greatest_shear();
    std::vector<fast::InnerPoint> near_end;
    for (int k = 2; k < 60; ++k) near_end.push_back({length / 2 * (1 - std::pow(0.8, k)), 1});
    for (const auto& inside : contact.inner_stresses(near_end)) {
      const Estimate here = inside.maximum_shear();
      CHECK(here.value <= found.value.value + found.value.error + here.error);
    }
    const std::vector<fast::InnerPoint> there{{found.y.value, found.depth.value}};
    check_covered(found.value, contact.inner_stresses(there).front().maximum_shear());
  }
}

TEST_CASE("on a face the stress across is the pressure to a few units, wherever panels meet") {
  const data::ElasticNip nip{6, 1, {1.45e5, 0.3}};
  for (const double length : {0.714, 0.854, 8.0 / 3}) {
    const auto contact = fast::converged_for_length(nip, data::Friction::none, length, 1e-13);
    const double peak = contact.peak_pressure().value;
    for (const double part : {0.0, 0.073, 0.26, 0.4999, 0.93}) {
      const double y = part * length / 2;
      const auto inside = contact.inner_stresses(std::vector<fast::InnerPoint>{{y, 1}}).front();
      // A panel's pressure at its end is that of the next one up to its error.
      const Estimate pressure = contact.pressure(y);
      CHECK(std::fabs(inside.across.value + pressure.value) < 5e-15 * peak + pressure.error);
    }
  }
}

TEST_CASE("in the middle of a face, where the shear changes its sign, coarse solutions know their error") {
  for (const double poisson : {0.3, -0.5, 0.0}) {
    CAPTURE(poisson);
    const data::ElasticNip nip{6, 1, {1.45e5, poisson}};
    const std::vector<fast::InnerPoint> middle{{0, 1}, {1e-9, 1}, {0, 1 - 1e-7}};
    const auto solved = [&](double accuracy) {
      return fast::converged_for_length(nip, data::Friction::full, 0.00737, accuracy).inner_stresses(middle);
    };
    const auto truth = solved(1e-12);
    for (const double accuracy : {1e-4, 1e-5, 1e-6, 1e-7}) {
      CAPTURE(accuracy);
      const auto mine = solved(accuracy);
      for (std::size_t i = 0; i < middle.size(); ++i) check_covered(mine[i].along, truth[i].along);
    }
  }
}

TEST_CASE("stresses at many places have errors that cover a contact solved to 1e-13") {
  const auto compared = [](const auto& contact, const auto& truth, double length) {
    std::vector<fast::InnerPoint> points;
    for (int i = -12; i <= 12; ++i) {
      for (int j = 0; j < 26; ++j) points.push_back({length * (i + 0.3) / 18, std::cos(0.125 * j)});
    }
    const auto many = contact.inner_stresses(points), exact = truth.inner_stresses(points);
    const auto compare = [&](Estimate fast::InnerStresses::*part) {
      for (std::size_t k = 0; k < points.size(); ++k) check_covered(many[k].*part, exact[k].*part);
    };
    compare(&fast::InnerStresses::across);
    compare(&fast::InnerStresses::along);
    compare(&fast::InnerStresses::shear);
  };
  const data::ElasticNip nip{600, 1, {1.45e5, 0.3}};
  for (const double length : {0.4, 9.0}) {
    for (const auto friction : {data::Friction::none, data::Friction::full}) {
      compared(fast::converged_for_length(nip, friction, length, 1e-6),
               fast::converged_for_length(nip, friction, length, 1e-13), length);
    }
  }
  const auto scene = inside_example("inside-viscoelastic", {});
  const auto& rolling = std::get<data::ViscoelasticNipProblem>(scene.system).nip;
  compared(fast::converged_for_length(rolling, 1.5, 1e-6), fast::converged_for_length(rolling, 1.5, 1e-13),
           1.5);
}

TEST_CASE(
    "a field is proven only where each of its numbers is: the exact zeros of the shear do not make it so") {
  data::Scene scene = inside_example("inside-thick-frictionless",
                                     {{"field.positions", "[0.035]"}, {"field.depths", "[0, 0.5]"}});
  scene.wanted = {data::ResultId::stress_shear};
  const auto by_ref = verify::solve_by_ref(scene, 16);
  CHECK(by_ref.profile(data::ResultId::stress_shear)[0].proven);
  CHECK(contains(verify::solution_json(by_ref).text(), "\"proven\": false"));
}

TEST_CASE("the reference's largest shear is Hertz's below a thick sheet's contact, and fast's everywhere") {
  data::Scene scene = inside_example("inside-thick-frictionless", {{"sheet.thickness", "1e6"}});
  scene.wanted = {data::ResultId::contact_length, data::ResultId::peak_pressure,
                  data::ResultId::greatest_shear, data::ResultId::greatest_shear_position,
                  data::ResultId::greatest_shear_depth};
  const auto by_ref = by_both_paths(scene).ref;
  const auto value = [&](data::ResultId id) { return std::stold(by_ref[id].value_text()); };
  // tau = d (1 - d/sqrt(1 + d^2)) p0 below the middle: 0.30028 p0 at 0.78615 half widths.
  const long double root = std::sqrt((std::sqrt(5.0L) - 1) / 2);
  const long double largest = root * (1 - root / std::sqrt(1 + root * root));
  CHECK(static_cast<double>(value(data::ResultId::greatest_shear) / value(data::ResultId::peak_pressure)) ==
        doctest::Approx(static_cast<double>(largest)).epsilon(1e-6));
  CHECK(static_cast<double>((1 - value(data::ResultId::greatest_shear_depth)) * 1e6L /
                            value(data::ResultId::contact_length)) ==
        doctest::Approx(static_cast<double>(root)).epsilon(1e-6));
  CHECK(by_ref[data::ResultId::greatest_shear_position].value_text() == "0");
}

TEST_CASE("both paths have the same displacements inside, on the faces the surface's") {
  for (const char* const friction : {"none", "full"}) {
    for (const char* const thickness : {"0.04", "0.25", "5"}) {
      CAPTURE(friction);
      CAPTURE(thickness);
      data::Scene scene =
          inside_example("inside-displacements", {{"friction.model", friction},
                                                  {"sheet.thickness", thickness},
                                                  {"accuracy", "1e-6"},
                                                  {"field.positions", "[0, 0.067, -0.2]"},
                                                  {"field.depths", "[0, 0.5, -0.99999, 1, -1]"}});
      scene.wanted = {data::ResultId::displacement_across, data::ResultId::displacement_along,
                      data::ResultId::normal_displacement, data::ResultId::tangential_displacement};
      problem_of(scene).profile = data::Positions{{0, 0.067, -0.2}};
      const auto [fast, by_ref] = by_both_paths(scene);
      for (const auto& [inside, surface] :
           {std::pair{data::ResultId::displacement_across, data::ResultId::normal_displacement},
            std::pair{data::ResultId::displacement_along, data::ResultId::tangential_displacement}}) {
        for (std::size_t i = 0; i < 3; ++i) {
          for (const std::size_t face : {9u, 12u}) {
            CHECK(fast.profile(inside)[face + i].value == fast.profile(surface)[i].value);
            // The reference integrates the field to the face, and by other kernels the surface.
            const auto &here = by_ref.profile(inside)[face + i], &there = by_ref.profile(surface)[i];
            CHECK(std::fabs((here - there).to_double()) <= std::stod((here - there).error_text()));
          }
        }
      }
    }
  }
}

TEST_CASE("differences of displacements are the strains of the stresses, next to faces and ends too") {
  const data::ElasticNip nip{60, 1, {1.45e5, 0.37}};
  const double theta1 = nip.material.theta1(), theta2 = nip.material.theta2(), b = nip.half_thickness();
  for (const data::Friction friction : {data::Friction::none, data::Friction::full}) {
    for (const double length : {0.03, 0.6, 4.0}) {
      const auto contact = fast::converged_for_length(nip, friction, length, 1e-12);
      const double step = length * 1e-4, strain = contact.peak_pressure().value * theta1;
      for (const double y : {0.0, 0.3 * length, 0.49 * length, -0.7 * length}) {
        for (const double inwards : {0.02, 0.3}) {
          CAPTURE(length);
          CAPTURE(y);
          const double depth = 1 - inwards * std::min(length, 1.0), across = step / b;
          const auto there = contact.inner_displacements(std::vector<fast::InnerPoint>{
              {y + step, depth}, {y - step, depth}, {y, depth + across}, {y, depth - across}});
          const auto stress = contact.inner_stresses(std::vector<fast::InnerPoint>{{y, depth}}).front();
          const double by_y = (there[0].along.value - there[1].along.value) / (2 * step),
                       by_x = -(there[2].across.value - there[3].across.value) / (2 * step),
                       turned = (there[2].along.value - there[3].along.value -
                                 (there[0].across.value - there[1].across.value)) /
                                (2 * step);
          const double mean = (theta1 - theta2) / 2 * (stress.across.value + stress.along.value);
          const double enough = 1e-4 * strain;
          CHECK(std::fabs(by_x - (theta1 * stress.across.value - mean)) < enough);
          CHECK(std::fabs(by_y - (theta1 * stress.along.value - mean)) < enough);
          CHECK(std::fabs(turned - 2 * theta1 * stress.shear.value) < enough);
        }
      }
    }
  }
}

TEST_CASE(
    "line loads have the sum of their fields by both paths, and no displacements where these are not known") {
  for (const char* const friction : {"none", "full"}) {
    data::Scene scene = inside_example("inside-line-loads", {{"friction.model", friction},
                                                             {"accuracy", "1e-13"},
                                                             {"field.positions", "[0, 0.043, -0.3]"},
                                                             {"field.depths", "[0, 0.5, -0.97, 1]"}});
    const auto fast = verify::solve(scene);
    const auto by_ref = verify::solve_by_ref(scene, 16);
    for (std::size_t r = 1; r < scene.wanted.size(); ++r) {
      const data::ResultId result = scene.wanted[r];
      CAPTURE(data::scene_result(result).name);
      const auto values = fast.profile(result);
      double size = 0;
      for (const Estimate& value : values) size = std::max(size, std::fabs(value.value));
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double truth = by_ref.profile(result)[i].to_double();
        CHECK(std::fabs(values[i].value - truth) < 1e-11 * size);
        if (values[i].value != 0) CHECK(values[i].error > 0);
      }
    }
    // On the faces the displacements are the surface's.
    scene.wanted = {data::ResultId::displacement_along, data::ResultId::tangential_displacement};
    problem_of(scene).profile = data::Positions{{0, 0.043, -0.3}};
    const auto surface = verify::solve(scene);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(surface.profile(scene.wanted[0])[9 + i].value ==
            doctest::Approx(surface.profile(scene.wanted[1])[i].value).epsilon(1e-11));
  }
  const auto refused = [](const char* name, const data::SceneOverrides& overrides) {
    return refusal_of([&] { return verify::solve(inside_example(name, overrides)); });
  };
  CHECK(contains(refused("inside-line-loads", {{"method.residue_terms", "20"}}), "residue_terms"));
  CHECK(refused("inside-line-loads", {{"load.per_length", "100"}, {"field.depths", "[1]"}}) == "accepted");
  data::SceneOverrides at_load{{"field.depths", "[0, 1]"}, {"field.positions", "[0.0]"}};
  at_load.emplace_back("wanted", "[\"displacement_across\"]");
  CHECK(contains(refused("inside-viscoelastic", at_load), "remembers its own strains"));
}

TEST_SUITE_END();
