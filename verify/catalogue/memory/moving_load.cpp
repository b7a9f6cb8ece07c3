#include <boost/math/quadrature/gauss.hpp>
#include <complex>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/material/internal/rational_arguments.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using std::numbers::pi;

// The models in the order of quantities.toml.
constexpr double standard_linear_solid = 0, prony_solid = 2, solid_of_operators = 3, solid_of_two_moduli = 4;
/// The last model is not drawn, as the first one is a special case of it.
constexpr std::size_t drawn_solids = 4;

/// Joins terms of equal rate and leaves out those of amplitude 0.
data::MaterialFunction joined_series(const data::PronyList& list) {
  data::MaterialFunction function{list.instantaneous, {}};
  for (std::size_t i = 0; i < list.rates.size(); ++i) {
    if (list.amplitudes[i] == 0) continue;
    const auto same =
        std::ranges::find(function.terms, std::complex<double>(list.rates[i]), &data::RelaxationTerm::rate);
    if (same == function.terms.end()) {
      function.terms.push_back({list.amplitudes[i], list.rates[i]});
    } else {
      same->amplitude += list.amplitudes[i];
    }
  }
  return function;
}

/// The material of the point: a series, operators, a solid of two moduli, or the thesis's solid,
/// theta1 = 4/(3 bulk)[delta + e^(-t/tau)/tau] and theta2 = theta1/3, which the thesis misprints with e^(-2t/tau).
data::ViscoelasticMaterial material_of(const NamedPoint& x) {
  const double model = x["material"];
  if (model == prony_solid) {
    const data::PronySeries series = prony_of(x);
    return {joined_series(series.theta1), joined_series(series.theta2)};
  }
  if (model == solid_of_operators) return data::operator_solid(operators_of(x));
  if (model == solid_of_two_moduli)
    return data::single_relaxation_time_solid(x["bulk"], x["shear"], x["relaxation_time"]);
  const data::Compliances at_once{4 / (3 * x["bulk"]), 4 / (9 * x["bulk"])};
  return data::single_relaxation_time_solid(
      at_once, x["relaxation_time"], model == standard_linear_solid ? 1 : data::misprinted_rate_factor);
}

ref::ExactFunction exact_function_of(const ref::ExactSeries& series) {
  ref::ExactFunction function{series.instantaneous.value(), {}, {}};
  for (std::size_t i = 0; i < series.rates.size(); ++i) {
    if (series.amplitudes[i].sign() != 0)
      function.terms.push_back({series.amplitudes[i].value(), series.rates[i].value()});
  }
  return function;
}

ref::ExactMaterial exact_material_of(const NamedExact& x) {
  const double model = x["material"].approximate();
  if (model == solid_of_operators) return ref::exact_material(exact_operators_of(x));
  if (model == prony_solid)
    return {exact_function_of(exact_series_of(x, "theta1")), exact_function_of(exact_series_of(x, "theta2"))};
  if (model == solid_of_two_moduli)
    return ref::exact_material(ref::exact_single_time(x["bulk"], x["shear"], x["relaxation_time"], 1));
  return ref::exact_solid(
      model == standard_linear_solid ? ref::Solid::standard_linear_solid : ref::Solid::thesis, x["bulk"],
      x["relaxation_time"]);
}

// Magnitudes of the kernels, from the sizes in quantities.toml.
double magnitude_I1(double w) {
  return std::max(2 * pi * 0.25584797756897609 * std::exp(-2.1061961152453303 * std::fabs(w)),
                  -std::log(std::fabs(w)));
}
double magnitude_I3(double w) { return std::min(0.76858 * std::fabs(w), 0.787); }
double magnitude_I4(double w) { return std::min(1.05372 * std::fabs(w), 0.791); }
double magnitude_I5(double w) { return std::min(1.83496 * std::fabs(w), 0.905); }

/// int magnitude(w) (1 + rounded (w - from)) e^(-rate (w - from)) dw from `from` to `to`, by Gauss's rule on pieces
/// which resolve the exponential, the logarithm at 0 and the kernels.
template <class Magnitude>
double remembered(Magnitude magnitude, double rate, double rounded, double from, double to) {
  // Some memories decay more slowly than the kernels grow towards the load, which must therefore be within the range.
  const double forgotten = rate > 0 ? 40 / rate : std::isinf(to) ? 20 : to;
  const double end = std::min(to, std::max(from, 0.0) + forgotten);
  std::vector<double> cuts{from, end};
  for (const double cut : {-20.0, -8.0, -3.0, -1.0, -0.1, -1e-3, -1e-6, 0.0, 1e-6, 1e-3, 0.1, 1.0, 3.0, 8.0,
                           20.0, from + 0.1 / rate, from + 1 / rate, from + 4 / rate, from + 12 / rate}) {
    if (from < cut && cut < end) cuts.push_back(cut);
  }
  std::ranges::sort(cuts);
  double sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    sum += boost::math::quadrature::gauss<double, 15>::integrate(
        [&](double w) { return magnitude(w) * (1 + rounded * (w - from)) * std::exp(-rate * (w - from)); },
        cuts[i - 1], cuts[i]);
  }
  return sum;
}

/// The distance of a load from a point, and that of the place where the load started.
struct LoadPath {
  double from, to;
};

/// Sizes of the displacements. Rates that are computed as 1/tau or as roots are rounded before fast gets them, and
/// e^(-rate t) amplifies the rounding error by the factor rate t, which the sizes therefore include.
class Sizes {
 public:
  explicit Sizes(const NamedPoint& x)
      : material_(fast::material_functions(material_of(x))),
        rounded_(x["material"] != prony_solid),
        way_per_time_(x["speed"] / x["half_thickness"]) {}

  [[nodiscard]] double Un(LoadPath point) const {
    return of(material_.normal_compliance(), magnitude_I1, point) / pi;
  }
  [[nodiscard]] double Vn(LoadPath point, LoadPath pin) const {
    const auto sign = [](double) { return pi / 2; };
    return (of(material_.normal_compliance(), magnitude_I3, point) + of(material_.theta2, sign, point) +
            of(material_.theta2, magnitude_I4, pin) + of(material_.theta1, magnitude_I5, pin)) /
           pi;
  }

 private:
  /// The size of the convolution of theta and a kernel.
  template <class Magnitude>
  [[nodiscard]] double of(const data::MaterialFunction& theta, Magnitude magnitude, LoadPath way) const {
    double sum = theta.instantaneous * magnitude(way.from);
    for (const data::RelaxationTerm& term : theta.terms) {
      const double rounded = rounded_ ? std::abs(term.rate) / way_per_time_ : 0;
      sum += std::abs(term.amplitude) / way_per_time_ *
             remembered(magnitude, term.rate.real() / way_per_time_, rounded, way.from, way.to);
    }
    return sum;
  }

  data::MaterialFunctions material_;
  bool rounded_;  ///< the rates are results of a division or of a search for roots
  double way_per_time_;
};

/// The path until the time t of a load that started at the time 0, relative to the point that it passes at the time T.
LoadPath started(const NamedPoint& x, const char* passing_time) {
  const double way_per_time = x["speed"] / x["half_thickness"], T = x[passing_time];
  return {way_per_time * (T - x["t"]), way_per_time * T};
}
LoadPath steady(double alpha) { return {alpha, HUGE_VAL}; }

/// Makes theta2 a fraction of theta1 that creeps at least as much, so that the material gains no energy.
void keep_passive(const NamedNumbers& x) {
  const double at_once = x["theta1_instantaneous"];
  const double part = at_once > 0 ? std::clamp(x["theta2_instantaneous"] / at_once, 1e-3, 0.9) : 0.25;
  const double creeping = std::clamp(x["theta2_amplitude"] / x["theta1_amplitude"], part, 2 * part);
  x["theta2_instantaneous"] = part * at_once;
  std::ranges::transform(x.list("theta1_amplitude"), x.list("theta2_amplitude").begin(),
                         [creeping](double amplitude) { return creeping * amplitude; });
  std::ranges::copy(x.list("theta1_rate"), x.list("theta2_rate").begin());
}

/// Whether the material exists and its memory oscillates so little that a second method does not take minutes.
bool is_soon_confirmed(const NamedPoint& x) {
  constexpr double most_turns = 30;
  const auto material = unless_refused([&] { return fast::material_functions(material_of(x)); });
  return material && std::ranges::all_of(material->normal_compliance().terms, [](const auto& term) {
           return std::fabs(term.rate.imag()) <= most_turns * term.rate.real();
         });
}

/// Draws a sheet with relaxation rates from 1e-12 to 1e12 speed/half_thickness, or 0.
void draw_sheet(Random& random, const NamedNumbers& x) {
  do {
    x["speed"] = random.log_uniform(1e-3, 1e3);
    x["half_thickness"] = random.log_uniform(1e-3, 1);
    const double unit = x["half_thickness"] / x["speed"];
    x["material"] = static_cast<double>(random.index(drawn_solids));
    x["bulk"] = random.log_uniform(1e-3, 1e6);
    x["relaxation_time"] = unit * random.log_uniform(1e-12, 1e12);
    draw_prony(x, random.log_uniform(1e-6, 1e3), unit * random.log_uniform(1e-5, 1e5), random);
    keep_passive(x);
    draw_operators(x, random.log_uniform(1e-3, 1e6), unit * random.log_uniform(1e-5, 1e5), random);
    default_unread(x);
  } while (x["material"] == solid_of_operators && !is_soon_confirmed(x));
}

/// Replaces a solid that gains energy, to which a step of a search may lead, by a passive one. If a load is farther
/// away than the reference allows for operators, they are replaced by the standard linear solid.
void keep_material(const NamedNumbers& x, double farthest) {
  constexpr double near = 199;
  keep_passive(x);
  if (x["material"] != solid_of_operators || (farthest <= near && is_soon_confirmed(x))) return;
  if (farthest > near) x["material"] = standard_linear_solid;
  const Argument& material = x.arguments()[argument_number(x.arguments(), "material")];
  set_defaults(x, material.models[static_cast<std::size_t>(solid_of_operators)].keys);
}

/// The largest distance on a line of `first` from 0, and of the `others` from 0 and from `first`.
double largest_distance(double first, std::same_as<double> auto... others) {
  return std::max({std::fabs(first), std::fabs(others)..., std::fabs(others - first)...});
}

/// The load, cached: a search along one argument asks for the same sheet many times, and the check that a material is
/// passive takes longer than a displacement.
const fast::MovingLoad& load_of(const NamedPoint& x, Accuracy accuracy) {
  struct Last {
    std::vector<double> sheet;
    fast::MovingLoad load;
  };
  thread_local std::optional<Last> last;
  const std::span<const double> numbers = x.from("speed");
  std::vector<double> sheet(numbers.begin(), numbers.end());
  sheet.push_back(accuracy.rtol());
  if (!last || last->sheet != sheet)
    last.emplace(Last{std::move(sheet), {material_of(x), x["speed"], x["half_thickness"], accuracy}});
  return last->load;
}

/// An entry by functions of these numbers: the `displacement` of a load by either path, and its size.
Quantity load_entry(const char* quantity, auto displacement, auto size, auto... names) {
  return entry_of(
      quantity,
      [=](NamedExact x, int digits) {
        const ref::MovingLoad load(exact_material_of(x), x["speed"], x["half_thickness"]);
        return displacement(load, x[names]..., digits);
      },
      [=](NamedPoint x, Accuracy accuracy) { return displacement(load_of(x, accuracy), x[names]...); }, size);
}

/// An entry of a started load. `size`: a member of Sizes; `passing`: names of the times of passing the points.
template <class... Names>
Quantity started_entry(const char* quantity, auto displacement, auto size, Names... passing) {
  const auto draw = [=](Random& random, NamedNumbers x) {
    draw_sheet(random, x);
    const double unit = x["half_thickness"] / x["speed"], t = random.log_uniform(1e-9, 50);
    x["t"] = unit * t;
    for (const char* name : {passing...}) x[name] = unit * draw_passing_time(t, random);
  };
  const auto size_at = [=](NamedPoint x) { return (Sizes(x).*size)(started(x, passing)...); };
  return sampled(load_entry(quantity, displacement, size_at, "t", passing...), draw, [=](NamedNumbers x) {
    // In time, the load started at 0, and is at t.
    keep_material(x, largest_distance(x["t"], x[passing]...) / (x["half_thickness"] / x["speed"]));
    // Un is infinite under the load.
    if (sizeof...(passing) == 1 && x["t"] == x["T"]) x["T"] = std::nextafter(x["T"], HUGE_VAL);
  });
}

/// An entry of a steady load. `distances`: names of the distances from the load.
template <class... Names>
Quantity steady_entry(const char* quantity, auto displacement, auto size, Names... distances) {
  const auto draw = [=](Random& random, NamedNumbers x) {
    draw_sheet(random, x);
    for (const char* name : {distances...})
      x[name] = (random.chance(0.5) ? 1 : -1) *
                (random.chance(0.5) ? random.log_uniform(1e-12, 50) : random.log_uniform(1e-2, 20));
  };
  const auto size_at = [=](NamedPoint x) { return (Sizes(x).*size)(steady(x[distances])...); };
  return sampled(load_entry(quantity, displacement, size_at, distances...), draw,
                 [=](NamedNumbers x) { keep_material(x, largest_distance(x[distances]...)); });
}

}  // namespace

std::vector<Quantity> moving_load_entries() {
  return {started_entry(
              "Un", [](const auto& load, const auto&... at) { return load.normal_displacement(at...); },
              &Sizes::Un, "T"),
          started_entry(
              "Vn", [](const auto& load, const auto&... at) { return load.tangential_displacement(at...); },
              &Sizes::Vn, "T", "t0"),
          steady_entry(
              "Un_steady",
              [](const auto& load, const auto&... at) { return load.steady_normal_displacement(at...); },
              &Sizes::Un, "alpha"),
          steady_entry(
              "Vn_steady",
              [](const auto& load, const auto&... at) { return load.steady_tangential_displacement(at...); },
              &Sizes::Vn, "alpha", "eta")};
}

}  // namespace nipref::verify
