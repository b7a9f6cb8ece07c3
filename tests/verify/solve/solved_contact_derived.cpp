// Results of a nip that follow from others: eccentricity, resistance, lost power, moments of the pressure.
#include <nipref/ref/number/enclosure.hpp>

#include "support/solved_scene.hpp"
#include "support/stated_contact.hpp"

using namespace nipref;

namespace {

data::Scene resisting(const char* name) {
  using enum data::ResultId;
  data::Scene scene = loaded_example(name);
  scene.wanted = {load,           rolling_resistance, eccentricity,   resistance_force, power_loss,
                  leading_moment, trailing_moment,    leading_length, trailing_length};
  return scene;
}

/// Checks that two numbers agree within this error.
void check_agree(double value, double error, double other) {
  CHECK(std::fabs(value - other) <= error + 1e-15 * std::fabs(other));
}

}  // namespace

TEST_CASE("eccentricity, resistance and lost power follow from the coefficient, radius, load and speed") {
  const data::Scene scene = resisting("viscoelastic-comparable-memory");
  const auto& nip = std::get<data::ViscoelasticNipProblem>(scene.system).nip;
  const auto solution = verify::solve(scene);
  const double resistance = solution["rolling_resistance"].value, load = solution["load"].value;
  CHECK(solution["eccentricity"].value == approx(nip.roller_radius * resistance, 1e-15));
  CHECK(solution["resistance_force"].value == approx(load * resistance, 1e-15));
  CHECK(solution["power_loss"].value == approx(nip.speed * load * resistance, 1e-15));
  CHECK(solution["power_loss"].value > 0);
}

TEST_CASE("the moments of both sides are that of the eccentric load, of line loads too") {
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
    // For line loads (7.14) holds exactly.
    if (contains(std::string(name), "line"))
      CHECK(ahead.value + behind.value == approx(load.value * off.value, 1e-12));
    CHECK(ahead.value < load.value * solution["leading_length"].value);
    if (!contains(std::string(name), "line")) CHECK(error < 1e-6 * ahead.value);
  }
}

TEST_CASE("an elastic nip has equal moments and loses nothing") {
  const auto solution = verify::solve(resisting("thick-frictionless"));
  const fast::Estimate ahead = solution["leading_moment"], behind = solution["trailing_moment"];
  check_agree(ahead.value, ahead.error + behind.error, -behind.value);
  for (const char* none : {"eccentricity", "power_loss"}) CHECK(solution[none].value == 0);
}

TEST_CASE("nothing slips where it sticks") {
  data::Scene scene = loaded_example("intermediate-full-friction", {{"wanted", R"(["slip"])"}});
  problem_of(scene).profile = data::EvenlySpaced{9};
  const auto gripped = verify::solve(scene);
  const auto& none = gripped.profile("slip");
  for (std::size_t i = 0; i + 1 < none.size(); ++i) {
    CHECK(none[i].value == 0);
    CHECK(none[i].error == 0);
  }
  // The end of the contact is not known exactly, and beyond the end the strain is not the creep.
  CHECK(std::fabs(none.back().value) <= none.back().error);
}

TEST_CASE("the reference computes the strain of a place once, for itself and for the slip") {
  StatedContact<ref::Estimate> contact;
  int strains = 0;
  contact.numbers[data::ResultId::surface_strain] = [&](double) {
    ++strains;
    return ref::exactly(-0.5, 16);
  };
  contact.numbers[data::ResultId::creep_ratio] = [](double) { return ref::exactly(0.25, 16); };
  for (const double y : {0.25, 0.5}) {
    CHECK(std::stod(contact.at(data::ResultId::surface_strain, y).value_text()) == -0.5);
    CHECK(std::stod(contact.at(data::ResultId::slip, y).value_text()) == -0.75);
  }
  CHECK(strains == 2);
}
