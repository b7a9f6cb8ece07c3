// What a viscoelastic material answers.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/material/moduli.hpp>
#include <nipref/fast/material/rational_solid.hpp>
#include <nipref/ref/material/moduli.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/material/internal/rational_arguments.hpp>
#include <nipref/verify/catalogue/ulp.hpp>

namespace nipref::verify {
namespace {

using data::SpringModel;
using Exacts = std::span<const ref::Exact>;
using MaterialArguments = std::span<const double>;

constexpr double material_promise = 8, theta2_promise = 32;
/// Springs and dashpots first, in the order of SpringModel's below.
constexpr std::array<std::string_view, 7> models{
    "standard-linear-solid", "kelvin-voigt", "maxwell", "elastic", "prony", "operators", "thesis-misprint"};
constexpr std::array<SpringModel, 4> of_springs{SpringModel::standard_linear, SpringModel::kelvin_voigt,
                                                SpringModel::maxwell, SpringModel::elastic};
constexpr std::size_t prony_model = 4, operators_model = 5, thesis_model = 6;

std::size_t model_number(double argument) { return static_cast<std::size_t>(argument); }
SpringModel model_of(double argument) { return of_springs[model_number(argument)]; }
bool is_of_springs(double argument) { return model_number(argument) < of_springs.size(); }

// Arguments: t or omega, material, shear, shear_2, shear_viscosity, bulk, bulk_2, bulk_viscosity, relaxation_time, the series, the
// operators.
constexpr std::size_t shear_at = 2, bulk_at = 5, tau_at = 8, prony_at = 9,
                      operators_at = prony_at + prony_arguments;

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

fast::RationalSolid rational_solid(MaterialArguments x) {
  if (model_number(x[1]) == prony_model) return prony_of(x.subspan(prony_at, prony_arguments));
  if (model_number(x[1]) == operators_model) return operators_of(x.subspan(operators_at, operator_arguments));
  return data::SingleRelaxationTimeSolid{x[bulk_at], x[shear_at], x[tau_at], data::misprinted_rate_factor};
}

ref::ExactRationalSolid exact_rational_solid(Exacts x) {
  const std::size_t model = model_number(x[1].approximate());
  if (model == prony_model) return exact_prony_of(x.subspan(prony_at, prony_arguments));
  if (model == operators_model) return exact_operators_of(x.subspan(operators_at, operator_arguments));
  return ref::exact_single_time(x[bulk_at], x[shear_at], x[tau_at], data::misprinted_rate_factor);
}

void append_modulus(std::vector<Argument>& arguments, const std::string& name, const char* spring) {
  arguments.push_back({name, ArgumentKind::positive, spring, {}});
  arguments.push_back({name + "_2", ArgumentKind::positive, spring, {}});
  arguments.push_back({name + "_viscosity", ArgumentKind::positive, spring, {}});
}

/// What each of the models has, named as in a scene where scenes have the model.
std::vector<std::vector<ModelKey>> keys_of_models() {
  std::vector<ModelKey> standard =
      keys_of_numbers({"shear", "shear_2", "shear_viscosity", "bulk", "bulk_2", "bulk_viscosity"});
  standard[0].name = "shear_1";
  standard[3].name = "bulk_1";
  const auto damped = keys_of_numbers({"shear", "shear_viscosity", "bulk", "bulk_viscosity"});
  return {std::move(standard),
          damped,
          damped,
          keys_of_numbers({"shear", "bulk"}),
          prony_keys(),
          operator_keys(),
          keys_of_numbers({"bulk", "shear", "relaxation_time"})};
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
  Point x{variable,
          static_cast<double>(random.index(models.size())),
          shear,
          shear_2,
          shear_2 * time,
          bulk,
          bulk_2,
          bulk_2 * time * times(1e6),
          time};
  draw_prony(x, 1 / shear, time, random);
  draw_operators(x, shear, time, random);
  return x;
}

/// About the fastest rate there is.
double fastest_rate(const Point& x) {
  const std::size_t model = model_number(x[1]);
  if (model == thesis_model) return 2 / x[tau_at];
  if (model == prony_model)
    return std::max({x[prony_at + 2], x[prony_at + 4], x[prony_at + 7], x[prony_at + 9]});
  if (model < of_springs.size()) return (x[2] + x[3]) / x[4] + (x[5] + x[6]) / x[7];
  double fastest = 0;
  for (std::size_t k = operators_at; k + 1 < x.size(); ++k) {
    const bool of_one_polynomial = (k - operators_at) % 3 != 2;
    if (of_one_polynomial && x[k + 1] > 0) fastest += x[k] / x[k + 1];
  }
  return fastest;
}

/// Not so long after that what is left is no number of the reference's any more.
void keep_remembered(Point& x) {
  const double fastest = fastest_rate(x);
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
  entry.arguments = {{variable, kind, {}, {}},
                     {"material",
                      ArgumentKind::choice,
                      "standard-linear-solid",
                      {},
                      {models.begin(), models.end()},
                      keys_of_models()}};
  append_modulus(entry.arguments, "shear", "0.375");
  append_modulus(entry.arguments, "bulk", "1");
  entry.arguments.push_back({"relaxation_time", ArgumentKind::positive, "1", {}});
  append_prony_arguments(entry.arguments);
  append_operator_arguments(entry.arguments);
  entry.draw = [arguments = entry.arguments](Random& random) {
    Point x = draw_material(random);
    default_unread(x, arguments);
    return x;
  };
  if (kind == ArgumentKind::time) entry.keep_off = keep_remembered;
  entry.audit_points = 1000;
  entry.is_costly = true;
  return entry;
}

constexpr auto faded_scale = "each fading term times 1 + its rate times t";

/// Evaluators: of springs, and of a rational solid, which is good to a unit in the last place.
template <class SpringsFast, class SpringsRef, class RationalFast, class RationalRef>
void set_evaluators(Quantity& entry, SpringsFast springs, SpringsRef exact_springs, RationalFast rational,
                    RationalRef exact_rational) {
  const auto found = [=](MaterialArguments x) -> fast::Fading {
    return is_of_springs(x[1]) ? springs(x) : rational(rational_solid(x), x[0]);
  };
  set_fast(entry, [found](MaterialArguments x, fast::Accuracy) { return found(x).value; });
  entry.envelope = [found](MaterialArguments x) { return found(x).size; };
  entry.fast_error = [found, promise = entry.promise](MaterialArguments x, fast::Accuracy) {
    const auto [value, size] = found(x);
    return (is_of_springs(x[1]) ? promise : 1) * ulp_of(std::max(std::fabs(value), size));
  };
  entry.by_ref = [=](Exacts x, int digits) {
    return is_of_springs(x[1].approximate()) ? exact_springs(x, digits)
                                             : exact_rational(exact_rational_solid(x), x[0], digits);
  };
}

/// The two of one modulus.
struct OfOneModulus {
  std::size_t at;
  const char* argument;
  fast::Strain strain;

  [[nodiscard]] fast::Modulus in(MaterialArguments x) const { return modulus_at(x, at, argument); }
  [[nodiscard]] ref::ExactModulus in(Exacts x) const { return exact_modulus_at(x, at, argument); }
  [[nodiscard]] const ref::ExactRatio& in(const ref::ExactRationalSolid& solid) const {
    return strain == fast::Strain::shear ? solid.shear : solid.dilatation;
  }
};

Quantity relaxation_entry(const char* letter, OfOneModulus of, const char* what) {
  Quantity entry =
      material_entry(std::string("material.") + letter,
                     std::string("relaxation modulus in ") + what +
                         ": stress under a unit of strain since t ago, beside a dashpot's impulse",
                     "thesis 6.12-6.15, AIII.1-AIII.8", "t");
  entry.unit = "unit of shear";
  entry.scale = faded_scale;
  set_evaluators(
      entry, [of](MaterialArguments x) { return fast::relaxation(of.in(x), x[0]); },
      [of](Exacts x, int digits) { return ref::relaxation(of.in(x), x[0], digits); },
      [of](const fast::RationalSolid& solid, double t) { return fast::relaxation(solid, of.strain, t); },
      [of](const ref::ExactRationalSolid& solid, const ref::Exact& t, int digits) {
        return ref::relaxation(of.in(solid), t, digits);
      });
  return entry;
}

Quantity creep_entry(const char* name, OfOneModulus of, const char* what) {
  Quantity entry = material_entry(
      name, std::string("creep compliance in ") + what + ": strain under a unit of stress since t ago",
      "thesis figure 32b, 6.12-6.15", "t");
  entry.unit = "1/unit of shear";
  set_evaluators(
      entry,
      [of](MaterialArguments x) -> fast::Fading {
        return {fast::creep(of.in(x), x[0]), 0};
      },
      [of](Exacts x, int digits) { return ref::creep(of.in(x), x[0], digits); },
      [of](const fast::RationalSolid& solid, double t) { return fast::creep(solid, of.strain, t); },
      [of](const ref::ExactRationalSolid& solid, const ref::Exact& t, int digits) {
        return ref::creep(of.in(solid), t, digits);
      });
  return entry;
}

/// Storage or loss, by the overloads of that name.
#define NIPREF_CYCLIC(function)                                                         \
  [of](MaterialArguments x) -> fast::Fading {                                           \
    return {fast::function(of.in(x), x[0]), 0};                                         \
  },                                                                                    \
      [of](Exacts x, int digits) { return ref::function(of.in(x), x[0], digits); },     \
      [of](const fast::RationalSolid& solid, double omega) {                            \
        return fast::function(solid, of.strain, omega);                                 \
      },                                                                                \
      [of](const ref::ExactRationalSolid& solid, const ref::Exact& omega, int digits) { \
        return ref::function(of.in(solid), omega, digits);                              \
      }

Quantity cyclic_entry(const char* name, const char* definition, OfOneModulus of, bool loses) {
  Quantity entry = material_entry(name, definition, "thesis 6.12 at p = i omega", "omega");
  entry.unit = "unit of shear";
  if (loses) {
    set_evaluators(entry, NIPREF_CYCLIC(loss));
  } else {
    set_evaluators(entry, NIPREF_CYCLIC(storage));
  }
  entry.draw = [draw = entry.draw](Random& random) {
    Point x = draw(random);
    if (x[0] != 0) x[0] = 1 / x[0];
    return x;
  };
  return entry;
}

Quantity theta1_entry() {
  Quantity entry =
      material_entry("material.theta1",
                     "1/(2G) as a function of time beside its impulse: strain t after an impulse of stress",
                     "thesis 6.16, 6.17, AIII.10", "t");
  entry.unit = "1/(unit of shear time)";
  entry.scale = faded_scale;
  set_evaluators(
      entry, [](MaterialArguments x) { return fast::theta1(shear_of(x), x[0]); },
      [](Exacts x, int digits) { return ref::theta1(exact_shear_of(x), x[0], digits); },
      [](const fast::RationalSolid& solid, double t) { return fast::theta1(solid, t); },
      [](const ref::ExactRationalSolid& solid, const ref::Exact& t, int digits) {
        return ref::fading_part(solid.theta1, t, digits);
      });
  return entry;
}

Quantity theta2_entry() {
  Quantity entry =
      material_entry("material.theta2", "3/(6K + 2G) as a function of time beside its impulse: as theta1",
                     "thesis 6.16, 6.17, AIII.11", "t");
  entry.unit = "1/(unit of shear time)";
  entry.scale = faded_scale;
  entry.promise = theta2_promise;
  set_evaluators(
      entry, [](MaterialArguments x) { return fast::theta2(shear_of(x), bulk_of(x), x[0]); },
      [](Exacts x, int digits) { return ref::theta2(exact_shear_of(x), exact_bulk_of(x), x[0], digits); },
      [](const fast::RationalSolid& solid, double t) { return fast::theta2(solid, t); },
      [](const ref::ExactRationalSolid& solid, const ref::Exact& t, int digits) {
        return ref::fading_part(solid.theta2, t, digits);
      });
  return entry;
}

}  // namespace

std::vector<Quantity> material_entries() {
  constexpr OfOneModulus in_shear{shear_at, "shear", fast::Strain::shear},
      in_dilatation{bulk_at, "bulk", fast::Strain::dilatation};
  return {
      theta1_entry(),
      theta2_entry(),
      relaxation_entry("G", in_shear, "shear"),
      relaxation_entry("K", in_dilatation, "dilatation"),
      creep_entry("material.creep_shear", in_shear, "shear"),
      creep_entry("material.creep_bulk", in_dilatation, "dilatation"),
      cyclic_entry("material.storage_shear", "storage modulus in shear, Re G(i omega)", in_shear, false),
      cyclic_entry("material.storage_bulk", "storage modulus in dilatation, Re K(i omega)", in_dilatation,
                   false),
      cyclic_entry("material.loss_shear", "loss modulus in shear, Im G(i omega)", in_shear, true),
      cyclic_entry("material.loss_bulk", "loss modulus in dilatation, Im K(i omega)", in_dilatation, true)};
}

}  // namespace nipref::verify
