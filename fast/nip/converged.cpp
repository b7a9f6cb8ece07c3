#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/converged.hpp>
#include <nipref/fast/nip/internal/contact_field.hpp>
#include <nipref/fast/nip/internal/converged_nip.hpp>
#include <nipref/fast/nip/internal/kept.hpp>
#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>
#include <nipref/fast/number/internal/sampled_maximum.hpp>

namespace nipref::fast {

struct ConvergedNip::Implementation {
  ContactUnits units;
  double roller_radius;
  std::shared_ptr<const NipEquations> equations;
  SolvedNip solved;
  std::optional<double> given_length;  ///< unit of length
  mutable std::optional<ContactField> inner_field = {};
  /// v and v' at a place; v' without friction.
  struct Along {
    SolvedNip::InBoth displacement, strain;
  };
  mutable Kept<double, Along> places_along = {};  ///< by Y
  mutable std::optional<SolvedNip::InBoth> mean_strain = {};

  /// What is kept of solutions that are no more.
  void forget() {
    inner_field.reset();
    places_along = {};
    mean_strain.reset();
  }
  [[nodiscard]] bool is_symmetric() const { return !equations->offset_unknown(); }
  [[nodiscard]] double half_length() const { return solved.half_length(); }
  [[nodiscard]] double offset() const {
    if (is_symmetric()) return 0;
    return solved.value(
        [&](const Solution& solution) { return solution.unknown(*equations->offset_unknown()); });
  }
  [[nodiscard]] double offset_error() const {
    if (is_symmetric()) return 0;
    const auto offset = [&](const Solution& solution) {
      return solution.of_unknown(*equations->offset_unknown());
    };
    return solved.estimate(offset).error + 0x1p-52 * half_length();
  }
  [[nodiscard]] double unsure_end() const { return offset_error() + solved.half_length_estimate().error; }
  /// position: half-thicknesses from the line through the centres.
  [[nodiscard]] ContactPlace place(double position) const {
    const double from_middle = position - offset();
    return {from_middle < 0, half_length() - std::fabs(from_middle)};
  }
  /// Of Y; its distance from the end is without loss where the length is given and the contact symmetric.
  [[nodiscard]] ContactPlace place_of(double y) const {
    check_position(y);
    if (!is_symmetric() || !given_length) return place(y / units.length);
    return {y < 0, (*given_length / 2 - std::fabs(y)) / units.length};
  }
  /// A functional of a place that is known as well as the contact's ends.
  template <class AtPlace>
  [[nodiscard]] static SolvedNip::AtPlace at_distance(bool trailing, const AtPlace& at) {
    return [&at, trailing](const Solution& solution, double e) {
      return at(solution, ContactPlace{trailing, e});
    };
  }
  template <class AtPlace>
  [[nodiscard]] SolvedNip::InBoth at_unsure_place(const ContactPlace& place, const AtPlace& at) const {
    return solved.at_place(place.e, unsure_end(), at_distance(place.trailing, at));
  }
  [[nodiscard]] auto traction(TractionComponent component) const {
    return [this, component](const Solution& solution, const ContactPlace& place) {
      return equations->traction(solution, component, place);
    };
  }
  [[nodiscard]] Estimate traction(TractionComponent component, const ContactPlace& place) const {
    return solved.estimate(at_unsure_place(place, traction(component)));
  }
  /// Its value alone.
  [[nodiscard]] double value(TractionComponent component, double position) const {
    const ContactPlace here = place(position);
    if (!(here.e > 0)) return 0;
    const std::complex<double> g = solved.traction(here.e);
    const double odd = here.trailing ? -g.imag() : g.imag();
    if (!equations->grips()) return g.real() + odd;
    return component == TractionComponent::pressure ? g.real() : odd;
  }
  /// u of the roller in the contact, and at an end.
  [[nodiscard]] Estimate roller_displacement(double position) const {
    return times(units.displacement, solved.estimate([&](const Solution& solution) {
      return equations->roller_displacement(solution, position);
    }));
  }
  [[nodiscard]] Estimate end_displacement(bool trailing) const {
    return times(units.displacement, solved.estimate([&](const Solution& solution) {
      return equations->end_displacement(solution, trailing);
    }));
  }
  [[nodiscard]] const SolvedNip::InBoth& creep() const {
    if (!mean_strain) {
      mean_strain = solved.in_both([&](const Solution& solution) {
        CountedKernels kernels = solved.kernels();
        return equations->creep(solution, kernels);
      });
    }
    return *mean_strain;
  }
  [[nodiscard]] const Along& along(double y) const {
    return places_along.of(y, [&] {
      const ContactPlace place = place_of(y);
      CountedKernels kernels = solved.kernels();
      if (!equations->grips()) return sliding_along(place, kernels);
      const auto displacement = [&](const Solution& solution, const ContactPlace& there) {
        return equations->along(solution, there, kernels).displacement;
      };
      return Along{at_unsure_place(place, displacement), {}};
    });
  }
  /// The displacement is shifted by the reach times the sum of the strain here and what that changes by
  /// towards both ends of the reach.
  [[nodiscard]] Along sliding_along(const ContactPlace& place, CountedKernels& kernels) const {
    SurfaceAlong here = equations->along(solved.last(), place, kernels);
    Along result{{std::move(here.displacement)}, {std::move(here.strain)}};
    if (solved.there() != nullptr) {
      SurfaceAlong there = equations->along(*solved.there(), place, kernels);
      result.displacement.there = std::move(there.displacement);
      result.strain.there = std::move(there.strain);
    }
    const auto strain = [&](const Solution& solution, const ContactPlace& moved) {
      return equations->strain(solution, moved);
    };
    const double value = solved.last().value(result.strain.here);
    result.strain.shift =
        solved.shift(result.strain.here, place.e, unsure_end(), at_distance(place.trailing, strain));
    result.displacement.shift =
        SolvedNip::reach(place.e, unsure_end()) * (std::fabs(value) + result.strain.shift);
    return result;
  }
  [[nodiscard]] const ContactField& field() const {
    if (!inner_field) inner_field.emplace(solved, is_symmetric(), offset(), unsure_end());
    return *inner_field;
  }
  /// Rising positions at which tractions are looked at, in a symmetric contact those >= 0. With full friction they are the
  /// closer, the nearer the end is.
  [[nodiscard]] std::vector<double> places() const {
    std::vector<double> result = equations->grips() ? places_towards_end() : places_on_panels();
    std::ranges::sort(result);
    // Places of several lists may coincide; between two of them the pressure would look constant.
    const auto coincide = [&](double left, double right) {
      return right - left <= 1e-6 * std::fabs(place(right).e);
    };
    const auto rest = std::ranges::unique(result, coincide);
    result.erase(rest.begin(), rest.end());
    return result;
  }
  [[nodiscard]] std::vector<double> places_towards_end() const {
    constexpr int steps = 400;
    constexpr double nearest = 1e-6;
    std::vector<double> result;
    for (int i = 0; i <= steps; ++i)
      result.push_back(half_length() * (1 - std::pow(nearest, static_cast<double>(i) / steps)));
    return result;
  }
  [[nodiscard]] std::vector<double> places_on_panels() const {
    constexpr int steps = 16;
    const double middle = offset();
    std::vector<double> result;
    if (is_symmetric()) result.push_back(0);
    for (const Panel& panel : solved.last().tractions().panels()) {
      const double right = std::min(panel.right, half_length());
      for (int i = 0; i < steps; ++i) {
        const double from_middle = half_length() - (panel.left + (right - panel.left) * (i + 0.5) / steps);
        result.push_back(middle + from_middle);
        if (!is_symmetric()) result.push_back(middle - from_middle);
      }
    }
    // Layers have their own scale.
    for (const std::complex<double>& rate : solved.last().tractions().layer_rates()) {
      const double length = std::min(half_length(), 10 / std::abs(rate));
      for (int i = 1; i < 3 * steps; ++i) result.push_back(middle + half_length() - length * i / (3 * steps));
    }
    return result;
  }
  /// The largest magnitude of a traction.
  [[nodiscard]] Estimate peak(TractionComponent component) const {
    const std::vector<double> places = this->places();
    const auto between = [&](double i) {
      const auto before = static_cast<std::size_t>(i);
      const double part = i - std::floor(i), next = places[std::min(before + 1, places.size() - 1)];
      return (1 - part) * places[before] + part * next;
    };
    const auto size = [&](double i) { return std::fabs(value(component, between(i))); };
    const double best = internal::place_of_sampled_maximum(size, static_cast<int>(places.size()) - 1);
    // To first order the place does not matter.
    const ContactPlace there = place(between(best));
    const Estimate found = solved.estimate(
        [&](const Solution& solution) { return equations->traction(solution, component, there); });
    return times(units.pressure, {std::fabs(found.value), found.error});
  }
  /// Y of the largest magnitude of a traction.
  [[nodiscard]] Estimate peak_position(TractionComponent component) const {
    const LocalSlope local_slope(32);
    const auto at = [&](double position) { return value(component, position); };
    const auto size = [&](double position) { return std::fabs(at(position)); };
    const auto reach = [&](double position) {
      const Tractions& tractions = solved.last().tractions();
      const double e = std::max(place(position).e, 1e-9 * half_length());
      return std::min(e / 4, tractions.panels()[tractions.panel_of(e)].width() / 8);
    };
    const auto slope = [&](double position) {
      return std::copysign(1, at(position)) * local_slope(at, position, reach(position));
    };
    const auto slope_estimate = [&](double position) {
      const ContactPlace here = place(position);
      return solved.estimate([&](const Solution& solution) {
        const auto row = [&](double e) -> Eigen::RowVectorXd {
          return equations->traction(solution, component, {here.trailing, e}).on_tractions;
        };
        Functional rise =
            solution.of_tractions((here.trailing ? 1 : -1) * local_slope(row, here.e, reach(position)));
        rise.cancelled = local_slope.condition() * size(position) / reach(position);
        return rise;
      });
    };
    const auto difference = [&](double position, double other) {
      const Estimate here = traction(component, place(position)), there = traction(component, place(other));
      return Estimate{std::fabs(here.value) - std::fabs(there.value), here.error + there.error};
    };
    return in_contact(place_of_maximum(size, {slope, slope_estimate}, difference, places()));
  }
  /// Y of a position that was sought: its own error, and that of the ends and of rounding.
  [[nodiscard]] Estimate in_contact(Estimate position) const {
    position.error += unsure_end() + 0x1p-52 * half_length();
    return times(units.length, position);
  }
  void check_shears() const {
    if (!equations->grips())
      throw data::BadInput("friction", "none", "must be full for places of the shear: there is none");
  }
};

ConvergedNip::ConvergedNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedNip::ConvergedNip(ConvergedNip&&) noexcept = default;
ConvergedNip::~ConvergedNip() = default;

Estimate ConvergedNip::contact_length() const {
  const Implementation& nip = *implementation_;
  if (nip.given_length) return {*nip.given_length, 0};
  return times(2 * nip.units.length, nip.solved.half_length_estimate());
}

Estimate ConvergedNip::leading_length() const {
  const Implementation& nip = *implementation_;
  if (nip.is_symmetric()) return 0.5 * contact_length();
  return times(nip.units.length, {nip.half_length() + nip.offset(), nip.unsure_end()});
}

Estimate ConvergedNip::trailing_length() const {
  const Implementation& nip = *implementation_;
  if (nip.is_symmetric()) return 0.5 * contact_length();
  return times(nip.units.length, {nip.half_length() - nip.offset(), nip.unsure_end()});
}

Estimate ConvergedNip::load() const {
  return times(implementation_->units.load, implementation_->solved.estimate(&Solution::load));
}

Estimate ConvergedNip::indentation() const { return implementation_->roller_displacement(0); }

Estimate ConvergedNip::leading_displacement() const { return implementation_->end_displacement(false); }

Estimate ConvergedNip::trailing_displacement() const { return implementation_->end_displacement(true); }

Estimate ConvergedNip::pressure(double y) const {
  const Implementation& nip = *implementation_;
  return times(nip.units.pressure, nip.traction(TractionComponent::pressure, nip.place_of(y)));
}

Estimate ConvergedNip::shear(double y) const {
  const Implementation& nip = *implementation_;
  const ContactPlace place = nip.place_of(y);
  // In the middle it changes its sign.
  if (!nip.equations->grips() || y == 0) return {0, 0};
  return times(nip.units.pressure, nip.traction(TractionComponent::shear, place));
}

Estimate ConvergedNip::peak_pressure() const { return implementation_->peak(TractionComponent::pressure); }

Estimate ConvergedNip::peak_shear() const {
  if (!implementation_->equations->grips()) return {0, 0};
  return implementation_->peak(TractionComponent::shear);
}

Estimate ConvergedNip::peak_pressure_position() const {
  if (implementation_->is_symmetric()) return {0, 0};
  return implementation_->peak_position(TractionComponent::pressure);
}

Estimate ConvergedNip::peak_shear_position() const {
  implementation_->check_shears();
  return implementation_->peak_position(TractionComponent::shear);
}

std::vector<Estimate> ConvergedNip::shear_zeros() const {
  const Implementation& nip = *implementation_;
  nip.check_shears();
  const PlaceFunction shear{
      [&](double position) { return nip.value(TractionComponent::shear, position); },
      [&](double position) { return nip.traction(TractionComponent::shear, nip.place(position)); }};
  std::vector<Estimate> zeros{{0, 0}};
  for (const Estimate& zero : places_of_sure_zeros(shear, nip.places()))
    zeros.push_back(nip.in_contact(zero));
  return zeros;
}

Estimate ConvergedNip::rolling_resistance() const {
  const Implementation& nip = *implementation_;
  if (nip.is_symmetric()) return {0, 0};
  return times(nip.units.length / nip.roller_radius, nip.solved.estimate([&](const Solution& solution) {
    return nip.equations->eccentricity(solution);
  }));
}

Estimate ConvergedNip::creep_ratio() const {
  const Implementation& nip = *implementation_;
  return times(nip.units.creep, nip.solved.estimate(nip.creep()));
}

Estimate ConvergedNip::normal_displacement(double y) const {
  const Implementation& nip = *implementation_;
  const ContactPlace place = nip.place_of(y);
  if (place.e >= 0) return nip.roller_displacement(y / nip.units.length);
  const auto at = [&](const Solution& solution, const ContactPlace& there) {
    CountedKernels kernels = nip.solved.kernels();
    return nip.equations->normal(solution, there, kernels);
  };
  return times(nip.units.displacement, nip.solved.estimate(nip.at_unsure_place(place, at)));
}

Estimate ConvergedNip::tangential_displacement(double y) const {
  const Implementation& nip = *implementation_;
  const ContactPlace place = nip.place_of(y);
  if (y == 0) return {0, 0};
  const double unit = nip.units.creep * nip.units.length;
  if (nip.equations->grips() && place.e >= 0) return times(y, creep_ratio());
  const SolvedNip::InBoth& displacement = nip.along(y).displacement;
  if (nip.is_symmetric()) return times(unit, nip.solved.estimate(displacement));
  return times(unit, nip.solved.estimate(displacement - nip.along(0).displacement));
}

Estimate ConvergedNip::surface_strain(double y) const {
  const Implementation& nip = *implementation_;
  if (!nip.equations->grips()) return times(nip.units.creep, nip.solved.estimate(nip.along(y).strain));
  const ContactPlace place = nip.place_of(y);
  if (place.e < 0)
    return times(nip.units.creep / 2, nip.field().at({{y / nip.units.length, 1}}).front().along);
  Estimate creep = creep_ratio();
  // Where the end may be farther inwards, the strain is that outside.
  if (place.e < nip.unsure_end())
    creep.error += nip.units.creep * (nip.traction(TractionComponent::pressure, place).error +
                                      2 * nip.traction(TractionComponent::shear, place).error);
  return creep;
}

Estimate ConvergedNip::slip(double y) const {
  const Implementation& nip = *implementation_;
  if (!nip.equations->grips())
    return times(nip.units.creep, nip.solved.estimate(nip.along(y).strain - nip.creep()));
  if (nip.place_of(y).e >= nip.unsure_end()) return {0, 0};
  const Estimate strain = surface_strain(y), creep = creep_ratio();
  return {strain.value - creep.value, strain.error + creep.error};
}

std::vector<InnerStresses> ConvergedNip::inner_stresses(std::span<const InnerPoint> points) const {
  const Implementation& nip = *implementation_;
  auto stresses = nip.field().at(checked_points(points, nip.units.length));
  for (InnerStresses& here : stresses) here = in_unit(nip.units.pressure, here);
  return stresses;
}

std::vector<InnerDisplacements> ConvergedNip::inner_displacements(std::span<const InnerPoint> points) const {
  const Implementation& nip = *implementation_;
  const auto shares = nip.equations->shares();
  if (!shares) throw data::BadInput("nip", "rolling", "must be elastic for displacements inside the sheet");
  auto displacements = nip.field().from_face(checked_points(points, nip.units.length), *shares);
  Kept<double, InnerDisplacements> of_face;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [y, depth] = points[i];
    const InnerDisplacements& face = of_face.of(y, [&, y = y] {
      return InnerDisplacements{normal_displacement(y), tangential_displacement(y)};
    });
    displacements[i] = beyond_face(face, depth, nip.units.displacement, displacements[i]);
  }
  return displacements;
}

GreatestShear ConvergedNip::greatest_shear() const {
  const Implementation& nip = *implementation_;
  const auto [value, y, depth] = nip.field().greatest();
  return {times(nip.units.pressure, value), times(nip.units.length, y), depth};
}

bool ConvergedNip::refine() {
  implementation_->forget();
  return implementation_->solved.refine();
}

Work ConvergedNip::work() const { return implementation_->solved.work(); }

ConvergedNip converged_nip(const NipShape& shape, double compliance,
                           std::shared_ptr<const NipEquations> equations, const GivenContact& given,
                           double accuracy) {
  check_contact_accuracy(accuracy);
  const ContactUnits units(shape, compliance);
  std::optional<double> load;
  if (given.length) check_contact_length(shape, *given.length);
  if (given.load) {
    check_contact_load(*given.load);
    load = *given.load / units.load;
  }
  const double half_length =
      load ? equations->half_length_guess(*load) : *given.length / shape.sheet_thickness;
  if (!load) equations->check(half_length);
  SolvedNip solved(equations, half_length, load, accuracy);
  if (load) {
    check_length_of_load(shape, *given.load, solved.half_length() * shape.sheet_thickness);
    equations->check(solved.half_length());
  }
  return ConvergedNip(std::make_unique<ConvergedNip::Implementation>(ConvergedNip::Implementation{
      units, shape.roller_radius, std::move(equations), std::move(solved), given.length}));
}

}  // namespace nipref::fast
