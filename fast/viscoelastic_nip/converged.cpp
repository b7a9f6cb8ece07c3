#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/nip/internal/contact_field.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/kept.hpp>
#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/number/internal/sampled_maximum.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_equations.hpp>

namespace nipref::fast {
namespace {

NipShape shape(const data::ViscoelasticNip& nip) { return {nip.roller_radius, nip.sheet_thickness}; }

ContactUnits units_of(const data::ViscoelasticNip& nip, double compliance) {
  return {shape(nip), compliance};
}

/// Half-thicknesses. A memory with a longer relaxation length adds nothing: it is at most 1e120 of the compliance over
/// that length. A memory that flows for ever, rate 0, has no relaxation length.
constexpr double too_long = 1e150;

RollingSheet rolling_sheet(const data::ViscoelasticNip& nip, const data::MaterialFunctions& functions) {
  const double way_per_time = nip.speed / nip.half_thickness();
  const data::MaterialFunction normal = functions.normal_compliance();
  const auto memories = [&](const data::MaterialFunction& function) {
    std::vector<Memory> result;
    for (const data::RelaxationTerm& term : function.terms) {
      if (term.rate != 0.0 && !(way_per_time < too_long * std::abs(term.rate))) continue;
      result.push_back(
          {term.amplitude / (way_per_time * normal.instantaneous), 0.0 + term.rate / way_per_time});  // no -0
    }
    return result;
  };
  return {rolling_compliance(memories(normal)), functions.theta2.instantaneous / normal.instantaneous,
          memories(functions.theta2)};
}

/// Beyond it the pressure next to the leading end is nearly as large as where nothing gives way at once.
void check_softening(const RollingEquations& equations, double half_length) {
  constexpr double most = 3e4;
  const double softening = equations.softening_over(half_length);
  if (!(softening <= most))
    throw data::BadInput(
        "nip.material", softening,
        "times as soft over the contact as at once, must be at most 3e4 times: with less at once "
        "the pressure at the leading end is nearly infinite");
}

/// A place of the surface: e from the nearer end, negative outside the contact.
struct ContactPlace {
  bool trailing;
  double e;

  /// In a contact so short that the place is beyond its middle, it is on the other half.
  [[nodiscard]] ContactPlace in(const Solution& solution) const {
    if (e <= solution.half_length()) return *this;
    return {!trailing, std::max(0.0, 2 * solution.half_length() - e)};
  }
};

Functional pressure_at(const Solution& solution, const ContactPlace& place) {
  if (!(place.e > 0)) return solution.of_tractions(Eigen::RowVectorXd::Zero(solution.tractions().columns()));
  const auto [trailing, e] = place.in(solution);
  const Eigen::MatrixXd both = solution.tractions().values(e);
  return solution.of_tractions(both.row(0) + (trailing ? -1 : 1) * both.row(1));
}

double pressure_of(const SolvedNip& nip, const ContactPlace& place) {
  if (!(place.e > 0)) return 0;
  const std::complex<double> g = nip.traction(place.e);
  return place.trailing ? g.real() - g.imag() : g.real() + g.imag();
}

}  // namespace

struct ConvergedViscoelasticNip::Implementation {
  Implementation(const data::ViscoelasticNip& nip, double compliance,
                 std::shared_ptr<const RollingEquations> kind, SolvedNip solution)
      : units(units_of(nip, compliance)),
        roller_radius(nip.roller_radius),
        equations(std::move(kind)),
        solved(std::move(solution)) {}

  ContactUnits units;
  double roller_radius;
  std::shared_ptr<const RollingEquations> equations;
  SolvedNip solved;
  mutable Kept<const Solution*, Functional> at_origin, mean_strain;
  mutable Kept<double, SolvedNip::OfPlace> strains;  ///< by the position
  mutable std::optional<double> origin_shift;

  [[nodiscard]] double half_length() const { return solved.half_length(); }
  [[nodiscard]] double offset() const {
    return solved.value([](const Solution& solution) { return solution.unknown(RollingEquations::offset); });
  }
  [[nodiscard]] Estimate offset_estimate() const {
    return solved.estimate(
        [](const Solution& solution) { return solution.of_unknown(RollingEquations::offset); });
  }
  [[nodiscard]] double unsure_end() const {
    return offset_estimate().error + solved.half_length_estimate().error + 0x1p-52 * half_length();
  }
  /// Dimensionless Y from the line through the rollers' centres.
  [[nodiscard]] double position(double y) const {
    check_position(y);
    return y / units.length;
  }
  [[nodiscard]] ContactPlace place(double position) const {
    const double y = position - offset();
    return {y < 0, half_length() - std::fabs(y)};
  }
  /// A number of a place that is known as well as the contact's ends.
  template <class AtPlace>
  [[nodiscard]] SolvedNip::OfPlace at_unsure_place(const ContactPlace& place, const AtPlace& at) const {
    return solved.at_place(place.e, unsure_end(), at_distance(place, at));
  }
  template <class AtPlace>
  [[nodiscard]] static SolvedNip::AtPlace at_distance(const ContactPlace& place, const AtPlace& at) {
    return [&at, trailing = place.trailing](const Solution& solution, double e) {
      return at(solution, ContactPlace{trailing, e});
    };
  }
  [[nodiscard]] Estimate pressure(double position) const {
    return solved.estimate(at_unsure_place(place(position), pressure_at));
  }
  /// A kernel with its size, at a place.
  [[nodiscard]] Functional acting(const Solution& solution, const Tractions::Kernel& kernel,
                                  const ContactPlace& place) const {
    const auto [trailing, e] = place.in(solution);
    const double at[] = {e};
    const Eigen::MatrixXd rows = solution.tractions().rows(at, trailing, kernel, SolvedNip::tolerance());
    Functional result = solution.of_tractions(rows.row(0));
    result.cancelled = solution.value(solution.of_tractions(rows.row(1)));
    return result;
  }
  /// The displacement along the sheet beside that far ahead, and its mean slope in the contact. What belongs to no place is
  /// kept for each solution.
  [[nodiscard]] Functional tangential(const Solution& solution, const ContactPlace& place) const {
    return acting(solution, equations->kernels().tangential(), place);
  }
  [[nodiscard]] Functional tangential_at_origin(const Solution& solution) const {
    return at_origin.of(&solution, [&] { return tangential(solution, place(0)); });
  }
  [[nodiscard]] Functional creep(const Solution& solution) const {
    return mean_strain.of(&solution, [&] {
      Functional result = tangential(solution, {false, 0}) - tangential(solution, {true, 0});
      result.on_tractions /= 2 * solution.half_length();
      result.cancelled /= 2 * solution.half_length();
      return result;
    });
  }
  [[nodiscard]] double shift_of_origin() const {
    if (!origin_shift) {
      const auto at = [&](const Solution& solution, const ContactPlace& there) {
        return tangential(solution, there);
      };
      const ContactPlace origin = place(0);
      origin_shift = solved.shift(origin.e, unsure_end(), at_distance(origin, at));
    }
    return *origin_shift;
  }
  [[nodiscard]] Estimate strain(double y, bool beyond_creep) const {
    const Tractions::Kernel strain = equations->kernels().strain();
    const auto at = [&](const Solution& solution, const ContactPlace& place) {
      Functional here = acting(solution, strain, place);
      const Functional pressure = pressure_at(solution, place);
      here.on_tractions -= equations->sheet().theta2_at_once * pressure.on_tractions;
      here.cancelled += std::fabs(equations->sheet().theta2_at_once * solution.value(pressure));
      return here;
    };
    const double position = this->position(y);
    const auto& at_place = strains.of(position, [&] { return at_unsure_place(place(position), at); });
    std::optional<SolvedNip::Number> mean;
    if (beyond_creep) mean = [&](const Solution& solution) { return creep(solution); };
    return times(units.creep, solved.estimate(at_place, mean));
  }
  /// What is kept of solutions that are no more.
  void forget() {
    at_origin = mean_strain = {};
    strains = {};
    origin_shift.reset();
  }
  [[nodiscard]] ContactField field() const { return {solved, false, offset(), unsure_end()}; }
  /// Where the pressure is looked at, rising Y in half-thicknesses.
  [[nodiscard]] std::vector<double> places() const {
    constexpr int steps = 16;
    std::vector<double> result;
    for (const Panel& panel : solved.last().tractions().panels()) {
      const double right = std::min(panel.right, half_length());
      for (int i = 0; i < steps; ++i) {
        const double from_middle = half_length() - (panel.left + (right - panel.left) * (i + 0.5) / steps);
        result.push_back(offset() + from_middle);
        result.push_back(offset() - from_middle);
      }
    }
    // Layers have their own scale.
    for (const std::complex<double>& rate : solved.last().tractions().layer_rates()) {
      const double length = std::min(half_length(), 10 / std::abs(rate));
      for (int i = 1; i < 3 * steps; ++i)
        result.push_back(offset() + half_length() - length * i / (3 * steps));
    }
    std::ranges::sort(result);
    // Places of several lists may coincide; between two of them the pressure would look constant.
    const auto coincide = [&](double left, double right) {
      return right - left <= 1e-6 * std::fabs(place(right).e);
    };
    const auto rest = std::ranges::unique(result, coincide);
    result.erase(rest.begin(), rest.end());
    return result;
  }
};

ConvergedViscoelasticNip::ConvergedViscoelasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedViscoelasticNip::ConvergedViscoelasticNip(ConvergedViscoelasticNip&&) noexcept = default;
ConvergedViscoelasticNip::~ConvergedViscoelasticNip() = default;

Estimate ConvergedViscoelasticNip::contact_length() const {
  Estimate length = times(2 * implementation_->units.length, implementation_->solved.half_length_estimate());
  length.error += 0x1p-52 * length.value;
  return length;
}

Estimate ConvergedViscoelasticNip::leading_length() const {
  const Estimate offset = implementation_->offset_estimate();
  return times(implementation_->units.length,
               {implementation_->half_length() + offset.value, implementation_->unsure_end()});
}

Estimate ConvergedViscoelasticNip::trailing_length() const {
  const Estimate offset = implementation_->offset_estimate();
  return times(implementation_->units.length,
               {implementation_->half_length() - offset.value, implementation_->unsure_end()});
}

Estimate ConvergedViscoelasticNip::load() const {
  return times(implementation_->units.load, implementation_->solved.estimate(&Solution::load));
}

namespace {

/// u at Y, in the contact: u_m - Y^2 + offset^2.
Estimate roller_displacement(const SolvedNip& solved, double position) {
  const auto linearised = [](const Solution& solution) {
    Functional result = solution.of_unknown(RollingEquations::middle_displacement(solution));
    result.on_unknowns(RollingEquations::offset) = 2 * solution.unknown(RollingEquations::offset);
    return result;
  };
  return solved.estimate(linearised, [position](const Solution& solution) {
    return solution.unknown(RollingEquations::middle_displacement(solution)) +
           (std::pow(solution.unknown(RollingEquations::offset), 2) - position * position);
  });
}

/// u at an end, where y is A or -A.
Estimate end_displacement(const SolvedNip& solved, double sign) {
  return solved.estimate([sign](const Solution& solution) {
    Functional result = solution.of_unknown(RollingEquations::middle_displacement(solution));
    result.on_unknowns(RollingEquations::offset) = -2 * sign * solution.half_length();
    result.constant = -solution.half_length() * solution.half_length();
    return result;
  });
}

}  // namespace

Estimate ConvergedViscoelasticNip::indentation() const {
  return times(implementation_->units.displacement, roller_displacement(implementation_->solved, 0));
}

Estimate ConvergedViscoelasticNip::leading_displacement() const {
  return times(implementation_->units.displacement, end_displacement(implementation_->solved, 1));
}

Estimate ConvergedViscoelasticNip::trailing_displacement() const {
  return times(implementation_->units.displacement, end_displacement(implementation_->solved, -1));
}

Estimate ConvergedViscoelasticNip::pressure(double y) const {
  return times(implementation_->units.pressure, implementation_->pressure(implementation_->position(y)));
}

Estimate ConvergedViscoelasticNip::peak_pressure() const {
  const Implementation& nip = *implementation_;
  const std::vector<double> places = nip.places();
  const auto pressure = [&](double i) {
    const auto before = static_cast<std::size_t>(i);
    const double part = i - std::floor(i), next = places[std::min(before + 1, places.size() - 1)];
    return pressure_of(nip.solved, nip.place((1 - part) * places[before] + part * next));
  };
  const double best = internal::place_of_sampled_maximum(pressure, static_cast<int>(places.size()) - 1);
  const auto before = static_cast<std::size_t>(best);
  const double part = best - std::floor(best), next = places[std::min(before + 1, places.size() - 1)];
  // To first order the place does not matter.
  const ContactPlace place = nip.place((1 - part) * places[before] + part * next);
  return times(nip.units.pressure,
               nip.solved.estimate([&](const Solution& solution) { return pressure_at(solution, place); }));
}

Estimate ConvergedViscoelasticNip::peak_pressure_position() const {
  const Implementation& nip = *implementation_;
  const Solution& last = nip.solved.last();
  const auto value = [&](double y) { return pressure_of(nip.solved, nip.place(y)); };
  const LocalSlope local_slope(32);
  const auto reach = [&](double y) {
    const double e = std::max(nip.place(y).e, 1e-9 * nip.half_length());
    const Panel& panel = last.tractions().panels()[last.tractions().panel_of(e)];
    return std::min(e / 4, panel.width() / 8);
  };
  const PlaceFunction slope{[&](double y) { return local_slope(value, y, reach(y)); },
                            [&](double y) {
                              const ContactPlace here = nip.place(y);
                              return nip.solved.estimate([&](const Solution& solution) {
                                const auto pressure = [&](double e) -> Eigen::RowVectorXd {
                                  return pressure_at(solution, {here.trailing, e}).on_tractions;
                                };
                                Functional rise = solution.of_tractions(
                                    (here.trailing ? 1 : -1) * local_slope(pressure, here.e, reach(y)));
                                rise.cancelled = local_slope.condition() * value(y) / reach(y);
                                return rise;
                              });
                            }};
  const auto difference = [&](double y, double other) {
    const Estimate here = nip.pressure(y), there = nip.pressure(other);
    return Estimate{here.value - there.value, here.error + there.error};
  };
  Estimate place = place_of_maximum(value, slope, difference, nip.places());
  place.error += nip.unsure_end();
  return times(nip.units.length, place);
}

Estimate ConvergedViscoelasticNip::rolling_resistance() const {
  const Implementation& nip = *implementation_;
  return times(nip.units.length / nip.roller_radius,
               nip.solved.estimate(linearised_eccentricity, eccentricity));
}

Estimate ConvergedViscoelasticNip::creep_ratio() const {
  const Implementation& nip = *implementation_;
  return times(nip.units.creep,
               nip.solved.estimate([&](const Solution& solution) { return nip.creep(solution); }));
}

Estimate ConvergedViscoelasticNip::normal_displacement(double y) const {
  const Implementation& nip = *implementation_;
  const double position = nip.position(y);
  const ContactPlace place = nip.place(position);
  if (place.e >= 0) return times(nip.units.displacement, roller_displacement(nip.solved, position));
  const Tractions::Kernel normal = nip.equations->kernels().normal();
  return times(nip.units.displacement, nip.solved.estimate(nip.at_unsure_place(
                                           place, [&](const Solution& solution, const ContactPlace& at) {
                                             return nip.acting(solution, normal, at);
                                           })));
}

Estimate ConvergedViscoelasticNip::tangential_displacement(double y) const {
  const Implementation& nip = *implementation_;
  const double position = nip.position(y);
  if (position == 0) return {0, 0};
  const auto at = [&](const Solution& solution, const ContactPlace& place) {
    return nip.tangential(solution, place);
  };
  const auto origin = [&](const Solution& solution) { return nip.tangential_at_origin(solution); };
  Estimate displacement = nip.solved.estimate(nip.at_unsure_place(nip.place(position), at), origin);
  displacement.error += nip.shift_of_origin();
  return times(nip.units.creep * nip.units.length, displacement);
}

Estimate ConvergedViscoelasticNip::surface_strain(double y) const {
  return implementation_->strain(y, false);
}

Estimate ConvergedViscoelasticNip::slip(double y) const { return implementation_->strain(y, true); }

std::vector<InnerStresses> ConvergedViscoelasticNip::inner_stresses(
    std::span<const InnerPoint> points) const {
  const Implementation& nip = *implementation_;
  std::vector<SheetPoint> places;
  for (const InnerPoint& point : points) places.push_back(checked_point(point, nip.units.length));
  auto stresses = nip.field().at(places);
  for (InnerStresses& here : stresses) here = in_unit(nip.units.pressure, here);
  return stresses;
}

GreatestShear ConvergedViscoelasticNip::greatest_shear() const {
  const Implementation& nip = *implementation_;
  const auto [value, y, depth] = nip.field().greatest();
  return {times(nip.units.pressure, value), times(nip.units.length, y), depth};
}

bool ConvergedViscoelasticNip::refine() {
  implementation_->forget();
  return implementation_->solved.refine();
}

Work ConvergedViscoelasticNip::work() const { return implementation_->solved.work(); }

namespace {

std::shared_ptr<const RollingEquations> equations_of(const data::ViscoelasticNip& nip,
                                                     const data::MaterialFunctions& functions) {
  return std::make_shared<const RollingEquations>(rolling_sheet(nip, functions));
}

}  // namespace

ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length,
                                              double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_length(shape(nip), contact_length);
  const data::MaterialFunctions functions = material_functions(nip.material);
  const auto equations = equations_of(nip, functions);
  const double half_length = contact_length / nip.sheet_thickness;
  check_softening(*equations, half_length);
  return ConvergedViscoelasticNip(std::make_unique<ConvergedViscoelasticNip::Implementation>(
      nip, functions.normal_compliance().instantaneous, equations,
      SolvedNip(equations, half_length, {}, accuracy)));
}

ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip& nip, double load, double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_load(load);
  const data::MaterialFunctions functions = material_functions(nip.material);
  const double compliance = functions.normal_compliance().instantaneous;
  const auto equations = equations_of(nip, functions);
  const double unit_load = load / units_of(nip, compliance).load;
  SolvedNip solved(equations, equations->half_length_guess(unit_load), unit_load, accuracy);
  check_length_of_load(shape(nip), load, solved.half_length() * nip.sheet_thickness);
  check_softening(*equations, solved.half_length());
  return ConvergedViscoelasticNip(std::make_unique<ConvergedViscoelasticNip::Implementation>(
      nip, compliance, equations, std::move(solved)));
}

}  // namespace nipref::fast
