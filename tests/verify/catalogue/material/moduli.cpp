// Rows of materials: every model on both paths, confirmed by the golden values' second method; names and refusals.
#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/stiffness.hpp>
#include <nipref/data/scene/keys.hpp>
#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/catalogue/named_point.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/golden/make.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"

using namespace nipref;

TEST_CASE("materials: series, operators and the thesis's solid are confirmed by a second method") {
  for (const verify::Quantity& quantity : verify::catalogue()) {
    if (!quantity.name.starts_with("material.")) continue;
    CAPTURE(quantity.name);
    verify::Random random("second method");
    for (const double model : {4.0, 5.0, 6.0, 7.0}) {
      for (int i = 0; i < 5; ++i) {
        verify::Point point = quantity.draw(random);
        point[verify::argument_number(quantity.arguments, "material")] = model;
        if (quantity.keep_off) quantity.keep_off(point);
        CAPTURE(point[0]);
        const ref::Estimate truth = verify::ref_value(quantity, point, 30);
        CHECK(truth.proven);
        verify::GoldenRow row = verify::golden_row(quantity, point, truth);
        CHECK(verify::confirm_row(quantity, row) == "");
        const double promised = quantity.promise * verify::ulp_of(row.scale);
        CHECK(std::fabs(truth.error_of(quantity.by_fast(point, {}))) <=
              (quantity.fast_error ? quantity.fast_error(point, {}) : promised));
      }
    }
  }
}

TEST_CASE("materials: a series has as many terms as a solid needs, operators their order") {
  const auto value = [](const std::string& quantity, const std::string& material) {
    const Outcome outcome =
        run("eval " + quantity + " 'material=" + material + "' --path ref --digits 20 --json");
    CHECK(outcome.status == 0);
    return outcome.out.substr(outcome.out.find("\"value\""), 30);
  };
  // theta1 = 1 + 1/(p + 1) + 1/(p + 2) + 1/(p + 4) is N/D with N = p^3 + 10 p^2 + 28 p + 22, D = p^3 + 7 p^2 + 14 p + 8;
  // theta2 is a quarter of it, so that G = D/(2N) and K = 11 D/(6N).
  const std::string series =
      "prony(theta1_instantaneous=1, theta1_amplitudes=[1, 1, 1], theta1_rates=[1, 2, 4], "
      "theta2_instantaneous=0.25, theta2_amplitudes=[0.25, 0.25, 0.25], theta2_rates=[1, 2, 4])";
  const std::string operators =
      "operators(P=[44, 56, 20, 2], Q=[8, 14, 7, 1], P_dilatation=[132, 168, 60, 6], Q_dilatation=[88, 154, 77, "
      "11])";
  for (const char* quantity :
       {"Un_steady alpha=0.5", "Vn t=2 T=1 t0=0.5", "material.theta2 t=0.3", "material.K t=0.3",
        "material.lambda term=3", "material.gamma term=2", "material.K_of_p p=0.5 omega=2 part=im"}) {
    CAPTURE(quantity);
    CHECK(value(quantity, series) == value(quantity, operators));
  }
  CHECK(contains(value("material.lambda term=3", operators), "\"4\""));
  CHECK(contains(
      run("eval Un_steady alpha=0.5 'material=operators(P=[1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1])'").err,
      "must hold 1 to 17 numbers"));
}

TEST_CASE("materials: constants of a model are arguments by the names that a scene has them by") {
  const auto value = [](const std::string& arguments) {
    const Outcome outcome = run("eval " + arguments + " --path ref --digits 20 --json");
    CHECK(outcome.status == 0);
    return outcome.out.substr(outcome.out.find("\"value\""), 30);
  };
  const std::string springs = value("material.G t=0.7");
  CHECK(value("material.G t=0.7 material=operators") == springs);
  CHECK(value("material.G t=0.7 'material=operators(P=[1, 0.5], Q=[0.1875, 0.1875])'") == springs);
  CHECK(value("material.theta1 t=0.7 'material=prony(theta1_amplitudes=[3, 1], theta1_rates=[1, 1])'") ==
        value("material.theta1 t=0.7 'material=prony(theta1_amplitudes=[4])'"));
  const Outcome swept = run("eval material.G 'material=elastic(shear=0.5..2)' t=1 --points 3");
  CHECK(swept.status == 0);
  CHECK(contains(swept.out, "shear"));
}

TEST_CASE(
    "materials: a standard linear solid has one relaxation time, two moduli or six constants, as in a scene") {
  const auto value = [](const std::string& arguments) {
    const Outcome outcome = run("eval " + arguments + " --digits 20 --json");
    CHECK(outcome.status == 0);
    return outcome.out.substr(outcome.out.find("\"value\""), 30);
  };
  const std::string two = " 'material=standard-linear-solid(bulk=1, shear=0.375, relaxation_time=2)'";
  const std::string one = " 'material=standard-linear-solid(bulk=1, relaxation_time=2)'";
  const std::string six =
      " 'material=standard-linear-solid(shear_1=0.375, shear_2=0.375, shear_viscosity=0.75, bulk_1=1, bulk_2=1, "
      "bulk_viscosity=2)'";
  for (const char* name :
       {"Un t=1 T=0.5", "Vn t=1 T=0.5 t0=0.3", "Un_steady alpha=0.5", "Vn_steady alpha=0.5 eta=1"})
    CHECK(value(name + two) == value(name + one));
  for (const char* name :
       {"material.theta1 t=1", "material.theta2 t=1", "material.K t=1", "material.loss_bulk omega=2"})
    CHECK(value(name + two) == value(name + six));
}

TEST_CASE("materials: the second method confirms a moving load on a solid of two moduli") {
  for (const char* name : {"Un", "Vn"}) {
    const verify::Quantity& quantity = verify::find_quantity(name);
    verify::Point point = verify::point_of(quantity, {{"t", 1}, {"T", 0.5}, {"shear", 0.7}});
    point[verify::argument_number(quantity.arguments, "material")] = 4;
    verify::GoldenRow row = verify::golden_row(quantity, point, verify::ref_value(quantity, point, 30));
    CHECK(verify::confirm_row(quantity, row) == "");
  }
}

TEST_CASE("materials and solids: constants by default are the seed's, and keys are those of scenes") {
  const verify::Quantity& transverse = verify::find_quantity("ti.critical");
  const auto& [c11, c33, c13, c44, c66, density] = data::seed::graphite_epoxy;
  CHECK(verify::point_of(transverse, {}) == verify::Point{0, 0, c11, c33, c13, c44, c66, density});
  const verify::Quantity& any = verify::find_quantity("anisotropic.critical");
  const verify::Point point = verify::point_of(any, {});
  const auto epoxy = data::Stiffness::of(data::seed::graphite_epoxy, data::SymmetryAxis::in_plane).voigt;
  std::size_t next = verify::argument_number(any.arguments, "c11");
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = i; k < 6; ++k) CHECK(point[next++] == doctest::Approx(epoxy[i][k]).epsilon(1e-15));
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

TEST_CASE("materials: only what the model has is written, and it is written in the material alone") {
  const std::string list = run("list Un").out;
  CHECK(contains(list, "material=operators(P=[...], Q=[...]"));
  CHECK(!contains(list, "P_2"));
  CHECK(contains(run("eval material.K t=1 'material=elastic(bulk=2, shear=1)' --path fast").out,
                 "material = elastic(shear=1, bulk=2)\n"));
}

TEST_CASE("materials and solids may be those of a scene") {
  const auto output = [](const std::string& arguments) {
    const Outcome outcome = run("eval " + arguments + " --path fast");
    CHECK(outcome.status == 0);
    return outcome.out.substr(outcome.out.find("  value"), 80);
  };
  const std::string scenes = source_directory() + "/data/scenes/";
  CHECK(output("Un t=1 T=0.5 'material=@" + scenes + "viscoelastic-operators.toml'") ==
        output("Un t=1 T=0.5 'material=operators(P=[2, 0.1], Q=[5.4375e4, 5.4375e3], P_dilatation=[1], "
               "Q_dilatation=[1.45e5])'"));
  CHECK(output("ti.rayleigh axis=in-plane 'solid=@" + scenes + "half-space-sphere-in-plane-axis.toml'") ==
        output("ti.rayleigh axis=in-plane 'solid=transversely-isotropic(c11=13.9e9, c33=160.7e9, c13=6.44e9, "
               "c44=7.07e9, c66=3.5e9, density=1688)'"));
  CHECK(output("anisotropic.critical 'solid=@" + scenes + "half-space-anisotropic.toml'") ==
        output(
            "anisotropic.critical 'solid=anisotropic(stiffness=[68.3, 32.2, 30.4, 4.9, -2.3, -0.9, 184.3, 5, "
            "-4.4, -7.8, -6.4, 180, -9.2, 7.5, -9.4, 25, -2.4, -7.2, 26.9, 0.6, 33.6], density=2.62)'"));
}

TEST_CASE("solids: the constants of a half-space are one argument") {
  CHECK(contains(run("list anisotropic.across").out, "solid=anisotropic(stiffness=[...], density=...)"));
}
