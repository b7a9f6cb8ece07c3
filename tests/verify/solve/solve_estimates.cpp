// Contacts whose error estimates were once smaller than their errors.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

#include <nipref/verify/solve/solve.hpp>

#include "support/solved_scene.hpp"

using namespace nipref;

namespace {

std::string elastic(const std::string& friction, double length_over_thickness, double accuracy) {
  return fmt::format(R"(title = "elastic"
wanted = ["load", "indentation", "creep_ratio", "peak_pressure", "peak_shear"]
accuracy = {}
[roller]
radius = 50000.0
[sheet]
thickness = 1.0
[material]
model = "elastic"
young = 1.45e5
poisson = 0.3333333333333333
[contact]
length = {}
[friction]
model = "{}"
[method]
kind = "converged"
)",
                     accuracy, length_over_thickness, friction);
}

/// Three memories, of which one fades within 1e-7 of the contact and two last for it: what trails behind the contact
/// counts.
std::string three_memories(double accuracy) {
  return fmt::format(R"(title = "three memories"
wanted = ["load", "trailing_displacement", "rolling_resistance", "peak_pressure", "pressure"]
accuracy = {}
[roller]
radius = 64.12120734441639
[sheet]
thickness = 4.019562648144145
[material]
model = "prony"
theta1_amplitudes = [256.81421321177305, 5.089667115124676e-07, 0.004119451297804751]
theta1_instantaneous = 0.06277946947754352
theta1_rates = [2195.343250432138, 0.007388329091637874, 0.005744241314730762]
theta2_amplitudes = [0.0604901949861693, 1.198823664618231e-10, 9.702983690967078e-07]
theta2_instantaneous = 1.4787119070755476e-05
theta2_rates = [2195.343250432138, 0.007388329091637874, 0.005744241314730762]
[rolling]
speed = 0.04247072887061991
[contact]
length = 0.5571655330030602
[friction]
model = "none"
[method]
kind = "converged"
[profile]
positions = [0.0, 0.1075556718866725, -0.2785]
)",
                     accuracy);
}

void check_covers(const fast::Estimate& coarse, const fast::Estimate& fine) {
  CAPTURE(coarse.value);
  CAPTURE(coarse.error);
  CHECK(std::fabs(coarse.value - fine.value) <= coarse.error + fine.error);
}

}  // namespace

TEST_CASE("frictionless contacts are within their estimates of the reference") {
  // 12.4 thicknesses: at its accuracy two levels of the expansion happened to agree.
  for (const double length : {12.412938459, 0.01, 3.0, 10.9}) {
    data::Scene scene = data::parse_scene(elastic("none", length, 1e-8), "elastic");
    scene.wanted = {data::ResultId::load, data::ResultId::indentation, data::ResultId::creep_ratio,
                    data::ResultId::peak_pressure};
    const auto truth = verify::solve_by_ref(scene, 18);
    for (const double accuracy : {1e-3, 1e-8, 1e-13}) {
      CAPTURE(length);
      CAPTURE(accuracy);
      scene.accuracy = accuracy;
      const auto found = verify::solve(scene);
      for (const data::ResultId id : scene.wanted) {
        CAPTURE(data::scene_result(id).name);
        const long double error =
            std::fabs(static_cast<long double>(found[id].value) - std::stold(truth[id].value_text()));
        CHECK(error <= static_cast<long double>(found[id].error));
        CHECK(found[id].error <= 1e3 * accuracy * std::fabs(found[id].value));
      }
    }
  }
}

TEST_CASE("without slip on a thin sheet, asking for more never gives less") {
  auto before = solved(elastic("full", 318, 1e-8));
  for (const double accuracy : {1e-10, 1e-11, 1e-13}) {
    CAPTURE(accuracy);
    const auto now = solved(elastic("full", 318, accuracy));
    for (const char* name : {"load", "creep_ratio", "peak_shear"}) {
      CAPTURE(name);
      CHECK(now[name].error <= 2 * before[name].error);
      check_covers(before[name], now[name]);
    }
    before = now;
  }
}

TEST_CASE("a cut of the quadrature that meets a matching point leaves no empty piece") {
  // The middle of the last panel is 5 half-thicknesses from its mirror image.
  const auto exact = solved(elastic("full", 10, 1e-6)), near = solved(elastic("full", 10.000000001, 1e-6));
  CHECK(exact["load"].value == doctest::Approx(near["load"].value).epsilon(1e-8));
}

TEST_CASE("what trails behind a rolling contact is in its estimates") {
  const auto fine = solved(three_memories(1e-13));
  CHECK(fine["load"].error < 1e-9 * fine["load"].value);
  for (const double accuracy : {1e-2, 1e-4, 1e-7}) {
    CAPTURE(accuracy);
    const auto coarse = solved(three_memories(accuracy));
    for (const char* name : {"load", "trailing_displacement", "rolling_resistance", "peak_pressure"}) {
      CAPTURE(name);
      check_covers(coarse[name], fine[name]);
    }
    for (const std::size_t i : {0U, 1U, 2U})
      check_covers(coarse.profile("pressure")[i], fine.profile("pressure")[i]);
  }
}

TEST_CASE(
    "next to where tangential displacements are counted from they have the rounding of what they differ by") {
  std::string text = elastic("none", 300, 1e-13);
  text.replace(text.find("wanted = ["), 10, "wanted = [\"tangential_displacement\", ");
  const auto shifts =
      solved(text + "[profile]\npositions = [0.03, 149.0]\n").profile("tangential_displacement");
  CHECK(shifts[0].error > 1e-16 * std::fabs(shifts[1].value));
}

TEST_CASE("next to a contact's end a traction knows how well the end is known") {
  std::string text = elastic("none", 1, 1e-6);
  const double load = solved(text)["load"].value;
  text.replace(text.find("[contact]\nlength"), 16, "[load]\nper_length");
  text.replace(text.find("per_length = "), 14, fmt::format("per_length = {:.17g}", load));
  text.replace(text.find("wanted = ["), 10, "wanted = [\"pressure\", ");
  const auto found = solved(text + "[profile]\npositions = [0.4999999999, 0.5, 0.5000000001]\n");
  for (const fast::Estimate& pressure : found.profile("pressure")) CHECK(pressure.error > 0);
}
