#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/material/internal/rational_arguments.hpp>
#include <nipref/verify/catalogue/memory/internal/passing_times.hpp>
#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>

namespace nipref::verify {
namespace {

using std::numbers::pi;
using Arguments = std::span<const double>;
using Exacts = std::span<const ref::Exact>;
using fast::Accuracy;
using ref::Exact;

constexpr double moving_load_promise = 8;
constexpr auto remembered_size =
    "sum of the magnitudes of its kernels: at the point, and in the integrals of its memory, a rate that is rounded "
    "counting that rate times the time since";

// The sheet's arguments: speed, half_thickness, material, bulk, relaxation_time, the series, the operators.
constexpr std::size_t bulk_in_sheet = 3, prony_in_sheet = 5,
                      operators_in_sheet = prony_in_sheet + prony_arguments,
                      sheet_arguments = operators_in_sheet + operator_arguments;
constexpr double standard_linear_solid = 0, thesis_solid = 1, prony_solid = 2, solid_of_operators = 3;

/// Terms of equal rate joined, those of amplitude 0 left out.
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

/// The thesis's solid, theta1 = 4/(3 bulk)[delta + e^(-t/tau)/tau], theta2 a third of it; printed: with
/// e^(-2t/tau). Or a series, or operators. x: the sheet's arguments.
data::ViscoelasticMaterial material_of(Arguments x) {
  if (x[2] == prony_solid) {
    const data::PronySeries series = prony_of(x.subspan(prony_in_sheet));
    return {joined_series(series.theta1), joined_series(series.theta2)};
  }
  if (x[2] == solid_of_operators) return data::operator_solid(operators_of(x.subspan(operators_in_sheet)));
  const data::Compliances at_once{4 / (3 * x[3]), 4 / (9 * x[3])};
  return x[2] == standard_linear_solid ? data::single_relaxation_time_solid(at_once, x[4])
                                       : data::misprinted_thesis_solid(at_once, x[4]);
}

ref::ExactFunction exact_series_of(Exacts x) {
  ref::ExactFunction function{x[0].value(), {}, {}};
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
    if (x[k].sign() != 0) function.terms.push_back({x[k].value(), x[k + 1].value()});
  }
  return function;
}

ref::ExactMaterial exact_material_of(Exacts x) {
  const double solid = x[2].approximate();
  if (solid == solid_of_operators)
    return ref::exact_material(exact_operators_of(x.subspan(operators_in_sheet)));
  if (solid == prony_solid)
    return {exact_series_of(x.subspan(prony_in_sheet)),
            exact_series_of(x.subspan(prony_in_sheet + prony_arguments / 2))};
  return ref::exact_solid(
      solid == standard_linear_solid ? ref::Solid::standard_linear_solid : ref::Solid::thesis, x[3], x[4]);
}

double magnitude_I1(double w) { return std::max(envelope_I1(w), -std::log(std::fabs(w))); }

/// int magnitude(w) (1 + rounded (w - from)) e^(-rate (w - from)) dw from `from` to `to`: the exponential's scale, the
/// logarithm at 0 and the kernels' own scale set the pieces.
template <class Magnitude>
double remembered(Magnitude magnitude, double rate, double rounded, double from, double to) {
  // Towards the load the kernels grow faster than some memories fade.
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

/// A material function, and whether its rates come out of a division or of roots.
struct Rounded {
  data::MaterialFunction theta;
  bool rates_are_rounded;
};

/// Of theta * kernel at the distance `from`, the load having started at `to`.
template <class Magnitude>
double convolved(const Rounded& of, double way_per_time, Magnitude magnitude, double from, double to) {
  double sum = of.theta.instantaneous * magnitude(from);
  for (const data::RelaxationTerm& term : of.theta.terms) {
    const double rounded = of.rates_are_rounded ? std::abs(term.rate) / way_per_time : 0;
    sum += std::abs(term.amplitude) / way_per_time *
           remembered(magnitude, term.rate.real() / way_per_time, rounded, from, to);
  }
  return sum;
}

struct LoadPath {
  double from, to;
};

/// x: the sheet's arguments.
class Sizes {
 public:
  explicit Sizes(Arguments x)
      : material_(fast::material_functions(material_of(x))),
        rounded_(x[2] != prony_solid),
        way_per_time_(x[0] / x[1]) {}

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
  template <class Magnitude>
  [[nodiscard]] double of(const data::MaterialFunction& theta, Magnitude magnitude, LoadPath way) const {
    return convolved({theta, rounded_}, way_per_time_, magnitude, way.from, way.to);
  }

  data::MaterialFunctions material_;
  bool rounded_;
  double way_per_time_;
};

LoadPath started(double t, double T, double way_per_time) {
  return {way_per_time * (T - t), way_per_time * T};
}
LoadPath steady(double alpha) { return {alpha, HUGE_VAL}; }

void append_sheet(std::vector<Argument>& arguments) {
  arguments.push_back({"speed", ArgumentKind::positive, "1", {}});
  arguments.push_back({"half_thickness", ArgumentKind::positive, "1", {}});
  const auto single = keys_of_numbers({"bulk", "relaxation_time"});
  arguments.push_back({"material",
                       ArgumentKind::choice,
                       "standard-linear-solid",
                       {},
                       {"standard-linear-solid", "thesis-misprint", "prony", "operators"},
                       {single, single, prony_keys(), operator_keys()}});
  arguments.push_back({"bulk", ArgumentKind::positive, "1", {}});
  arguments.push_back({"relaxation_time", ArgumentKind::positive, "1", {}});
  append_prony_arguments(arguments);
  append_operator_arguments(arguments);
}

const std::vector<Argument>& arguments_of_sheet() {
  static const std::vector<Argument> arguments = [] {
    std::vector<Argument> all;
    append_sheet(all);
    return all;
  }();
  return arguments;
}

/// Makes theta2 a part of theta1 that creeps at least as much: what has such functions gains no energy. x: the series.
void keep_passive(double* x) {
  double* plane = x + prony_arguments / 2;
  const double part = x[0] > 0 ? std::clamp(plane[0] / x[0], 1e-3, 0.9) : 0.25;
  const double creeping = std::clamp(plane[1] / x[1], part, 2 * part);
  plane[0] = part * x[0];
  plane[1] = creeping * x[1];
  plane[2] = x[2];
  plane[3] = creeping * x[3];
  plane[4] = x[4];
}

/// Whether there is such a material, whose memory does not swing so often while it fades that a second method takes
/// minutes.
bool is_soon_confirmed(Arguments sheet) {
  constexpr double most_turns = 30;
  try {
    const data::MaterialFunctions material = fast::material_functions(material_of(sheet));
    return std::ranges::all_of(material.normal_compliance().terms, [](const data::RelaxationTerm& term) {
      return std::fabs(term.rate.imag()) <= most_turns * term.rate.real();
    });
  } catch (const data::BadInput&) {
    return false;
  }
}

/// The sheet's arguments: relaxation rates from 1e-12 to 1e12 speed/half_thickness, or 0.
std::vector<double> draw_sheet(Random& random) {
  for (;;) {
    const double speed = random.log_uniform(1e-3, 1e3), half_thickness = random.log_uniform(1e-3, 1);
    const double unit = half_thickness / speed;
    std::vector<double> sheet{speed, half_thickness, static_cast<double>(random.index(4)),
                              random.log_uniform(1e-3, 1e6), unit * random.log_uniform(1e-12, 1e12)};
    draw_prony(sheet, random.log_uniform(1e-6, 1e3), unit * random.log_uniform(1e-5, 1e5), random);
    keep_passive(&sheet[prony_in_sheet]);
    draw_operators(sheet, random.log_uniform(1e-3, 1e6), unit * random.log_uniform(1e-5, 1e5), random);
    default_unread(sheet, arguments_of_sheet());
    if (sheet[2] != solid_of_operators || is_soon_confirmed(sheet)) return sheet;
  }
}

/// A neighbour of a passive solid may gain energy: then it is a solid that does not. Where a load is `farthest`
/// half-thicknesses away, and the reference refuses operators there, it is the standard one.
void keep_material(double* x, double farthest) {
  constexpr double near = 199;
  keep_passive(x + prony_in_sheet);
  if (x[2] != solid_of_operators || (farthest <= near && is_soon_confirmed({x, sheet_arguments}))) return;
  if (farthest > near) x[2] = standard_linear_solid;
  for (std::size_t i = operators_in_sheet; i < sheet_arguments; ++i)
    x[i] = std::stod(*arguments_of_sheet()[i].default_text);
}

/// Of the load and of where it started, half-thicknesses, at most: t and passing times, or distances in units of `unit`.
double farthest_load(std::span<const double> before_sheet, double unit) {
  double farthest = 0;
  for (const double x : before_sheet)
    farthest = std::max({farthest, std::fabs(x) / unit, std::fabs(x - before_sheet[0]) / unit});
  return farthest;
}

Point joined(Point times, const std::vector<double>& sheet) {
  times.insert(times.end(), sheet.begin(), sheet.end());
  return times;
}

double draw_distance(Random& random) {
  return (random.chance(0.5) ? 1 : -1) *
         (random.chance(0.5) ? random.log_uniform(1e-12, 50) : random.log_uniform(1e-2, 20));
}

enum class Load { started, steady };

Quantity moving_load_entry(std::string name, std::string definition, std::string source, Load load) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = std::move(source);
  entry.unit = "1/unit of bulk";
  entry.scale = remembered_size;
  entry.promise = moving_load_promise;
  entry.audit_points = 100;
  entry.is_costly = true;
  entry.keep_off = [load](Point& point) {
    const std::span before_sheet = std::span(point).first(point.size() - sheet_arguments);
    double* sheet = &point[before_sheet.size()];
    keep_material(sheet, farthest_load(before_sheet, load == Load::steady ? 1 : sheet[1] / sheet[0]));
  };
  return entry;
}

// In all entries `at` is where the sheet's arguments begin. Rates that come out of 1/tau or of roots are rounded before
// fast gets them, and where e^(-rate t) has faded that is felt: the scale counts rate t times.

data::ViscoelasticMaterial material_at(Arguments x, std::size_t at) { return material_of(x.subspan(at)); }
/// The one that was asked for last is kept: a search along one argument asks for the same sheet again and again, and
/// whether a material is passive takes longer to find than a displacement.
const fast::MovingLoad& load_at(Arguments x, std::size_t at, Accuracy accuracy) {
  struct Last {
    std::vector<double> sheet;
    fast::MovingLoad load;
  };
  thread_local std::optional<Last> last;
  std::vector<double> sheet(x.begin() + static_cast<std::ptrdiff_t>(at), x.end());
  sheet.push_back(accuracy.rtol());
  if (!last || last->sheet != sheet)
    last.emplace(Last{std::move(sheet), {material_at(x, at), x[at], x[at + 1], accuracy}});
  return last->load;
}
ref::ExactMaterial exact_at(Exacts x, std::size_t at) { return exact_material_of(x.subspan(at)); }

Quantity entry_Un() {
  Quantity entry = moving_load_entry(
      "Un",
      "normal displacement at t by a normal line load that started at 0 and passes the point at T: (theta1 + "
      "theta2) * I1/pi",
      "thesis (6.23), (6.25)", Load::started);
  entry.arguments = {{"t", ArgumentKind::time, {}, {}}, {"T", ArgumentKind::passing_time, {}, {}}};
  append_sheet(entry.arguments);
  entry.draw = [](Random& random) {
    const auto sheet = draw_sheet(random);
    const double unit = sheet[1] / sheet[0], t = random.log_uniform(1e-9, 50);
    return joined({unit * t, unit * draw_passing_time(t, random)}, sheet);
  };
  entry.keep_off = [keep_material = entry.keep_off](Point& point) {
    keep_material(point);
    if (point[0] == point[1]) point[1] = std::nextafter(point[1], HUGE_VAL);
  };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::moving_load_normal_displacement(x[0], x[1], x[2], x[3], exact_at(x, 2), digits);
  };
  set_fast(entry, [](Arguments x, Accuracy accuracy) {
    return load_at(x, 2, accuracy).normal_displacement(x[0], x[1]);
  });
  entry.envelope = [](Arguments x) {
    const double way_per_time = x[2] / x[3];
    return Sizes(x.subspan(2)).Un(started(x[0], x[1], way_per_time));
  };
  return entry;
}

Quantity entry_Vn() {
  Quantity entry = moving_load_entry("Vn",
                                     "tangential displacement by that load against the pinned point, which "
                                     "it passes at t0: [(theta1 + theta2) * I3 - "
                                     "theta2 * I2](alpha)/pi + [theta2 * I4 - theta1 * I5](eta)/pi",
                                     "thesis (6.24), (6.26)-(6.28)", Load::started);
  entry.arguments = {{"t", ArgumentKind::time, {}, {}},
                     {"T", ArgumentKind::passing_time, {}, {}},
                     {"t0", ArgumentKind::passing_time, {}, {}}};
  append_sheet(entry.arguments);
  entry.draw = [](Random& random) {
    const auto sheet = draw_sheet(random);
    const double unit = sheet[1] / sheet[0], t = random.log_uniform(1e-9, 50);
    return joined({unit * t, unit * draw_passing_time(t, random), unit * draw_passing_time(t, random)},
                  sheet);
  };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::moving_load_tangential_displacement(x[0], x[1], x[2], x[3], x[4], exact_at(x, 3), digits);
  };
  set_fast(entry, [](Arguments x, Accuracy accuracy) {
    return load_at(x, 3, accuracy).tangential_displacement(x[0], x[1], x[2]);
  });
  entry.envelope = [](Arguments x) {
    const double way_per_time = x[3] / x[4];
    return Sizes(x.subspan(3)).Vn(started(x[0], x[1], way_per_time), started(x[0], x[2], way_per_time));
  };
  return entry;
}

Quantity entry_Un_steady() {
  Quantity entry = moving_load_entry(
      "Un_steady", "Un of a load that started infinitely long ago, at alpha half-thicknesses ahead of it",
      "thesis (6.23) as t, T -> infinity", Load::steady);
  entry.arguments = {{"alpha", ArgumentKind::nonzero_position, {}, {}}};
  append_sheet(entry.arguments);
  entry.draw = [](Random& random) { return joined({draw_distance(random)}, draw_sheet(random)); };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::moving_load_steady_normal_displacement(x[0], x[1], x[2], exact_at(x, 1), digits);
  };
  set_fast(entry, [](Arguments x, Accuracy accuracy) {
    return load_at(x, 1, accuracy).steady_normal_displacement(x[0]);
  });
  entry.envelope = [](Arguments x) { return Sizes(x.subspan(1)).Un(steady(x[0])); };
  return entry;
}

Quantity entry_Vn_steady() {
  Quantity entry = moving_load_entry(
      "Vn_steady",
      "Vn of a load that started infinitely long ago, eta half-thicknesses behind the pinned point",
      "thesis (6.24) as t, T, t0 -> infinity", Load::steady);
  entry.arguments = {{"alpha", ArgumentKind::position, {}, {}}, {"eta", ArgumentKind::position, {}, {}}};
  append_sheet(entry.arguments);
  entry.draw = [](Random& random) {
    return joined({draw_distance(random), draw_distance(random)}, draw_sheet(random));
  };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::moving_load_steady_tangential_displacement(x[0], x[1], x[2], x[3], exact_at(x, 2), digits);
  };
  set_fast(entry, [](Arguments x, Accuracy accuracy) {
    return load_at(x, 2, accuracy).steady_tangential_displacement(x[0], x[1]);
  });
  entry.envelope = [](Arguments x) { return Sizes(x.subspan(2)).Vn(steady(x[0]), steady(x[1])); };
  return entry;
}

}  // namespace

std::vector<Quantity> moving_load_entries() {
  return {entry_Un(), entry_Vn(), entry_Un_steady(), entry_Vn_steady()};
}

}  // namespace nipref::verify
