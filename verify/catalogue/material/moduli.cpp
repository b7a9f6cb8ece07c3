// What a viscoelastic material answers.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <nipref/fast/material/moduli.hpp>
#include <nipref/ref/material/moduli.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::SpringModel;
using Exacts = std::span<const ref::Exact>;
using MaterialArguments = std::span<const double>;

constexpr double material_promise = 8, theta2_promise = 32;
constexpr std::array<std::string_view, 4> models{"standard-linear-solid", "kelvin-voigt", "maxwell",
                                                 "elastic"};

SpringModel model_of(double number) {
  constexpr std::array<SpringModel, 4> known{SpringModel::standard_linear, SpringModel::kelvin_voigt,
                                             SpringModel::maxwell, SpringModel::elastic};
  return known[static_cast<std::size_t>(number)];
}

// Arguments: t or omega, material, shear, shear_2, shear_viscosity, bulk, bulk_2, bulk_viscosity.
constexpr std::size_t shear_at = 2, bulk_at = 5;

fast::Modulus modulus_at(MaterialArguments x, std::size_t at, const char* name) {
  const fast::Modulus modulus{model_of(x[1]), x[at], x[at + 1], x[at + 2]};
  modulus.check(name);
  return modulus;
}
fast::Modulus shear_of(MaterialArguments x) { return modulus_at(x, shear_at, "shear"); }
fast::Modulus bulk_of(MaterialArguments x) { return modulus_at(x, bulk_at, "bulk"); }

ref::ExactModulus exact_modulus_at(Exacts x, std::size_t at, const char* name) {
  const ref::ExactModulus modulus{model_of(x[1].approximate()), x[at], x[at + 1], x[at + 2]};
  modulus.check(name);
  return modulus;
}
ref::ExactModulus exact_shear_of(Exacts x) { return exact_modulus_at(x, shear_at, "shear"); }
ref::ExactModulus exact_bulk_of(Exacts x) { return exact_modulus_at(x, bulk_at, "bulk"); }

void append_modulus(std::vector<Argument>& arguments, const std::string& name, const char* spring) {
  arguments.push_back({name, ArgumentKind::positive, spring, {}});
  arguments.push_back({name + "_2", ArgumentKind::positive, spring, {}});
  arguments.push_back({name + "_viscosity", ArgumentKind::positive, spring, {}});
}

/// Springs and times far apart or alike; `variable` is t, or 1/omega.
Point draw_material(Random& random) {
  const double time = random.log_uniform(1e-8, 1e8);
  const auto times = [&](double factor) {
    return random.chance(0.3) ? 1.0 : random.log_uniform(1 / factor, factor);
  };
  const double variable =
      random.chance(0.05) ? 0 : time * random.log_uniform(1e-12, random.chance(0.1) ? 1e7 : 1e3);
  const double shear = random.log_uniform(1e-6, 1e12), shear_2 = shear * times(1e10),
               bulk = shear * times(1e10);
  const double bulk_2 = bulk * times(1e10);
  return {variable,       static_cast<double>(random.index(models.size())),
          shear,          shear_2,
          shear_2 * time, bulk,
          bulk_2,         bulk_2 * time * times(1e6)};
}

/// Not so long after that what is left is no number of the reference's any more.
void keep_remembered(Point& x) {
  const double fastest = (x[2] + x[3]) / x[4] + (x[5] + x[6]) / x[7];
  if (x[0] * fastest > 1e8) x[0] = 1e8 / fastest;
}

Quantity material_entry(std::string name, std::string definition, std::string source, const char* variable) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = std::move(source);
  entry.scale = "the value";
  entry.promise = material_promise;
  const ArgumentKind kind = std::string_view(variable) == "t" ? ArgumentKind::time : ArgumentKind::rate;
  entry.arguments = {
      {variable, kind, {}, {}},
      {"material", ArgumentKind::choice, "standard-linear-solid", {}, {models.begin(), models.end()}}};
  append_modulus(entry.arguments, "shear", "0.375");
  append_modulus(entry.arguments, "bulk", "1");
  entry.draw = draw_material;
  if (kind == ArgumentKind::time) entry.keep_off = keep_remembered;
  entry.envelope = [](MaterialArguments) { return 0.0; };
  entry.audit_points = 1000;
  entry.timed_alone = false;
  return entry;
}

constexpr auto faded_scale = "each fading term times 1 + its rate times t";

/// The two of one modulus.
struct OfOneModulus {
  std::size_t at;
  const char* argument;
};

Quantity relaxation_entry(const char* letter, OfOneModulus of, const char* what) {
  Quantity entry =
      material_entry(std::string("material.") + letter,
                     std::string("relaxation modulus in ") + what +
                         ": stress under a unit of strain since t ago, beside a dashpot's impulse",
                     "thesis 6.12, AIII.1-AIII.8", "t");
  entry.unit = "unit of shear";
  entry.scale = faded_scale;
  entry.by_ref = [of](Exacts x, int digits) {
    return ref::relaxation(exact_modulus_at(x, of.at, of.argument), x[0], digits);
  };
  set_fast(entry, [of](MaterialArguments x, fast::Accuracy) {
    return fast::relaxation(modulus_at(x, of.at, of.argument), x[0]).value;
  });
  entry.envelope = [of](MaterialArguments x) {
    return fast::relaxation(modulus_at(x, of.at, of.argument), x[0]).size;
  };
  return entry;
}

Quantity creep_entry(const char* name, OfOneModulus of, const char* what) {
  Quantity entry = material_entry(
      name, std::string("creep compliance in ") + what + ": strain under a unit of stress since t ago",
      "thesis figure 32b", "t");
  entry.unit = "1/unit of shear";
  entry.by_ref = [of](Exacts x, int digits) {
    return ref::creep(exact_modulus_at(x, of.at, of.argument), x[0], digits);
  };
  set_fast(entry, [of](MaterialArguments x, fast::Accuracy) {
    return fast::creep(modulus_at(x, of.at, of.argument), x[0]);
  });
  return entry;
}

Quantity cyclic_entry(const char* name, const char* definition, OfOneModulus of,
                      double (*by_fast)(const fast::Modulus&, double),
                      ref::Enclosure (*by_ref)(const ref::ExactModulus&, const ref::Exact&, int)) {
  Quantity entry = material_entry(name, definition, "thesis 6.12 at p = i omega", "omega");
  entry.unit = "unit of shear";
  entry.by_ref = [=](Exacts x, int digits) {
    return by_ref(exact_modulus_at(x, of.at, of.argument), x[0], digits);
  };
  set_fast(entry, [=](MaterialArguments x, fast::Accuracy) {
    return by_fast(modulus_at(x, of.at, of.argument), x[0]);
  });
  entry.draw = [](Random& random) {
    Point x = draw_material(random);
    if (x[0] != 0) x[0] = 1 / x[0];
    return x;
  };
  return entry;
}

Quantity theta1_entry() {
  Quantity entry =
      material_entry("material.theta1",
                     "1/(2G) as a function of time beside its impulse: strain t after an impulse of stress",
                     "thesis 6.16, AIII.10", "t");
  entry.unit = "1/(unit of shear time)";
  entry.scale = faded_scale;
  entry.by_ref = [](Exacts x, int digits) { return ref::theta1(exact_shear_of(x), x[0], digits); };
  set_fast(entry, [](MaterialArguments x, fast::Accuracy) { return fast::theta1(shear_of(x), x[0]).value; });
  entry.envelope = [](MaterialArguments x) { return fast::theta1(shear_of(x), x[0]).size; };
  return entry;
}

Quantity theta2_entry() {
  Quantity entry =
      material_entry("material.theta2", "3/(6K + 2G) as a function of time beside its impulse: as theta1",
                     "thesis 6.17, AIII.11", "t");
  entry.unit = "1/(unit of shear time)";
  entry.scale = faded_scale;
  entry.promise = theta2_promise;
  entry.by_ref = [](Exacts x, int digits) {
    return ref::theta2(exact_shear_of(x), exact_bulk_of(x), x[0], digits);
  };
  set_fast(entry, [](MaterialArguments x, fast::Accuracy) {
    return fast::theta2(shear_of(x), bulk_of(x), x[0]).value;
  });
  entry.envelope = [](MaterialArguments x) { return fast::theta2(shear_of(x), bulk_of(x), x[0]).size; };
  return entry;
}

}  // namespace

std::vector<Quantity> material_entries() {
  constexpr OfOneModulus in_shear{shear_at, "shear"}, in_dilatation{bulk_at, "bulk"};
  return {theta1_entry(),
          theta2_entry(),
          relaxation_entry("G", in_shear, "shear"),
          relaxation_entry("K", in_dilatation, "dilatation"),
          creep_entry("material.creep_shear", in_shear, "shear"),
          creep_entry("material.creep_bulk", in_dilatation, "dilatation"),
          cyclic_entry("material.storage_shear", "storage modulus in shear, Re G(i omega)", in_shear,
                       fast::storage, ref::storage),
          cyclic_entry("material.storage_bulk", "storage modulus in dilatation, Re K(i omega)", in_dilatation,
                       fast::storage, ref::storage),
          cyclic_entry("material.loss_shear", "loss modulus in shear, Im G(i omega)", in_shear, fast::loss,
                       ref::loss),
          cyclic_entry("material.loss_bulk", "loss modulus in dilatation, Im K(i omega)", in_dilatation,
                       fast::loss, ref::loss)};
}

}  // namespace nipref::verify
