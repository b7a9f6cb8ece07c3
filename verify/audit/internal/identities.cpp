#include <nipref/data/material/stiffness.hpp>
#include <nipref/data/scene/keys.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;

using data::Dimension;
using data::ResultId;

constexpr Dimension of_length{1, 0, 0}, of_stress{0, 1, 0};

const std::map<std::string_view, Dimension> result_units{
    {"length", of_length}, {"force/length", {1, 1, 0}}, {"force", {2, 1, 0}},  {"power/length", {2, 1, -1}},
    {"stress", of_stress}, {"1/stress", {0, -1, 0}},    {"speed", {1, 0, -1}}, {"1", {}},
    {"degree", {}}};

/// The factors by which lengths, stresses and times are multiplied.
struct Units {
  double length, stress, time;

  [[nodiscard]] double operator()(const Dimension& unit) const {
    return std::pow(length, unit.length) * std::pow(stress, unit.stress) * std::pow(time, unit.time);
  }
};

bool is_half_space(const DrawnScene& drawn) { return drawn.has("half_space.model"); }

/// Draws units for which every key's factor is a whole number, be it a stress or a compliance, a time or a rate.
Units draw_units(const DrawnScene& drawn, Random& random) {
  const auto odd = [&] { return 3 + 2 * static_cast<double>(random.index(4)); };
  const double a = odd(), b = odd(), c = odd();
  if (is_half_space(drawn)) return {a, b * c * c, a / c};
  if (drawn.has("material.model") && drawn.text("material.model") == "prony") return {a * b, 1 / b, 1 / c};
  return {a * c, b, c};
}

/// The product; nothing if the factor is not a whole number or the product is not exact.
std::optional<double> exact_product(double factor, double number) {
  const double whole = std::round(factor), product = whole * number;
  if (std::fabs(factor - whole) > 1e-9 || std::fma(whole, number, -product) != 0) return {};
  return product;
}

bool multiply(DrawnScene::Value& value, const Units& units, const data::SceneKey& key) {
  std::vector<double*> numbers;
  if (auto* number = std::get_if<double>(&value)) numbers.push_back(number);
  if (auto* list = std::get_if<std::vector<double>>(&value))
    for (double& number : *list) numbers.push_back(&number);
  Dimension power = key.dimension;
  for (double* const number : numbers) {
    const auto product = exact_product(units(power), *number);
    if (!product) return false;
    *number = *product;
    if (key.time_grows_along_list) ++power.time;
  }
  return true;
}

/// The estimate of a number that is computed from another one with up to two roundings.
Estimate rounded(double value, double error) { return {value, error + 0x1p-51 * std::fabs(value)}; }

std::optional<Variant> in_other_units(const DrawnScene& drawn, Random& random) {
  const Units units = draw_units(drawn, random);
  Variant variant{"units", drawn, [units](const data::SceneResult& what, const Estimate& number) {
                    const double factor = units(result_units.at(what.unit));
                    return rounded(number.value / factor, number.error / factor);
                  }};
  for (auto& [key, value] : variant.scene.keys()) {
    if (key == "profile.positions" && is_half_space(drawn) && !drawn.has("profile.direction"))
      continue;  // degrees
    if (!multiply(value, units, *data::find_scene_key(key))) return {};
  }
  return variant;
}

struct GivenPair {
  const char* found_key;
  ResultId found;
  const char* given_key;
  ResultId given;
  /// A bound of the ratio of the result's relative change to that of the given number.
  double condition;
};
constexpr std::array given_pairs{
    GivenPair{"contact.length", ResultId::load, "load.per_length", ResultId::contact_length, 1},
    GivenPair{"load.per_length", ResultId::contact_length, "contact.length", ResultId::load, 5},
    GivenPair{"contact.span_along", ResultId::normal_force, "load.normal_force", ResultId::span_along, 1},
    GivenPair{"load.normal_force", ResultId::span_along, "contact.span_along", ResultId::normal_force, 3}};

std::optional<Variant> given_back(const DrawnScene& drawn, const SceneSolution<Estimate>& solved) {
  for (const GivenPair& pair : given_pairs) {
    if (!drawn.has(pair.found_key)) continue;
    // With a traction or a given creep several loads may lead to the same contact length.
    const char* const traction = "traction.force_per_length";
    const bool rolls_freely = drawn.has(traction) && drawn.number(traction) == 0;
    if (pair.given == ResultId::load && drawn.has("friction.coefficient") && !rolls_freely) return {};
    const Estimate found = solved[pair.found];
    if (!(found.value > 0)) return {};
    const double more = pair.condition * found.error / found.value;
    Variant variant{"given back", drawn, [more](const data::SceneResult&, const Estimate& number) {
                      return rounded(number.value, number.error + more * std::fabs(number.value));
                    }};
    variant.scene.remove(pair.found_key);
    variant.scene.set(pair.given_key, found.value);
    variant.scene.set_wanted({pair.given});
    return variant;
  }
  return {};
}

std::optional<Variant> not_rolling(const DrawnScene& drawn) {
  if (!drawn.has("rolling.speed") || !drawn.has("material.young")) return {};
  Variant variant{"elastic limit", drawn};
  variant.scene.remove("rolling.speed");
  return variant;
}

std::vector<double> negated(std::vector<double> numbers) {
  for (double& number : numbers) number = -number;
  return numbers;
}

/// The stiffness C_kl with the axis x2 reversed: entries with exactly one index that is 4 or 6 change their sign.
std::vector<double> mirrored_stiffness(std::vector<double> upper) {
  for (std::size_t n = 0; n < upper.size(); ++n) {
    const auto [i, k] = data::upper_triangle[n];
    if ((i == 3 || i == 5) != (k == 3 || k == 5)) upper[n] = -upper[n];
  }
  return upper;
}

std::optional<Variant> mirrored(const DrawnScene& drawn) {
  // With memory or Coulomb's friction a nip has a leading end.
  if ((drawn.has("rolling.speed") && !is_half_space(drawn)) || drawn.has("friction.coefficient")) return {};
  const std::vector<ResultId> odd =
      is_half_space(drawn)
          ? std::vector{ResultId::transverse_displacement, ResultId::orientation, ResultId::centre_across}
          : std::vector{ResultId::shear, ResultId::tangential_displacement, ResultId::stress_shear,
                        ResultId::displacement_along};
  Variant variant{"mirror", drawn, [odd](const data::SceneResult& what, const Estimate& number) {
                    const bool is_odd = std::ranges::find(odd, what.id) != odd.end();
                    return Estimate{is_odd ? -number.value : number.value, number.error};
                  }};
  const bool on_line = drawn.has("profile.direction");
  for (const char* const angle : {"profile.direction", "sliding.direction"})
    if (drawn.has(angle)) variant.scene.set(angle, -drawn.number(angle));
  for (const char* const places : {"profile.positions", "field.positions"})
    if (drawn.has(places) && !on_line) variant.scene.set(places, negated(drawn.numbers(places)));
  if (drawn.has("half_space.stiffness"))
    variant.scene.set("half_space.stiffness", mirrored_stiffness(drawn.numbers("half_space.stiffness")));
  return variant;
}

std::optional<Variant> turned_motion(const DrawnScene& drawn, Random& random) {
  if (!drawn.has("sliding.direction")) return {};
  if (drawn.has("half_space.axis") && drawn.text("half_space.axis") != "normal") return {};
  if (drawn.has("half_space.stiffness")) return {};
  const double from = drawn.number("sliding.direction"), to = random.uniform(-90, 90);
  Variant variant{"turned", drawn, [turn = from - to](const data::SceneResult& what, const Estimate& number) {
                    if (what.id != data::ResultId::orientation) return number;
                    return Estimate{number.value + turn, number.error + 0x1p-51 * 180};
                  }};
  variant.scene.set("sliding.direction", to);
  return variant;
}

std::optional<Variant> as_transversely_isotropic(const DrawnScene& drawn, Random& random) {
  if (!is_half_space(drawn) || drawn.has("rolling_sphere.radius")) return {};
  if (drawn.text("half_space.model") != "isotropic") return {};
  const double shear = drawn.number("half_space.shear"), poisson = drawn.number("half_space.poisson");
  const double lame = 2 * shear * poisson / (1 - 2 * poisson), stiff = lame + 2 * shear;
  const bool is_exact = std::fma(lame, 1 - 2 * poisson, -2 * shear * poisson) == 0 &&
                        std::fma(shear, poisson, -(shear * poisson)) == 0 && stiff - lame == 2 * shear &&
                        stiff - 2 * shear == lame;
  if (!is_exact) return {};
  Variant variant{"isotropic limit", drawn};
  variant.scene.remove("half_space.shear");
  variant.scene.remove("half_space.poisson");
  variant.scene.set("half_space.model", "transversely-isotropic");
  variant.scene.set("half_space.axis", random.chance(0.5) ? "normal" : "in-plane");
  for (const auto& [key, modulus] :
       {std::pair("c11", stiff), {"c33", stiff}, {"c13", lame}, {"c44", shear}, {"c66", shear}})
    variant.scene.set(fmt::format("half_space.{}", key), modulus);
  return variant;
}

}  // namespace

std::vector<Variant> variants_of(const DrawnScene& drawn, const SceneSolution<Estimate>& solved,
                                 Random& random) {
  std::vector<Variant> variants;
  for (const auto& variant :
       {in_other_units(drawn, random), given_back(drawn, solved), not_rolling(drawn), mirrored(drawn),
        turned_motion(drawn, random), as_transversely_isotropic(drawn, random)}) {
    if (variant) variants.push_back(*variant);
  }
  return variants;
}

}  // namespace nipref::verify
