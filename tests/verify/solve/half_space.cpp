// Scenes of bodies on half-spaces: what they give, and what is refused.
#include <fmt/format.h>

#include <nipref/data/scene/file.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/refused_scene.hpp"
#include "support/scratch_file.hpp"
#include "support/solved_scene.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

const std::string isotropic =
    "[half_space]\nmodel = \"isotropic\"\nshear = 3.0\npoisson = 0.25\ndensity = 2.0\n";
const std::string isotropic_as_transversely =
    "[half_space]\nmodel = \"transversely-isotropic\"\naxis = \"in-plane\"\nc11 = 9.0\nc33 = 9.0\n"
    "c13 = 3.0\nc44 = 3.0\nc66 = 3.0\ndensity = 2.0\n";
const std::string graphite_epoxy =
    "[half_space]\nmodel = \"transversely-isotropic\"\naxis = \"in-plane\"\nc11 = 13.9e9\nc33 = 160.7e9\n"
    "c13 = 6.44e9\nc44 = 7.07e9\nc66 = 3.5e9\ndensity = 1688.0\n";
const std::string die = "[die]\nradius_along = 1.0\nradius_across = 1.0\n";
const std::string rolling = "[rolling_sphere]\nradius = 1.0\n[rolling]\nspeed = 0.3\n";
const std::string load = "[load]\nnormal_force = 1e-3\n";
const std::string exact = "[method]\nkind = \"exact\"\n", rule = "[method]\nkind = \"stationary-force\"\n";

std::string sliding(const std::string& speed, const std::string& more = "") {
  return "[sliding]\nspeed = " + speed + "\n" + more;
}

std::string wanting(const std::string& names) { return "title = \"x\"\nwanted = [" + names + "]\n"; }

const std::string spans = wanting(R"("span_along", "span_across", "normal_force", "peak_pressure")");

void check_same(const std::string& a, const std::string& b, double tolerance) {
  const auto x = solved(a), y = solved(b);
  for (std::size_t i = 0; i < x.results.size(); ++i) {
    CAPTURE(std::string(x.results[i].what->name));
    CHECK(x.results[i].numbers[0].value == approx(y.results[i].numbers[0].value, tolerance));
  }
}

}  // namespace

TEST_CASE("a sphere at rest is Hertz's") {
  const auto contact = solved(wanting(R"("span_along", "approach", "peak_pressure", "axis_ratio")") +
                              isotropic + die + sliding("0.0") + load + exact);
  const double radius = contact["span_along"].value / 2;
  const double modulus = 2 * 3.0 / (1 - 0.25);
  CHECK(4.0 / 3 * modulus * std::pow(radius, 3) == approx(1e-3, 1e-12));
  CHECK(contact["approach"].value == approx(radius * radius, 1e-12));
  CHECK(contact["axis_ratio"].value == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("force and span lead to the same contact, by either rule") {
  for (const std::string& method : {exact, rule}) {
    const auto by_force = solved(spans + isotropic + die + sliding("0.9") + load + method);
    char span[40];
    std::snprintf(span, sizeof span, "%.17g", by_force["span_along"].value);
    check_same(spans + isotropic + die + sliding("0.9") + load + method,
               spans + isotropic + die + sliding("0.9") + "[contact]\nspan_along = " + span + "\n" + method,
               1e-13);
  }
}

TEST_CASE("estimates of contacts on half-spaces cover what roundings leave next to the critical speed") {
  // The Rayleigh speed of nu = 1/4 is sqrt(2 - 2/sqrt(3)), here times sqrt(3.1/1.9): 1.174381882.
  const std::string solid =
      "[half_space]\nmodel = \"isotropic\"\nshear = 3.1\npoisson = 0.25\ndensity = 1.9\n";
  for (const char* speed : {"1.1743", "1.174381", "1.17438188"}) {
    CAPTURE(speed);
    const auto contact = solved(wanting("\"compliance\", \"coupling\"") + solid + die + sliding(speed) +
                                load + rule + "[profile]\npositions = [0.0, 1e-3, 20.0]\n");
    const auto surface = [&](double degrees) {
      const ref::Exact shear(3.1), density(1.9), at(std::stod(speed));
      return ref::line_response(
          ref::sagittal_stiffness(ref::ExactTransverse::isotropic(shear, ref::Exact(0.25), density)), at,
          ref::SurfaceDirection::of_degrees(ref::Exact(0.0)),
          ref::SurfaceDirection::of_degrees(ref::Exact(degrees)), 30);
    };
    for (std::size_t i = 0; i < contact.positions.size(); ++i) {
      const auto truth = surface(contact.positions[i]);
      const fast::Estimate compliance = contact.profile("compliance")[i];
      const fast::Estimate coupling = contact.profile("coupling")[i];
      CHECK(std::fabs(truth.compliance.error_of(compliance.value)) <= compliance.error);
      CHECK(std::fabs(truth.coupling.error_of(coupling.value)) <= coupling.error);
      CHECK(compliance.error < 1e-14 * compliance.value);
    }
  }
}

TEST_CASE("what follows from a given span has an error, by either rule") {
  for (const std::string& method : {exact, rule}) {
    const auto contact =
        solved(spans + isotropic + die + sliding("0.9") + "[contact]\nspan_along = 0.1\n" + method);
    for (const char* name : {"span_across", "normal_force", "peak_pressure"}) {
      CAPTURE(name);
      CHECK(contact[name].error > 0);
      CHECK(contact[name].error < 1e-12 * contact[name].value);
    }
  }
  const auto roll = solved(spans + isotropic + rolling + "[contact]\nspan_along = 0.1\n" + rule);
  CHECK(roll["normal_force"].error > 0);
  CHECK(roll["peak_pressure"].error > 0);
  CHECK(roll["peak_pressure"].error < 1e-12 * roll["peak_pressure"].value);
}

TEST_CASE("an isotropic solid is the same by all five of its constants") {
  for (const std::string& method : {exact, rule}) {
    const std::string rest = die + sliding("0.9", "direction = 30.0\n") + load + method;
    check_same(spans + isotropic + rest, spans + isotropic_as_transversely + rest, 1e-12);
  }
}

TEST_CASE("a die turns with its motion, the material does not") {
  const std::string slender = "[die]\nradius_along = 3.0\nradius_across = 1.0\n";
  const auto turned = [&](const std::string& half_space, const std::string& angle) {
    return wanting(R"("span_along", "orientation", "peak_pressure")") + half_space + slender +
           sliding("0.5", "direction = " + angle + "\n") + load + exact;
  };
  const auto straight = solved(turned(isotropic, "0.0")), askew = solved(turned(isotropic, "60.0"));
  CHECK(straight["span_along"].value == approx(askew["span_along"].value, 1e-12));
  CHECK(std::fabs(straight["orientation"].value) < 1e-9);
  CHECK(askew["orientation"].value == doctest::Approx(60).epsilon(1e-12));
  const auto along = solved(turned(graphite_epoxy, "0.0")), across = solved(turned(graphite_epoxy, "90.0"));
  CHECK(along["span_along"].value != approx(across["span_along"].value, 1e-3));
}

TEST_CASE("a contact that is round to rounding lies anyhow") {
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

TEST_CASE("a patch that moves in its sphere softens it") {
  const std::string sphere = "[sphere]\nradius = 0.01\nshear = 77.2e9\npoisson = 0.3\ndensity = 7860.0\n";
  const std::string rest = sliding("1200.0") + load + exact;
  const auto fixed = solved(spans + graphite_epoxy + sphere + rest);
  const auto moving = solved(spans + graphite_epoxy + sphere + "patch = \"moving\"\n" + rest);
  CHECK(moving["peak_pressure"].value < fixed["peak_pressure"].value);
  CHECK(moving["peak_pressure"].value > 0.98 * fixed["peak_pressure"].value);
}

TEST_CASE("speeds that are not subcritical are refused with the line and the limit") {
  check_refused(spans + isotropic + die + sliding("1.2") + load + exact,
                "sliding.speed = 1.2: must be below 1.126");  // Rayleigh: 0.9194 sqrt(3/2)
  check_refused(spans + graphite_epoxy + die + sliding("1600.0", "direction = 45.0\n") + load + exact,
                "sliding.speed = 1600: ");
  check_refused(spans + graphite_epoxy + die + sliding("1600.0", "direction = 45.0\n") + load + exact,
                "psi = 24.55");  // 20.44 degrees from the motion
  check_refused(spans + isotropic + "[rolling_sphere]\nradius = 1.0\n[rolling]\nspeed = 2.0\n" + load + rule,
                "rolling.speed = 2: must be below 1.126");
  check_refused(spans + isotropic + die + sliding("-1.0") + load + exact, "sliding.speed = -1: ");
}

TEST_CASE("solids that cannot be are refused at their keys") {
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string rest = die + sliding("0.1") + load + exact;
  check_refused(spans + with(isotropic, "0.25", "0.5") + rest, ":6: half_space.poisson = 0.5: ");
  check_refused(spans + with(isotropic, "0.25", "-1.0") + rest, ":6: half_space.poisson = -1: ");
  check_refused(spans + with(isotropic, "shear = 3.0", "shear = -3.0") + rest, ":5: half_space.shear = -3: ");
  check_refused(spans + with(graphite_epoxy, "c13 = 6.44e9", "c13 = 60.0e9") + rest, ":8: half_space.c13 = ");
  check_refused(spans + with(graphite_epoxy, "c66 = 3.5e9", "c66 = 0.0") + rest, ":10: half_space.c66 = 0: ");
  check_refused(spans + with(graphite_epoxy, "in-plane", "oblique") + rest,
                ":5: half_space.axis = oblique: ");
}

TEST_CASE("what does not fit together is refused at its key") {
  check_refused(spans + isotropic + die + sliding("0.1", "friction = -0.1\n") + load + rule,
                "sliding.friction = -0.1: ");
  check_refused(spans + isotropic + die + sliding("0.1", "friction = 0.1\n") + load + exact,
                "sliding.friction = 0.1: must be 0");
  check_refused(spans + isotropic + die + sliding("0.1", "direction = 91.0\n") + load + rule,
                "sliding.direction = 91: ");
  check_refused(spans + isotropic + rolling + load + exact, "method.kind = exact: must be stationary-force");
  check_refused(spans + graphite_epoxy + rolling + load + rule, "half_space.model = ");
  check_refused(spans + isotropic + die + rolling + load + rule, "die = (beside another body): ");
  check_refused(spans + isotropic + sliding("0.1") + load + rule, "die = (missing): ");
  check_refused(spans + isotropic + die + sliding("0.1") + rule, "load = (missing): ");
  check_refused(spans + isotropic + die + sliding("0.1") + "[contact]\nspan_along = 1.1\n" + rule,
                "contact.span_along = 1.1: ");
  check_refused(wanting("\"approach\"") + isotropic + die + sliding("0.1") + load + rule,
                ":2: wanted[0] = approach: must be wanted of the exact method only");
  check_refused(wanting("\"contact_length\"") + isotropic + die + sliding("0.1") + load + rule,
                ":2: wanted[0] = contact_length: ");
  check_refused(spans + isotropic + die + "[roller]\nradius = 1.0\n" + sliding("0.1") + load + rule,
                "roller = ");
}

TEST_CASE("a friction force has the rounding of its product, though force and friction are given") {
  const data::Scene scene = data::load_scene(data::example_scene("half-space-sliding-die"));
  const auto solved = verify::solve(scene);
  const double force =
      std::get<data::GivenNormalForce>(std::get<data::HalfSpaceProblem>(scene.system).given).force;
  // 0.3 is no binary number: 1000 times it is 1.1e-14 below 300.
  CHECK(std::fabs(std::fma(0.3, force, -solved["friction_force"].value)) > 1e-14);
  CHECK(solved["friction_force"].error >= std::fabs(std::fma(0.3, force, -solved["friction_force"].value)));
}

TEST_CASE(
    "the ends of a line make its span, and between them the pressure has its peak where its slope vanishes") {
  const std::string friction = sliding("0.6", "friction = 0.4\n");
  const auto ends =
      solved(wanting(R"("span", "leading_end", "trailing_end", "peak_pressure", "centre_along")") +
             isotropic + die + friction + load + rule + "[profile]\npositions = [30.0, 0.0]\n");
  const double first = ends.profile("trailing_end")[0].value, last = ends.profile("leading_end")[0].value;
  CHECK(last - first == approx(ends.profile("span")[0].value, 1e-15));
  CHECK(last < -first);
  CHECK(ends["centre_along"].value < 0);
  // x+ + x- = -(1 + 2 Omega) L
  const auto at = [&](double x) {
    return solved(wanting(R"("pressure", "shear")") + isotropic + die + friction + load + rule +
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

TEST_CASE("without friction the pressures of all methods are even, without a centre aside") {
  for (const std::string& method : {exact, rule}) {
    const auto line = solved(
        wanting(R"("pressure", "shear", "peak_pressure", "centre_along", "centre_across")") + isotropic +
        die + sliding("0.5") + load + method + "[profile]\ndirection = 70.0\npoints = 5\n");
    const auto& pressure = line.profile("pressure");
    CHECK(pressure[2].value == approx(line["peak_pressure"].value, 1e-14));
    CHECK(pressure[1].value == approx(pressure[3].value, 1e-13));
    CHECK(pressure[1].value == approx(std::sqrt(0.75) * pressure[2].value, 1e-13));
    CHECK(line.profile("shear")[1].value == 0);
    CHECK(std::fabs(line["centre_along"].value) <= line["centre_along"].error);
    CHECK(std::fabs(line["centre_across"].value) <= line["centre_across"].error);
  }
}

TEST_CASE("a rolling sphere's creep and compressed radius, and tractions that end there") {
  const std::string fast_rolling = "[rolling_sphere]\nradius = 1.0\n[rolling]\nspeed = 1.1\n";
  const std::string small = "[contact]\nspan_along = 1e-6\n";
  const auto rolls = solved(wanting(R"("span", "creep", "compressed_radius")") + isotropic + fast_rolling +
                            small + rule + "[profile]\npositions = [0.0, 90.0]\n");
  const double radius = rolls.profile("compressed_radius")[0].value,
               half = rolls.profile("span")[0].value / 2;
  CHECK(radius < half);
  // Of a contact so small V0 is P sqrt(wS/wD) L/R; across the motion both roots are 1 and tanh(pi P) = 1/3.
  const double across = rolls.profile("span")[1].value * std::atanh(1. / 3) / std::acos(-1.);
  CHECK(rolls.profile("creep")[1].value == approx(across, 1e-5));
  const auto tractions = [&](double x) {
    return solved(wanting(R"("pressure")") + isotropic + fast_rolling + small + rule +
                  fmt::format("[profile]\ndirection = 0.0\npositions = [{:.17g}]\n", x))["pressure"];
  };
  const double strip = half - radius;
  CHECK(tractions(radius - 0.1 * strip).value > 0);
  CHECK(tractions(radius + 0.1 * strip).value < 0);
}

TEST_CASE("results of lines, of points on them and of rolling spheres are refused elsewhere") {
  const std::string body = isotropic + die + sliding("0.5") + load + rule;
  check_refused(wanting(R"("pressure")") + body + "[profile]\npoints = 5\n",
                "must be wanted with profile.direction");
  check_refused(wanting(R"("span")") + body + "[profile]\ndirection = 0.0\npoints = 5\n",
                "must be wanted without profile.direction");
  check_refused(wanting(R"("creep")") + body + "[profile]\npoints = 5\n",
                "must be wanted of a rolling sphere only");
  check_refused(wanting(R"("pressure")") + body + "[profile]\ndirection = 91.0\npoints = 5\n",
                "profile.direction = 91");
  check_refused(wanting(R"("span_along")") +
                    "[half_space]\nmodel = \"anisotropic\"\nstiffness = [1.0, 2.0]\n" + "density = 1.0\n" +
                    die + sliding("0.0") + load + rule,
                "must be 21 numbers");
  check_refused(
      wanting(R"("span_along")") +
          "[half_space]\nmodel = \"anisotropic\"\nstiffness = [1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, "
          "0, 0, 1, 0, 1]\ndensity = 1.0\n" +
          rolling + load + rule,
      "must be isotropic under a rolling sphere");
}

TEST_CASE("a contact similar to the body's contours: its spans are theirs, its force their integral") {
  data::Scene scene = data::load_scene(data::example_scene("half-space-sliding-die-similar"));
  auto& problem = std::get<data::HalfSpaceProblem>(scene.system);
  scene.wanted = {data::ResultId::span_along, data::ResultId::span_ratio, data::ResultId::normal_force,
                  data::ResultId::compliance};

  // At rest without friction p = (C/K) sqrt(L^2/4 - x^2) on a line, so that F = int C L^3/(12 K) dpsi, L = L1 sqrt(C1/C).
  problem.speed = problem.friction = 0;
  const auto at_rest = verify::solve(scene);
  const double along = 1 / 0.02, across = 1 / 0.01, length = at_rest["span_along"].value;
  CHECK(at_rest["span_ratio"].value == approx(std::sqrt(along / across), 1e-14));
  double integral = 0;
  constexpr int parts = 2000;
  for (int i = 0; i < parts; ++i) {
    const double psi = std::acos(-1.0) * (i + 0.5) / parts;
    integral += 1 / std::sqrt(along * std::pow(std::cos(psi), 2) + across * std::pow(std::sin(psi), 2));
  }
  const double force = std::pow(along, 1.5) * std::pow(length, 3) /
                       (12 * at_rest.profile("compliance")[0].value) * integral * std::acos(-1.0) / parts;
  CHECK(at_rest["normal_force"].value == approx(force, 1e-12));
}

TEST_CASE("no sphere rolls on a contact similar to its contours") {
  data::Scene scene = data::load_scene(data::example_scene("half-space-rolling-sphere"));
  scene.wanted = {data::ResultId::span_along};
  std::get<data::HalfSpaceProblem>(scene.system).rule = data::ContourRule::similar_contour;
  CHECK_THROWS_WITH_AS((void)verify::solve(scene), doctest::Contains("(30) is a die's"), data::BadInput);
}
