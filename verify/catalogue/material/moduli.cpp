// The response functions of a viscoelastic material.
#include <complex>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/material/moduli.hpp>
#include <nipref/fast/material/rational_solid.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/material/relaxation_terms.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/material/internal/rational_arguments.hpp>

namespace nipref::verify {
namespace {

using data::SpringModel;
using ref::Exact;

// The models in the order of quantities.toml.
constexpr std::array<SpringModel, 4> of_springs{SpringModel::standard_linear, SpringModel::kelvin_voigt,
                                                SpringModel::maxwell, SpringModel::elastic};
constexpr std::size_t prony_model = 4, operators_model = 5, thesis_model = 6;
/// The last model, the standard linear solid with one relaxation time, is not drawn: it is a special case of the first.
constexpr std::size_t drawn_models = 7;

std::size_t model_of(const auto& x) { return x.choice("material"); }
bool is_of_springs(std::size_t model) { return model < of_springs.size(); }
int theta2_rate_factor(std::size_t model) { return model == thesis_model ? data::misprinted_rate_factor : 1; }

/// The moduli of springs and dashpots; name: shear or bulk.
fast::Modulus modulus_in(const NamedPoint& x, const std::string& name) {
  const fast::Modulus modulus{of_springs[model_of(x)], x[name], x[name + "_2"], x[name + "_viscosity"]};
  modulus.check(name.c_str());
  return modulus;
}
ref::ExactRatio modulus_in(const NamedExact& x, const std::string& name) {
  return ref::exact_modulus(of_springs[model_of(x)], x[name], x[name + "_2"], x[name + "_viscosity"], name);
}

fast::RationalSolid rational_solid(const NamedPoint& x) {
  if (model_of(x) == prony_model) return prony_of(x);
  if (model_of(x) == operators_model) return operators_of(x);
  return data::SingleRelaxationTimeSolid{x["bulk"], x["shear"], x["relaxation_time"],
                                         theta2_rate_factor(model_of(x))};
}

ref::ExactRationalSolid exact_solid_of(const NamedExact& x) {
  if (is_of_springs(model_of(x))) return ref::exact_moduli(modulus_in(x, "shear"), modulus_in(x, "bulk"));
  if (model_of(x) == prony_model) return exact_prony_of(x);
  if (model_of(x) == operators_model) return exact_operators_of(x);
  return ref::exact_single_time(x["bulk"], x["shear"], x["relaxation_time"], theta2_rate_factor(model_of(x)));
}

/// Draws springs and relaxation times that are alike or far apart, of the order of the time that it returns.
double draw_material(Random& random, const NamedNumbers& x) {
  const double time = random.log_uniform(1e-8, 1e8);
  const auto times = [&](double factor) {
    return random.chance(0.3) ? 1.0 : random.log_uniform(1 / factor, factor);
  };
  const double shear = x["shear"] = random.log_uniform(1e-6, 1e12);
  x["shear_2"] = shear * times(1e10);
  x["bulk"] = shear * times(1e10);
  x["bulk_2"] = x["bulk"] * times(1e10);
  x["material"] = static_cast<double>(random.index(drawn_models));
  x["shear_viscosity"] = x["shear_2"] * time;
  x["bulk_viscosity"] = x["bulk_2"] * time * times(1e6);
  x["relaxation_time"] = time;
  draw_prony(x, 1 / shear, time, random);
  draw_operators(x, shear, time, random);
  default_unread(x);
  return time;
}

/// The same with a value for `variable`: "t", or "omega" or "p", which is drawn as 1/t.
void draw_material(Random& random, const NamedNumbers& x, const char* variable) {
  const double time = draw_material(random, x);
  const double t = random.chance(0.05) ? 0 : time * random.log_uniform(1e-12, random.chance(0.1) ? 1e7 : 1e3);
  x[variable] = variable != std::string_view("t") && t != 0 ? 1 / t : t;
}

/// The order of magnitude of the material's fastest rate.
double fastest_rate(const NamedPoint& x) {
  const std::size_t model = model_of(x);
  if (model >= thesis_model) return 2 / x["relaxation_time"];
  if (model == prony_model)
    return std::max(std::ranges::max(x.list("theta1_rate")), std::ranges::max(x.list("theta2_rate")));
  if (is_of_springs(model))
    return (x["shear"] + x["shear_2"]) / x["shear_viscosity"] +
           (x["bulk"] + x["bulk_2"]) / x["bulk_viscosity"];
  double fastest = 0;
  const data::DifferentialOperators operators = operators_of(x);
  for (const auto& polynomial : {operators.p, operators.q, operators.p_dilatation, operators.q_dilatation}) {
    for (std::size_t k = 0; k + 1 < polynomial.size(); ++k)
      if (polynomial[k + 1] > 0) fastest += polynomial[k] / polynomial[k + 1];
  }
  return fastest;
}

/// Sets the error that fast states for the value and size that `found` gives: one unit in the last place of the size
/// for rational solids, the promise for springs and dashpots.
void set_fast_error(Quantity& entry, auto found) {
  entry.fast_error = of_point(entry, [found, promise = entry.promise](const NamedPoint& x) {
    const auto [value, size] = found(x);
    return (is_of_springs(model_of(x)) ? promise : 1) * ulp_of(std::max(std::fabs(value), size));
  });
}

/// An entry by functions of fast for springs and dashpots and for a rational solid, and by ref's for an exact solid.
/// variable: t or omega.
template <class Springs, class Rational, class OfExact>
Quantity material_entry(const char* name, const char* variable, Springs springs, Rational rational,
                        OfExact of_exact) {
  const auto found = [=](const NamedPoint& x) -> fast::Fading {
    if (!is_of_springs(model_of(x))) return rational(rational_solid(x), x[variable]);
    return springs(x, x[variable]);
  };
  Quantity entry = entry_of(
      name, [=](const NamedExact& x, int digits) { return of_exact(exact_solid_of(x), x[variable], digits); },
      [found](const NamedPoint& x) { return found(x).value; },
      [found](const NamedPoint& x) { return found(x).size; });
  set_fast_error(entry, found);
  const auto draw = [variable](Random& random, const NamedNumbers& x) { draw_material(random, x, variable); };
  if (variable != std::string_view("t")) return sampled(entry, draw);
  // At later times the value is below the least number of the reference.
  return sampled(entry, draw, [](const NamedNumbers& x) {
    const double fastest = fastest_rate(x);
    if (x["t"] * fastest > 1e8) x["t"] = 1e8 / fastest;
  });
}

fast::Fading unfaded(double value) { return {value, 0}; }
fast::Fading unfaded(const fast::Fading& value) { return value; }

/// A response function of one modulus. `function` calls fast's or the reference's function of that name by overloading:
/// relaxation, creep, storage or loss. modulus: shear or bulk.
template <class Function>
Quantity modulus_entry(const char* name, const char* variable, const char* modulus, Function function) {
  const bool is_shear = modulus == std::string_view("shear");
  return material_entry(
      name, variable,
      [=](const NamedPoint& x, double at) { return unfaded(function(modulus_in(x, modulus), at)); },
      [=](const fast::RationalSolid& solid, double at) {
        return function(solid, is_shear ? fast::Strain::shear : fast::Strain::dilatation, at);
      },
      [=](const ref::ExactRationalSolid& solid, const Exact& at, int digits) {
        return function(is_shear ? solid.shear : solid.dilatation, at, digits);
      });
}

/// theta1 or theta2 without its impulse.
template <class Springs>
Quantity theta_entry(const char* name, Springs springs,
                     fast::Fading (*rational)(const fast::RationalSolid&, double),
                     ref::ExactRatio ref::ExactRationalSolid::*theta) {
  return material_entry(name, "t", springs, rational,
                        [=](const ref::ExactRationalSolid& solid, const Exact& t, int digits) {
                          return ref::fading_part(solid.*theta, t, digits);
                        });
}

ref::ComplexPart part_of(const NamedExact& x) {
  return x["part"].sign() == 0 ? ref::ComplexPart::re : ref::ComplexPart::im;
}

/// G or K at p + i omega.
Quantity growth_entry(const char* name, bool is_shear) {
  const auto part = [is_shear](const NamedPoint& x, bool imaginary) -> fast::Fading {
    if (!is_of_springs(model_of(x)))
      return fast::modulus_at(rational_solid(x), is_shear ? fast::Strain::shear : fast::Strain::dilatation,
                              x["p"], x["omega"], imaginary);
    const std::complex<double> value =
        fast::modulus_at(modulus_in(x, is_shear ? "shear" : "bulk"), x["p"], x["omega"]);
    return {imaginary ? value.imag() : value.real(), std::abs(value)};
  };
  const auto size = [part](const NamedPoint& x) {
    return std::hypot(part(x, false).value, part(x, true).value);
  };
  Quantity entry = entry_of(
      name,
      [=](const NamedExact& x, int digits) {
        const ref::ExactRationalSolid solid = exact_solid_of(x);
        return ref::modulus_at(is_shear ? solid.shear : solid.dilatation, x["p"], x["omega"], part_of(x),
                               digits);
      },
      [part](const NamedPoint& x) { return part(x, x["part"] != 0).value; }, size);
  set_fast_error(entry, [part](const NamedPoint& x) { return part(x, x["part"] != 0); });
  return sampled(entry, [](Random& random, const NamedNumbers& x) {
    draw_material(random, x, "p");
    x["omega"] = random.chance(0.3) ? 0 : std::max(x["p"], 1e-8) * random.log_uniform(1e-6, 1e6);
    if (x["omega"] != 0 && random.chance(0.2)) x["p"] = 0;
    x["part"] = static_cast<double>(random.index(2));
  });
}

/// theta1 or theta2 of the point, its terms in the order of their rates.
data::MaterialFunction terms_of(const NamedPoint& x) {
  const data::MaterialFunctions both =
      is_of_springs(model_of(x)) ? fast::material_functions(modulus_in(x, "shear"), modulus_in(x, "bulk"))
                                 : fast::material_functions(rational_solid(x));
  data::MaterialFunction theta = x["of"] == 0 ? both.theta1 : both.theta2;
  std::ranges::sort(theta.terms, {}, [](const data::RelaxationTerm& term) {
    return std::pair(term.rate.real(), term.rate.imag());
  });
  return theta;
}

int whole_term(double number) {
  if (number != std::floor(number) || number > 1e6)
    throw data::BadInput("term", number, "must be a whole number, that of a term");
  return static_cast<int>(number);
}

std::complex<double> number_of_term(const NamedPoint& x, bool amplitude) {
  const data::MaterialFunction theta = terms_of(x);
  const int number = whole_term(x["term"]), last = static_cast<int>(theta.terms.size());
  if (amplitude && number == 0) return theta.instantaneous;
  if (number < 1 || number > last)
    throw data::BadInput("term", number, "must be at most " + std::to_string(last) + ", the number of terms");
  const data::RelaxationTerm& term = theta.terms[static_cast<std::size_t>(number - 1)];
  return amplitude ? term.amplitude : term.rate;
}

Quantity term_entry(const char* name, bool amplitude) {
  // A material whose rates are too near to each other for fast is replaced by the default.
  const auto keep_off = [amplitude](const NamedNumbers& x) {
    const double first = amplitude ? 0 : 1;
    try {
      const auto last = static_cast<double>(terms_of(x).terms.size());
      x["term"] = std::clamp(std::floor(x["term"]), first, std::max(first, last));
      if (last >= first) return;
    } catch (const data::BadInput&) {
    }
    for (const Argument& argument : x.arguments()) x[argument.name] = default_number(argument);
  };
  return sampled(
      entry_of(
          name,
          [=](const NamedExact& x, int digits) {
            const ref::ExactRationalSolid solid = exact_solid_of(x);
            return (amplitude ? ref::relaxation_amplitude : ref::relaxation_rate)(
                x["of"].sign() == 0 ? solid.theta1 : solid.theta2, whole_term(x["term"].approximate()),
                part_of(x), digits);
          },
          [=](const NamedPoint& x) {
            const std::complex<double> value = number_of_term(x, amplitude);
            return x["part"] == 0 ? value.real() : value.imag();
          },
          [=](const NamedPoint& x) { return std::abs(number_of_term(x, amplitude)); }),
      [=](Random& random, const NamedNumbers& x) {
        draw_material(random, x);
        x["of"] = static_cast<double>(random.index(2));
        x["part"] = random.chance(0.7) ? 0 : 1;
        x["term"] = static_cast<double>(random.index(random.chance(0.5) ? 3 : 20));
        keep_off(x);
      },
      keep_off);
}

}  // namespace

std::vector<Quantity> material_entries() {
  // Argument-dependent lookup finds the overloads of both paths.
  const auto relaxes = [](const auto&... x) { return relaxation(x...); };
  const auto creeps = [](const auto&... x) { return creep(x...); };
  const auto stores = [](const auto&... x) { return storage(x...); };
  const auto loses = [](const auto&... x) { return loss(x...); };
  return {
      theta_entry(
          "material.theta1", [](const NamedPoint& x, double t) { return theta1(modulus_in(x, "shear"), t); },
          fast::theta1, &ref::ExactRationalSolid::theta1),
      theta_entry(
          "material.theta2",
          [](const NamedPoint& x, double t) {
            return theta2(modulus_in(x, "shear"), modulus_in(x, "bulk"), t);
          },
          fast::theta2, &ref::ExactRationalSolid::theta2),
      modulus_entry("material.G", "t", "shear", relaxes),
      modulus_entry("material.K", "t", "bulk", relaxes),
      modulus_entry("material.creep_shear", "t", "shear", creeps),
      modulus_entry("material.creep_bulk", "t", "bulk", creeps),
      term_entry("material.gamma", true),
      term_entry("material.lambda", false),
      modulus_entry("material.storage_shear", "omega", "shear", stores),
      modulus_entry("material.storage_bulk", "omega", "bulk", stores),
      modulus_entry("material.loss_shear", "omega", "shear", loses),
      modulus_entry("material.loss_bulk", "omega", "bulk", loses),
      growth_entry("material.G_of_p", true),
      growth_entry("material.K_of_p", false)};
}

}  // namespace nipref::verify
