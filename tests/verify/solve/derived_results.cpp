// What follows from the results of a nip: eccentricity, resistance, lost power, moments of the pressure.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/verify/solve/solve.hpp>

using namespace nipref;

namespace {

data::Scene resisting(const char* name) {
  data::Scene scene = data::load_scene(data::example_scene(name));
  scene.wanted = {"load",           "rolling_resistance", "eccentricity",   "resistance_force", "power_loss",
                  "leading_moment", "trailing_moment",    "leading_length", "trailing_length"};
  return scene;
}

/// Both say so with their errors.
void check_agree(double value, double error, double other) {
  CHECK(std::fabs(value - other) <= error + 1e-15 * std::fabs(other));
}

}  // namespace

TEST_CASE(
    "eccentricity, resistance and lost power are what the coefficient of resistance makes of radius, load, speed") {
  const data::Scene scene = resisting("viscoelastic-comparable-memory");
  const auto& nip = std::get<data::ViscoelasticNipProblem>(scene.system).nip;
  const auto solution = verify::solve(scene);
  const double resistance = solution["rolling_resistance"].value, load = solution["load"].value;
  CHECK(solution["eccentricity"].value ==
        doctest::Approx(nip.roller_radius * resistance).scale(0).epsilon(1e-15));
  CHECK(solution["resistance_force"].value == doctest::Approx(load * resistance).scale(0).epsilon(1e-15));
  CHECK(solution["power_loss"].value ==
        doctest::Approx(nip.speed * load * resistance).scale(0).epsilon(1e-15));
  CHECK(solution["power_loss"].value > 0);
}

TEST_CASE(
    "the moments of both sides are that of the eccentric load, of line loads as of the continuous contact") {
  for (const char* name : {"viscoelastic-comparable-memory", "viscoelastic-short-memory",
                           "viscoelastic-long-memory", "viscoelastic-thesis-line-loads"}) {
    CAPTURE(name);
    const auto solution = verify::solve(resisting(name));
    const fast::Estimate ahead = solution["leading_moment"], behind = solution["trailing_moment"];
    const fast::Estimate load = solution["load"], off = solution["eccentricity"];
    CHECK(ahead.value > 0);
    CHECK(behind.value < 0);
    const double error = ahead.error + behind.error + load.value * off.error + off.value * load.error;
    check_agree(ahead.value + behind.value, error, load.value * off.value);
    // (7.14) holds of line loads by themselves.
    if (std::string(name).find("line") != std::string::npos)
      CHECK(ahead.value + behind.value == doctest::Approx(load.value * off.value).scale(0).epsilon(1e-12));
    CHECK(ahead.value < load.value * solution["leading_length"].value);
    if (std::string(name).find("line") == std::string::npos) CHECK(error < 1e-6 * ahead.value);
  }
}

TEST_CASE("an elastic nip has equal moments and loses nothing") {
  const auto solution = verify::solve(resisting("thick-frictionless"));
  const fast::Estimate ahead = solution["leading_moment"], behind = solution["trailing_moment"];
  check_agree(ahead.value, ahead.error + behind.error, -behind.value);
  CHECK(solution["eccentricity"].value == 0);
  CHECK(solution["power_loss"].value == 0);
  // Hertz's line contact, nearly: 4 a W/(3 pi) on both sides together.
  const double hertz = 2 * solution["leading_length"].value * solution["load"].value / (3 * std::acos(-1.));
  CHECK(ahead.value == doctest::Approx(hertz).scale(0).epsilon(0.05));
}

TEST_CASE("the reference has the moments of rolling line loads, whose sum is the eccentric load") {
  const data::Scene scene = resisting("viscoelastic-started");
  const auto by_ref = verify::solve_by_ref(scene, 16);
  const auto value = [&](const char* name) { return std::stold(by_ref[name].value); };
  CHECK(value("leading_moment") > 0);
  CHECK(value("trailing_moment") < 0);
  const long double both = value("leading_moment") + value("trailing_moment");
  CHECK(std::fabs(both - value("eccentricity") * value("load")) < 1e-15L * value("leading_moment"));
  for (const char* const name : {"leading_moment", "trailing_moment"})
    CHECK(std::stod(by_ref[name].error) < 1e-15 * static_cast<double>(value("leading_moment")));
}

TEST_CASE(
    "the reference has the products, to its digits, and says that it has no moments of the continuous contact") {
  data::Scene scene = resisting("viscoelastic-comparable-memory");
  CHECK_THROWS_WITH_AS((void)verify::solve_by_ref(scene, 16),
                       doctest::Contains("leading_moment: must be wanted of the fast"), data::BadInput);
  const auto fast = verify::solve(scene);
  scene.wanted = {"eccentricity", "resistance_force", "power_loss"};
  const auto by_ref = verify::solve_by_ref(scene, 16);
  for (const std::string& name : scene.wanted) {
    CAPTURE(name);
    check_agree(fast[name].value, fast[name].error + std::stod(by_ref[name].error),
                std::stod(by_ref[name].value));
    CHECK(std::stod(by_ref[name].error) < 1e-13 * std::fabs(std::stod(by_ref[name].value)));
    CHECK_FALSE(by_ref[name].proven);
  }
}
