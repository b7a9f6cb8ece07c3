// Scenes of bodies on half-spaces: their results by either path.
#include <fmt/format.h>

#include "support/reference_values.hpp"
#include "support/solved_scene.hpp"

using namespace nipref;

namespace {

const std::string isotropic_text =
    "[half_space]\nmodel = \"isotropic\"\nshear = 3.0\npoisson = 0.25\ndensity = 2.0\n";
const std::string graphite_epoxy =
    "[half_space]\nmodel = \"transversely-isotropic\"\naxis = \"in-plane\"\nc11 = 13.9e9\nc33 = 160.7e9\n"
    "c13 = 6.44e9\nc44 = 7.07e9\nc66 = 3.5e9\ndensity = 1688.0\n";
const std::string die_text = "[die]\nradius_along = 1.0\nradius_across = 1.0\n";
const std::string load = "[load]\nnormal_force = 1e-3\n";
const std::string exact = "[method]\nkind = \"exact\"\n", rule = "[method]\nkind = \"stationary-force\"\n";

std::string sliding(const std::string& speed, const std::string& more = "") {
  return "[sliding]\nspeed = " + speed + "\n" + more;
}

std::string wanting(const std::string& names) { return "title = \"x\"\nwanted = [" + names + "]\n"; }

}  // namespace

TEST_CASE("a sphere at rest makes Hertz's contact") {
  const auto contact = solved(wanting(R"("span_along", "approach", "peak_pressure", "axis_ratio")") +
                              isotropic_text + die_text + sliding("0.0") + load + exact);
  const double radius = contact["span_along"].value / 2;
  const double modulus = 2 * 3.0 / (1 - 0.25);
  CHECK(4.0 / 3 * modulus * std::pow(radius, 3) == approx(1e-3, 1e-12));
  CHECK(contact["approach"].value == approx(radius * radius, 1e-12));
  CHECK(contact["axis_ratio"].value == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("a die turns with its motion, the material does not") {
  const std::string slender = "[die]\nradius_along = 3.0\nradius_across = 1.0\n";
  const auto turned = [&](const std::string& half_space, const std::string& angle) {
    return wanting(R"("span_along", "orientation", "peak_pressure")") + half_space + slender +
           sliding("0.5", "direction = " + angle + "\n") + load + exact;
  };
  const auto straight = solved(turned(isotropic_text, "0.0")), askew = solved(turned(isotropic_text, "60.0"));
  CHECK(straight["span_along"].value == approx(askew["span_along"].value, 1e-12));
  CHECK(std::fabs(straight["orientation"].value) < 1e-9);
  CHECK(askew["orientation"].value == doctest::Approx(60).epsilon(1e-12));
  const auto along = solved(turned(graphite_epoxy, "0.0")), across = solved(turned(graphite_epoxy, "90.0"));
  CHECK(along["span_along"].value != approx(across["span_along"].value, 1e-3));
}

TEST_CASE("a contact that is round to rounding does not know its orientation") {
  const auto solution = solved(
      "title = \"x\"\naccuracy = 9.5e-11\nwanted = [\"orientation\"]\n"
      "[half_space]\ndensity = 4780.772706457931\nmodel = \"isotropic\"\n"
      "poisson = 0.4990774117034143\nshear = 695484452485.0928\n"
      "[sphere]\ndensity = 0.09221101686079425\npatch = \"moving\"\npoisson = -0.38103149804944925\n"
      "radius = 0.34319790541153344\nshear = 622943232.6402984\n"
      "[sliding]\nspeed = 0.0\ndirection = 90.0\n"
      "[load]\nnormal_force = 59.19267883252701\n[method]\nkind = \"exact\"\n");
  CHECK(solution["orientation"].error >= 90);
}

TEST_CASE("the ends of a line make its span, between them the pressure peaks where its slope vanishes") {
  const std::string friction = sliding("0.6", "friction = 0.4\n");
  const auto ends =
      solved(wanting(R"("span", "leading_end", "trailing_end", "peak_pressure", "centre_along")") +
             isotropic_text + die_text + friction + load + rule + "[profile]\npositions = [30.0, 0.0]\n");
  const double first = ends.profile("trailing_end")[0].value, last = ends.profile("leading_end")[0].value;
  CHECK(last - first == approx(ends.profile("span")[0].value, 1e-15));
  CHECK(last < -first);
  CHECK(ends["centre_along"].value < 0);
  // x+ + x- = -(1 + 2 Omega) L
  const auto at = [&](double x) {
    return solved(wanting(R"("pressure", "shear")") + isotropic_text + die_text + friction + load + rule +
                  fmt::format("[profile]\ndirection = 30.0\npositions = [{:.17g}]\n", x));
  };
  const auto peak = at(first + last);
  CHECK(peak["pressure"].value == approx(ends["peak_pressure"].value, 1e-14));
  CHECK(peak["shear"].value == approx(0.4 * peak["pressure"].value, 1e-15));
  for (const double end : {first, last}) {
    const auto there = at(end);
    CHECK(there["pressure"].value <= there["pressure"].error);
    CHECK(at(1.001 * end)["pressure"].value == 0);
  }
}

TEST_CASE("the surface has the die's shape in the contact, with the sphere's also if that yields") {
  const auto at = [&](const std::string& body, const std::string& end, const std::string& motion) {
    return solved(wanting(R"("approach", "normal_displacement", "transverse_displacement")") +
                  isotropic_text + body + motion + load + exact +
                  "[profile]\ndirection = 90.0\npositions = " + end);
  };
  const std::string places = "[-0.03, 0.0, 0.02]\n";
  const auto under_die = at(die_text, places, sliding("0.9"));
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = under_die.positions[i];
    CHECK(under_die.profile("normal_displacement")[i].value ==
          approx(under_die["approach"].value - x * x / 2, 1e-12));
  }
  // At rest the half-space's share is that of its compliance (1 - nu)/mu in the sum, here 0.25 of 0.25 + 0.35.
  const auto under_sphere =
      at("[sphere]\nradius = 1.0\nshear = 2.0\npoisson = 0.3\ndensity = 1.0\n", places, sliding("0.0"));
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = under_sphere.positions[i];
    CHECK(under_sphere.profile("normal_displacement")[i].value ==
          approx(0.25 / 0.6 * (under_sphere["approach"].value - x * x / 2), 1e-12));
  }
  CHECK(under_sphere.profile("transverse_displacement")[2].value < 0);  // the surface is drawn to the centre
}

TEST_CASE("a sphere whose patch moves in it has its critical speed at rest too") {
  const auto of_sphere = [](const char* speed) {
    auto scene = loaded_example("half-space-sphere-normal-axis",
                                {{"sphere.shear", "7.72e9"}, {"sliding.speed", speed}});
    scene.wanted = {data::ResultId::critical_speed};
    return std::stod(verify::solve_by_ref(scene, 16).results[0].numbers[0].value_text());
  };
  const double shear_waves = std::sqrt(7.72e9 / 7860);
  CHECK(of_sphere("0.0") == of_sphere("500.0"));
  CHECK(of_sphere("0.0") < shear_waves);
}

TEST_CASE("the reference solves for the user's degrees: a direction of 30 is exactly that") {
  // With the rounding error of 30 degrees in radians the orientation would not have 20 digits.
  auto scene = loaded_example("half-space-sliding-die-exact", {{"sliding.direction", "30"}});
  scene.wanted = {data::ResultId::orientation};
  const auto ref = verify::solve_by_ref(scene, 20);
  CHECK(std::fabs(std::strtold(ref["orientation"].value_text().c_str(), nullptr) - 30) <= 1e-18L);
}

TEST_CASE("the reference repeats what is given exactly, and proves no critical speed where lines differ") {
  const auto solved = verify::solve_by_ref(loaded_example("half-space-sliding-die"), 20);
  CHECK(error(solved["normal_force"]) == 0);
  // 0.3 is the double here, not the decimal.
  CHECK(solved["friction_force"].value_text().substr(0, 20) == "299.9999999999999888");
  // The line that becomes critical first is found by estimates.
  auto anisotropic = loaded_example("half-space-anisotropic");
  anisotropic.wanted = {data::ResultId::critical_speed};
  CHECK_FALSE(verify::solve_by_ref(anisotropic, 16)["critical_speed"].proven);
}
