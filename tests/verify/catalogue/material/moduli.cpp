// Rows of materials: defaults and names.
#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/stiffness.hpp>
#include <nipref/data/scene/keys.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/named_point.hpp>

#include "support/run_nipref.hpp"

using namespace nipref;

TEST_CASE("materials: a series has as many terms as a solid needs, operators their order") {
  // theta1 = 1 + 1/(p + 1) + 1/(p + 2) + 1/(p + 4) is N/D with N = p^3 + 10 p^2 + 28 p + 22, D = p^3 + 7 p^2 + 14 p + 8;
  // theta2 is a quarter of it, so that G = D/(2N) and K = 11 D/(6N).
  const std::string series =
      " 'material=prony(theta1_instantaneous=1, theta1_amplitudes=[1, 1, 1], theta1_rates=[1, 2, 4], "
      "theta2_instantaneous=0.25, theta2_amplitudes=[0.25, 0.25, 0.25], theta2_rates=[1, 2, 4])'";
  const std::string operators =
      " 'material=operators(P=[44, 56, 20, 2], Q=[8, 14, 7, 1], P_dilatation=[132, 168, 60, 6], Q_dilatation=[88, "
      "154, 77, 11])'";
  const auto value = [](const std::string& arguments) {
    return answer_to("eval " + arguments + " --path ref --digits 20")["results"]["ref"]["value"];
  };
  for (const std::string quantity :
       {"Un_steady alpha=0.5", "Vn t=2 T=1 t0=0.5", "material.theta2 t=0.3", "material.K t=0.3",
        "material.lambda term=3", "material.gamma term=2", "material.K_of_p p=0.5 omega=2 part=im"}) {
    CAPTURE(quantity);
    CHECK(value(quantity + series) == value(quantity + operators));
  }
  CHECK(value("material.lambda term=3" + operators) == "4");
}

TEST_CASE("materials and solids: constants by default are the seed's, and keys are those of scenes") {
  const verify::Quantity& transverse = verify::find_quantity("ti.critical");
  const auto& [c11, c33, c13, c44, c66, density] = data::seed::graphite_epoxy;
  CHECK(verify::point_of(transverse, {}) == verify::Point{0, 0, c11, c33, c13, c44, c66, density});
  const verify::Quantity& any = verify::find_quantity("anisotropic.critical");
  const verify::Point point = verify::point_of(any, {});
  const auto epoxy = data::Stiffness::of(data::seed::graphite_epoxy, data::SymmetryAxis::in_plane).voigt;
  std::size_t next = verify::argument_number(any.arguments, "c11");
  for (const auto& [i, k] : data::upper_triangle)
    CHECK(point[next++] == doctest::Approx(epoxy[i][k]).epsilon(1e-15));
  for (const verify::Quantity& quantity : verify::catalogue()) {
    for (const verify::Argument& argument : verify::written_arguments(quantity)) {
      const std::string table = argument.name == "solid" ? "half_space." : "material.";
      for (const verify::MaterialModel& model : argument.models) {
        for (const verify::ModelKey& key : model.keys) {
          CAPTURE(key.name);
          CHECK(data::find_scene_key(table + key.name) != nullptr);
        }
      }
    }
  }
}
