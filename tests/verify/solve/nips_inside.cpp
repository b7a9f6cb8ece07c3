#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>

#include "support/covered.hpp"
#include "support/solved_scene.hpp"

using namespace nipref;
using fast::Estimate;

TEST_CASE("a rolling sheet's stresses carry the load, the largest shear ahead unless the memory is long") {
  const auto scene_with = [](const data::SceneOverrides& overrides) {
    return loaded_example("inside-viscoelastic", overrides);
  };
  const auto place_of_largest = [&](const data::SceneOverrides& overrides) {
    return verify::solve(scene_with(overrides))[data::ResultId::greatest_shear_position].value;
  };
  // If the memory is much slower than the motion, the solid responds with its instantaneous moduli.
  const double with_long_memory = place_of_largest({{"material.relaxation_time", "1e6"}});
  CHECK(std::fabs(with_long_memory) < 0.1);
  CHECK(place_of_largest({}) > with_long_memory);
  const auto nip = std::get<data::ViscoelasticNipProblem>(scene_with({}).system).nip;
  const auto contact = fast::converged_for_load(nip, 100, 1e-9);
  double carried = 0;
  constexpr double step = 1.0 / 128;
  std::vector<fast::InnerPoint> line;
  for (int i = -256; i <= 256; ++i) line.push_back({i * step, 0.2});
  for (const auto& inside : contact.inner_stresses(line)) carried += inside.across.value * step;
  CHECK(carried == doctest::Approx(-100).epsilon(1e-6));
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
      // Where two panels meet, their pressures differ by up to their errors.
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
  const auto scene = loaded_example("inside-viscoelastic", {});
  const auto& rolling = std::get<data::ViscoelasticNipProblem>(scene.system).nip;
  compared(fast::converged_for_length(rolling, 1.5, 1e-6), fast::converged_for_length(rolling, 1.5, 1e-13),
           1.5);
}

TEST_CASE("the reference's largest shear is Hertz's below a thick sheet's contact, and fast's everywhere") {
  using enum data::ResultId;
  data::Scene scene = loaded_example("inside-thick-frictionless", {{"sheet.thickness", "1e6"}});
  scene.wanted = {contact_length, peak_pressure, greatest_shear, greatest_shear_position,
                  greatest_shear_depth};
  const auto by_ref = by_both_paths(scene).ref;
  const auto value = [&](data::ResultId id) { return std::stold(by_ref[id].value_text()); };
  // tau = d (1 - d/sqrt(1 + d^2)) p0 below the middle: 0.30028 p0 at 0.78615 half widths.
  const long double root = std::sqrt((std::sqrt(5.0L) - 1) / 2);
  const long double largest = root * (1 - root / std::sqrt(1 + root * root));
  CHECK(static_cast<double>(value(greatest_shear) / value(peak_pressure)) ==
        doctest::Approx(static_cast<double>(largest)).epsilon(1e-6));
  CHECK(static_cast<double>((1 - value(greatest_shear_depth)) * 1e6L / value(contact_length)) ==
        doctest::Approx(static_cast<double>(root)).epsilon(1e-6));
  CHECK(by_ref[greatest_shear_position].value_text() == "0");
}

TEST_CASE("both paths have the same displacements inside, on the faces the surface's") {
  using enum data::ResultId;
  std::vector<std::pair<const char*, const char*>> sheets{{"none", "0.04"}, {"full", "5"}};
  if (is_thorough()) sheets.insert(sheets.end(), {{"full", "0.04"}, {"none", "5"}});
  for (const auto& [friction, thickness] : sheets) {
    CAPTURE(friction, thickness);
    data::Scene scene = loaded_example("inside-displacements", {{"friction.model", friction},
                                                                {"sheet.thickness", thickness},
                                                                {"accuracy", "1e-6"},
                                                                {"field.positions", "[0.067, -0.2]"},
                                                                {"field.depths", "[0, -0.99999, 1, -1]"}});
    scene.wanted = {displacement_across, displacement_along, normal_displacement, tangential_displacement};
    problem_of(scene).profile = data::Positions{{0.067, -0.2}};
    const auto [fast, by_ref] = by_both_paths(scene);
    for (const auto& [inside, surface] : {std::pair{displacement_across, normal_displacement},
                                          std::pair{displacement_along, tangential_displacement}}) {
      for (std::size_t i = 0; i < 2; ++i) {
        for (const std::size_t face : {4u, 6u}) {
          CHECK(fast.profile(inside)[face + i].value == fast.profile(surface)[i].value);
          // The reference computes the field up to the face, but the surface by other kernels.
          const auto &here = by_ref.profile(inside)[face + i], &there = by_ref.profile(surface)[i];
          CHECK(std::fabs((here - there).to_double()) <= std::stod((here - there).error_text()));
        }
      }
    }
  }
}
