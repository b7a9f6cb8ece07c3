// Scenes of the rolling nip: every material model, steady and started motion, and what is refused.
#include <nipref/data/scene/file.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/refused_scene.hpp"
#include "support/scratch_file.hpp"
#include "support/solved_scene.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

/// G1 = G2 = 5.4375e4, K1 = K2 = 1.45e5, tau = 0.1: one relaxation time.
const std::string solid = R"(model = "standard-linear-solid"
bulk = 1.45e5
shear = 5.4375e4
relaxation_time = 0.1
)";
const std::string by_convergence = "kind = \"converged\"\n";

std::string scene_text(
    const std::string& material, const std::string& method,
    const std::string& wanted = R"("contact_length", "rolling_resistance", "creep_ratio")") {
  return "title = \"rolled\"\nwanted = [" + wanted +
         "]\n[roller]\nradius = 6\n[sheet]\nthickness = 0.25\n[rolling]\nspeed = 1.0\n[friction]\nmodel = "
         "\"none\"\n[load]\nper_length = 100\n[method]\n" +
         method + "[material]\n" + material;
}

void check_same_material(const std::string& material, const std::string& other, double tolerance) {
  const auto a = solved(scene_text(material, by_convergence)), b = solved(scene_text(other, by_convergence));
  for (const char* name : {"contact_length", "rolling_resistance", "creep_ratio"}) {
    CAPTURE(name);
    CHECK(a[name].value == approx(b[name].value, tolerance));
  }
}

std::string line_loads(double approach_lengths, const std::string& more = "") {
  std::ostringstream method;
  method << "kind = \"line-loads\"\nleading_elements = 5\napproach_lengths = " << std::fixed
         << approach_lengths << '\n'
         << more;
  return method.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  REQUIRE(position != std::string::npos);
  return text.replace(position, from.size(), to);
}

void check_material_refused(const std::string& material, const std::string& says) {
  check_refused(scene_text(material, by_convergence), says);
}

}  // namespace

TEST_CASE("one solid in four notations makes one contact") {
  // Viscosity = modulus * relaxation time; theta1 = 1/(2G), theta2 = 3/(6K + 2G) with K = 8G/3.
  check_same_material(
      solid,
      "model = \"standard-linear-solid\"\nshear_1 = 5.4375e4\nshear_2 = 5.4375e4\nbulk_1 = 1.45e5\n"
      "bulk_2 = 1.45e5\nshear_viscosity = 5.4375e3\nbulk_viscosity = 1.45e4\n",
      1e-9);
  check_same_material(
      solid,
      "model = \"prony\"\ntheta1_instantaneous = 9.195402298850575e-06\ntheta1_amplitudes = "
      "[9.195402298850575e-05]\ntheta1_rates = [10.0]\ntheta2_instantaneous = 3.0651340996168583e-06\n"
      "theta2_amplitudes = [3.0651340996168583e-05]\ntheta2_rates = [10.0]\n",
      1e-9);
  // 1/G = (1/G1)(2 + tau p)/(1 + tau p).
  check_same_material(
      solid,
      "model = \"operators\"\nP = [2.0, 0.1]\nQ = [5.4375e4, 5.4375e3]\nP_dilatation = [2.0, 0.1]\n"
      "Q_dilatation = [1.45e5, 1.45e4]\n",
      1e-9);
}

TEST_CASE("the thesis's misprint is another material") {
  const auto right = solved(scene_text(solid, by_convergence));
  const auto wrong = solved(
      scene_text("model = \"thesis-misprint\"\nbulk = 1.45e5\nrelaxation_time = 0.1\n", by_convergence));
  CHECK(wrong["rolling_resistance"].value < 0.99 * right["rolling_resistance"].value);
}

TEST_CASE("an elastic sheet that rolls is the elastic nip") {
  const std::string names =
      R"("contact_length", "leading_length", "trailing_length", "indentation", "edge_displacement",
         "trailing_displacement", "rolling_resistance", "creep_ratio", "peak_pressure")";
  const std::string rolled =
      scene_text("model = \"elastic\"\nyoung = 1.45e5\npoisson = 0.3\n", by_convergence, names);
  const auto a = solved(rolled), b = solved(replaced(rolled, "[rolling]\nspeed = 1.0\n", ""));
  REQUIRE(a.results.size() == b.results.size());
  for (std::size_t i = 0; i < a.results.size(); ++i) {
    const auto x = a.results[i].numbers.front(), y = b.results[i].numbers.front();
    CAPTURE(std::string(a.results[i].what->name));
    CHECK(std::fabs(x.value - y.value) <= x.error + y.error + 1e-15 * std::fabs(y.value));
  }
}

TEST_CASE("evenly spaced points run from the trailing end to the leading end") {
  const auto solution =
      solved(scene_text(solid, by_convergence, R"("pressure", "leading_length", "trailing_length")") +
             "[profile]\npoints = 5\n");
  REQUIRE(solution.positions.size() == 5);
  CHECK(solution.positions.front() == -solution["trailing_length"].value);
  CHECK(solution.positions.back() == solution["leading_length"].value);
  const auto pressure = solution.profile("pressure");
  CHECK(pressure.front().value == 0);
  CHECK(pressure.back().value == 0);
  // The sheet is stiffest where it has been pressed for the shortest time.
  CHECK(pressure[3].value > 1.1 * pressure[1].value);
}

TEST_CASE("a started motion forgets its start, and says how far it is from the steady one") {
  const auto resistance = [](double approach) {
    return solved(scene_text(solid, line_loads(approach))).results[1].numbers.front();
  };
  const auto early = resistance(2), late = resistance(60), later = resistance(120);
  CHECK(late.value == approx(later.value, 1e-12));
  CHECK(std::fabs(early.value - late.value) > 1e-5 * late.value);
  const ScratchFile file(scene_text(solid, by_convergence));
  const double steady = verify::solve(data::load_scene(file.path())).results[1].numbers.front().value;
  for (const auto& estimate : {early, late})
    CHECK(estimate.error == doctest::Approx(std::fabs(estimate.value - steady)).epsilon(1e-2));
}

TEST_CASE("the number of trailing elements may be given or sought") {
  const auto sought = solved(scene_text(solid, line_loads(30, "residue_terms = 200\n"),
                                        R"("leading_length", "trailing_length", "load")"));
  const double ratio = sought["trailing_length"].value / sought["leading_length"].value;
  const double trailing = std::round(5 * ratio);
  CHECK(5 * ratio == doctest::Approx(trailing).epsilon(1e-12));
  CHECK(sought["load"].value == doctest::Approx(100).epsilon(1e-9));
  const auto given = solved(scene_text(solid,
                                       line_loads(30, "residue_terms = 200\ntrailing_elements = " +
                                                          std::to_string(static_cast<int>(trailing)) + "\n"),
                                       R"("leading_length")"));
  CHECK(given["leading_length"].value == approx(sought["leading_length"].value, 1e-12));
}

TEST_CASE("a material that cannot be is refused at its key") {
  const auto with = [](const std::string& from, const std::string& to) { return replaced(solid, from, to); };
  check_material_refused(with("relaxation_time = 0.1", "relaxation_time = 0.0"),
                         ":19: material.relaxation_time = 0: ");
  check_material_refused(with("relaxation_time = 0.1", "relaxation_time = -2.0"),
                         ":19: material.relaxation_time = -2: ");
  check_material_refused(with("shear = 5.4375e4", "shear = -1.0"), ":18: material.shear = -1: ");
  check_material_refused(with("standard-linear-solid", "rubber"), ":16: material.model = rubber: ");
  check_material_refused(with("shear = 5.4375e4\n", ""), "material.shear = (missing)");
  const std::string prony =
      "model = \"prony\"\ntheta1_instantaneous = 1e-5\ntheta1_amplitudes = [1e-5]\ntheta1_rates = [1.0]\n"
      "theta2_instantaneous = 3e-6\ntheta2_amplitudes = [3e-6]\ntheta2_rates = [1.0]\n";
  const auto prony_with = [&](const std::string& from, const std::string& to) {
    return replaced(prony, from, to);
  };
  check_material_refused(prony_with("theta1_amplitudes = [1e-5]\ntheta1_rates = [1.0]",
                                    "theta1_amplitudes = []\ntheta1_rates = []"),
                         "material.theta1_amplitudes = []: ");
  check_material_refused(prony_with("theta2_rates = [1.0]", "theta2_rates = [1.0, 2.0]"), "material.theta2_");
  check_material_refused(prony_with("theta1_rates = [1.0]", "theta1_rates = [-1.0]"), "material.theta1");
  check_material_refused(replaced(prony_with("theta1_instantaneous = 1e-5", "theta1_instantaneous = 0.0"),
                                  "theta2_instantaneous = 3e-6", "theta2_instantaneous = 0.0"),
                         "material.theta1 instantaneous = 0: must be > 0: under a roller");
  check_material_refused(prony_with("theta1_amplitudes = [1e-5]", "theta1_amplitudes = [-5e-6]"),
                         "material.shear loss = ");
  check_material_refused(
      "model = \"operators\"\nP = [1.0]\nQ = []\nP_dilatation = [1.0]\nQ_dilatation = [1.0]\n",
      "material.Q = ");
  check_material_refused(
      "model = \"operators\"\nP = [-2.0, 0.1]\nQ = [1.0, 1.0]\nP_dilatation = [1.0]\nQ_dilatation = [1.0]\n",
      "material.");
}

TEST_CASE("a sheet that flows rolls, by either method and notation, but not if it is nearly viscous") {
  // G = 5e4 p/(p + 8), K = 2e5 p/(p + 8)
  const std::string operators =
      "model = \"operators\"\nP = [8, 1]\nQ = [0, 5e4]\nP_dilatation = [8, 1]\nQ_dilatation = [0, 2e5]\n";
  const std::string prony =
      "model = \"prony\"\ntheta1_instantaneous = 1e-5\ntheta1_amplitudes = [8e-5]\ntheta1_rates = [0]\n"
      "theta2_instantaneous = 2.3076923076923077e-6\ntheta2_amplitudes = [1.8461538461538462e-5]\ntheta2_rates = [0]\n";
  check_same_material(operators, prony, 1e-9);
  for (const auto& result : solved(scene_text(prony, line_loads(40))).results)
    CHECK(result.numbers.front().error < 0.2 * std::fabs(result.numbers.front().value));
  check_refused(scene_text(prony, line_loads(40, "residue_terms = 200\n")),
                "method.residue_terms = 200: must be 0: the material is a fluid");
  const std::string viscous =
      replaced(replaced(prony, "[8e-5]", "[80]"), "[1.8461538461538462e-5]", "[18.461538461538462]");
  check_refused(
      replaced(scene_text(viscous, by_convergence), "[load]\nper_length = 100", "[contact]\nlength = 0.1"),
      "material = ");
}

TEST_CASE("a sheet rolls that gives way to nothing at once in dilatation only: the limit of stiff ones") {
  const auto dilatation = [](const char* p) {
    return std::string("model = \"operators\"\nP = [2, 0.1]\nQ = [5e4, 5e3]\nQ_dilatation = [1.5e5, 1e4]\n") +
           "P_dilatation = " + p + "\n";
  };
  check_same_material(dilatation("[1]"), dilatation("[1, 1e-10]"), 1e-8);
  const auto steady = solved(scene_text(dilatation("[1]"), line_loads(40)));
  for (const auto& result : steady.results)
    CHECK(result.numbers.front().error < 0.2 * std::fabs(result.numbers.front().value));
  // In shear: then nothing gives way at once.
  check_material_refused(
      "model = \"operators\"\nP = [1]\nQ = [5e4, 5e3]\nP_dilatation = [1]\nQ_dilatation = [1.5e5]\n",
      "material.theta1 instantaneous = 0: must be > 0: under a roller");
}

TEST_CASE("motions and methods that cannot be are refused at their keys") {
  const auto with = [](const std::string& from, const std::string& to) {
    return replaced(scene_text(solid, line_loads(24)), from, to);
  };
  check_refused(with("speed = 1.0", "speed = 0.0"), ":8: rolling.speed = 0: must be finite and > 0");
  check_refused(with("speed = 1.0", "speed = -1.0"), ":8: rolling.speed = -1: ");
  check_refused(with("[rolling]\nspeed = 1.0\n", ""), "rolling = (missing): ");
  check_refused(with("model = \"none\"", "model = \"full\""), ":10: friction.model = full: must be none");
  check_refused(with("leading_elements = 5", "leading_elements = 0"), "method.leading_elements = 0: ");
  check_refused(with("approach_lengths = 24.000000", "approach_lengths = 0.0"),
                "method.approach_lengths = 0: ");
  check_refused(with("approach_lengths = 24.000000\n", ""), "method.approach_lengths = (missing): ");
  check_refused(with("[load]\nper_length = 100", "[contact]\nlength = 0.1"),
                "method.trailing_elements = (missing): ");
  check_refused(with("per_length = 100", "per_length = -100"), ":12: load.per_length = -100: ");
  check_refused(with("[load]", "[profile]\npoints = 3\nlag = 1\n[load]"), "profile.lag = 1: unknown key");
}

TEST_CASE("what the reference's rolling contact does not have is refused by its key") {
  const std::string wanted = R"("contact_length")";
  check_refused(
      replaced(scene_text(solid, by_convergence, wanted), "relaxation_time = 0.1", "relaxation_time = 1e-12"),
      "material", " --path ref --digits 16");
  check_refused(scene_text(solid, by_convergence, wanted), "digits = 31: must be from 16 to 30",
                " --path ref --digits 31");
}
