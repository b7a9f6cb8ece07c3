// Scenes of the rolling nip: every material model, steady and started motion.
#include <fmt/format.h>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

using Solution = verify::SceneSolution<fast::Estimate>;

/// Solves the example with the sheet thickness 0.25 and G1 = G2 = 5.4375e4, K1 = K2 = 1.45e5, tau = 0.1, one relaxation
/// time; or with another material, "model; key = value; ...".
Solution rolled(const std::string& material = "", data::SceneOverrides overrides = {}) {
  std::string text = R"(title = "rolled"
wanted = ["contact_length", "rolling_resistance", "creep_ratio"]
[roller]
radius = 6
[sheet]
thickness = 0.25
[rolling]
speed = 1.0
[friction]
model = "none"
[method]
)";
  const auto has = [&](const char* key) {
    return std::ranges::find(overrides, key, &data::SceneOverrides::value_type::first) != overrides.end();
  };
  if (!has("contact.length")) text += "[load]\nper_length = 100\n";
  text += "[material]\n";
  text += material.empty()
              ? "model = standard-linear-solid; bulk = 1.45e5; shear = 5.4375e4; relaxation_time = 0.1"
              : "model = " + material;
  for (std::size_t at = 0; (at = text.find("; ", at)) != std::string::npos;) text.replace(at, 2, "\n");
  const std::size_t model = text.rfind("model = ") + 8;
  text.insert(std::min(text.find('\n', model), text.size()), "\"");
  text.insert(model, "\"");
  if (!has("method.kind")) overrides.emplace_back("method.kind", "converged");
  return verify::solve(data::load_scene(data::SceneText{"rolled", text}, overrides));
}

data::SceneOverrides line_loads(double approach_lengths, const data::SceneOverrides& more = {}) {
  data::SceneOverrides all{{"method.kind", "line-loads"},
                           {"method.leading_elements", "5"},
                           {"method.approach_lengths", fmt::format("{}", approach_lengths)}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void check_same(const Solution& a, const Solution& b, double tolerance) {
  for (const char* name : {"contact_length", "rolling_resistance", "creep_ratio"}) {
    CAPTURE(name);
    CHECK(a[name].value == approx(b[name].value, tolerance));
  }
}

const std::string fluid =
    "prony; theta1_instantaneous = 1e-5; theta1_amplitudes = [8e-5]; theta1_rates = [0]; theta2_instantaneous = "
    "2.3076923076923077e-6; theta2_amplitudes = [1.8461538461538462e-5]; theta2_rates = [0]";
const std::string stiff_at_once = "operators; P = [2, 0.1]; Q = [5e4, 5e3]; Q_dilatation = [1.5e5, 1e4]; ";

}  // namespace

TEST_CASE("one solid in several notations makes one contact, the thesis's misprint another") {
  const Solution once = rolled();
  for (
      const char* notation :
      {// Viscosity = modulus * relaxation time; theta1 = 1/(2G), theta2 = 3/(6K + 2G) with K = 8G/3.
       "standard-linear-solid; shear_1 = 5.4375e4; shear_2 = 5.4375e4; bulk_1 = 1.45e5; bulk_2 = 1.45e5; "
       "shear_viscosity = 5.4375e3; bulk_viscosity = 1.45e4",
       "prony; theta1_instantaneous = 9.195402298850575e-06; theta1_amplitudes = [9.195402298850575e-05]; "
       "theta1_rates = [10.0]; theta2_instantaneous = 3.0651340996168583e-06; theta2_amplitudes = "
       "[3.0651340996168583e-05]; theta2_rates = [10.0]",
       // 1/G = (1/G1)(2 + tau p)/(1 + tau p).
       "operators; P = [2.0, 0.1]; Q = [5.4375e4, 5.4375e3]; P_dilatation = [2.0, 0.1]; Q_dilatation = [1.45e5, "
       "1.45e4]"})
    check_same(once, rolled(notation), 1e-9);
  // G = 5e4 p/(p + 8), K = 2e5 p/(p + 8)
  check_same(rolled(fluid),
             rolled("operators; P = [8, 1]; Q = [0, 5e4]; P_dilatation = [8, 1]; Q_dilatation = [0, 2e5]"),
             1e-9);
  // A solid that is rigid at once in dilatation is the limit of stiff ones.
  check_same(rolled(stiff_at_once + "P_dilatation = [1]"),
             rolled(stiff_at_once + "P_dilatation = [1, 1e-10]"), 1e-8);
  const Solution wrong = rolled("thesis-misprint; bulk = 1.45e5; relaxation_time = 0.1");
  CHECK(wrong["rolling_resistance"].value < 0.99 * once["rolling_resistance"].value);
}

TEST_CASE("line loads on a fluid and on what is stiff at once are near the continuous contact") {
  for (const std::string& material : {fluid, stiff_at_once + "P_dilatation = [1]"}) {
    for (const auto& result : rolled(material, line_loads(40)).results)
      CHECK(result.numbers.front().error < 0.2 * std::fabs(result.numbers.front().value));
  }
  CHECK_REFUSED(rolled(fluid, line_loads(40, {{"method.residue_terms", "200"}})),
                "method.residue_terms = 200: must be 0: the material is a fluid");
  std::string viscous = fluid;
  viscous.replace(viscous.find("[8e-5]"), 6, "[80]")
      .replace(viscous.find("[1.846"), 23, "[18.461538461538462]");
  CHECK_REFUSED(rolled(viscous, {{"contact.length", "0.1"}}), "material = ");
}

TEST_CASE("a started motion forgets its start, and says how far it is from the steady one") {
  const auto resistance = [](double approach) {
    return rolled("", line_loads(approach))["rolling_resistance"];
  };
  const auto early = resistance(2), late = resistance(60), later = resistance(120);
  CHECK(late.value == approx(later.value, 1e-12));
  CHECK(std::fabs(early.value - late.value) > 1e-5 * late.value);
  const double steady = rolled()["rolling_resistance"].value;
  for (const auto& estimate : {early, late})
    CHECK(estimate.error == doctest::Approx(std::fabs(estimate.value - steady)).epsilon(1e-2));
}

TEST_CASE("the number of trailing elements may be given or sought") {
  const auto with = [](const data::SceneOverrides& more) {
    data::SceneOverrides all = line_loads(30, more);
    all.insert(all.end(), {{"method.residue_terms", "200"},
                           {"wanted", R"(["leading_length", "trailing_length", "load"])"}});
    return rolled("", all);
  };
  const Solution sought = with({});
  const double ratio = sought["trailing_length"].value / sought["leading_length"].value;
  const double trailing = std::round(5 * ratio);
  CHECK(5 * ratio == doctest::Approx(trailing).epsilon(1e-12));
  CHECK(sought["load"].value == doctest::Approx(100).epsilon(1e-9));
  const Solution given = with({{"method.trailing_elements", fmt::format("{}", trailing)}});
  CHECK(given["leading_length"].value == approx(sought["leading_length"].value, 1e-12));
}
