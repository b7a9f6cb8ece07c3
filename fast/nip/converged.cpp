#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/converged.hpp>
#include <nipref/fast/nip/internal/inner_field.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {

struct ConvergedNip::Implementation {
  ContactUnits units;
  double roller_radius;
  SolvedNip solved;
  std::optional<double> given_length;                                                ///< unit of length
  mutable std::map<double, std::vector<SolvedNip::InBoth>> kept_along_surface = {};  ///< by Y
  mutable std::optional<SolvedNip::InBoth> kept_creep_ratio = {};
  mutable std::optional<Estimate> kept_offset = {};

  /// Drops what is cached of the solution.
  void forget() {
    kept_along_surface = {};
    kept_creep_ratio.reset();
    kept_offset.reset();
  }
  [[nodiscard]] const NipEquations& equations() const { return solved.equations(); }
  [[nodiscard]] bool is_symmetric() const { return solved.is_symmetric(); }
  [[nodiscard]] double half_length() const { return solved.half_length(); }
  [[nodiscard]] const Estimate& offset() const {
    if (!kept_offset && is_symmetric()) kept_offset = {0, 0};
    if (!kept_offset) {
      kept_offset = solved.estimate(
          [&](const Solution& solution) { return solution.of_unknown(*equations().offset_unknown()); });
      // The half-length, its sum with the offset and the product of this sum with the unit are rounded, and so are, next
      // to an end, the half-length, a place in half-thicknesses and its distance from the middle.
      kept_offset->error += 0x1p-53 * (3 * half_length() + 2 * std::fabs(kept_offset->value));
    }
    return *kept_offset;
  }
  [[nodiscard]] double unsure_end() const { return offset().error + solved.half_length_estimate().error; }
  /// position: half-thicknesses from the line through the centres.
  [[nodiscard]] ContactPlace place(double position) const {
    const double from_middle = position - offset().value;
    return {from_middle < 0, half_length() - std::fabs(from_middle)};
  }
  /// The place of Y. Its distance from the end has no cancellation if the length is given and the contact symmetric.
  [[nodiscard]] ContactPlace place_of(double y) const {
    internal::check_finite("y", y);
    if (!is_symmetric() || !given_length) return place(y / units.length);
    return {y < 0, (*given_length / 2 - std::fabs(y)) / units.length};
  }
  [[nodiscard]] std::vector<SolvedNip::InBoth> at_place(const ContactPlace& place,
                                                        const SolvedNip::AtPlace& numbers) const {
    return solved.at_place(place, SolvedNip::reach(place, unsure_end()), numbers);
  }
  [[nodiscard]] Estimate traction(TractionComponent component, const ContactPlace& place) const {
    const auto at = [&](const Solution& solution, const ContactPlace& there) {
      return std::vector{equations().traction(solution, component, there)};
    };
    return solved.estimate(at_place(place, at).front());
  }
  /// The value of a traction without its error.
  [[nodiscard]] double value(TractionComponent component, double position) const {
    return value(component, place(position));
  }
  [[nodiscard]] double value(TractionComponent component, const ContactPlace& here) const {
    if (!(here.e > 0)) return 0;
    const std::complex<double> g = solved.traction(here.e);
    const double odd = here.trailing ? -g.imag() : g.imag();
    if (!equations().sticks()) return g.real() + odd;
    return component == TractionComponent::pressure ? g.real() : odd;
  }
  /// u of the roller in the contact, and at an end.
  [[nodiscard]] Estimate roller_displacement(double position) const {
    return times(units.displacement, solved.estimate([&](const Solution& solution) {
      return equations().roller_displacement(solution, position);
    }));
  }
  [[nodiscard]] Estimate end_displacement(bool trailing) const {
    return times(units.displacement, solved.estimate([&](const Solution& solution) {
      return equations().end_displacement(solution, trailing);
    }));
  }
  [[nodiscard]] const SolvedNip::InBoth& creep_ratio() const {
    if (!kept_creep_ratio) {
      kept_creep_ratio = solved.in_both([&](const Solution& solution) {
        CountedKernels kernels = solved.kernels();
        return equations().creep_ratio(solution, kernels);
      });
    }
    return *kept_creep_ratio;
  }
  /// v and, without friction, v' at a place.
  [[nodiscard]] const std::vector<SolvedNip::InBoth>& along_surface(double y) const {
    const ContactPlace place = place_of(y);
    if (const auto kept = kept_along_surface.find(y); kept != kept_along_surface.end()) return kept->second;
    CountedKernels kernels = solved.kernels();
    return kept_along_surface[y] = at_place(place, [&](const Solution& solution, const ContactPlace& there) {
             AlongSurface at = equations().along_surface(solution, there, kernels);
             std::vector numbers{std::move(at.displacement)};
             if (!equations().sticks()) numbers.push_back(std::move(at.strain));
             return numbers;
           });
  }
  [[nodiscard]] InnerField field() const {
    return {solved, given_length && is_symmetric() ? 0 : unsure_end()};
  }
  [[nodiscard]] SheetPoint sheet_point(const InnerPoint& point) const {
    check_inside(point);
    return {place_of(point.y), point.depth, is_symmetric() && point.y == 0};
  }
  /// The positions, rising, between which maxima and zeros of tractions are sought, in a symmetric contact those >= 0.
  /// With full friction they become dense towards the end.
  [[nodiscard]] std::vector<double> places() const {
    std::vector<double> result = equations().sticks() ? places_towards_end() : places_on_panels();
    std::ranges::sort(result);
    // Places from panels and layers may coincide; between coinciding places the pressure would look constant.
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
    const double middle = offset().value;
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
    // Layers vary on a scale of their own.
    for (const std::complex<double>& rate : solved.last().tractions().layer_rates()) {
      const double length = std::min(half_length(), 10 / std::abs(rate));
      for (int i = 1; i < 3 * steps; ++i) result.push_back(middle + half_length() - length * i / (3 * steps));
    }
    return result;
  }
  [[nodiscard]] double size(TractionComponent component, double position) const {
    return std::fabs(value(component, position));
  }
  /// The local maxima of the magnitude of a traction.
  [[nodiscard]] std::vector<LocalMaximum> maxima(TractionComponent component) const {
    return local_maxima([&](double position) { return size(component, position); }, places());
  }
  [[nodiscard]] Estimate peak(TractionComponent component) const {
    // An error of the place changes the peak only to second order.
    const ContactPlace there = place(largest_of(maxima(component)).place);
    const Estimate found = solved.estimate(
        [&](const Solution& solution) { return equations().traction(solution, component, there); });
    return times(units.pressure, {std::fabs(found.value), found.error});
  }
  /// Y of the largest magnitude of a traction.
  [[nodiscard]] Estimate peak_position(TractionComponent component) const {
    const LocalSlope local_slope(32);
    const auto at = [&](double position) { return value(component, position); };
    const auto reach = [&](double position) {
      const Tractions& tractions = solved.last().tractions();
      const double e = std::max(place(position).e, 1e-9 * half_length());
      return std::min(e / 4, tractions.panels()[tractions.panel_of(e)].width() / 8);
    };
    const auto sign = [&](const ContactPlace& here) { return here.trailing ? 1 : -1; };
    // All nodes are measured from one end, also beyond the middle. Measured from the other end, the pressure of a given
    // load, which is interpolated between contacts of two lengths, has another error.
    const auto slope = [&](double position) {
      const ContactPlace here = place(position);
      const auto along_half = [&](double e) { return value(component, {here.trailing, e}); };
      return sign(here) * std::copysign(1, at(position)) * local_slope(along_half, here.e, reach(position));
    };
    const auto slope_estimate = [&](double position) {
      const ContactPlace here = place(position);
      return solved.estimate([&](const Solution& solution) {
        const auto row = [&](double e) -> Eigen::RowVectorXd {
          return equations().traction(solution, component, {here.trailing, e}).on_tractions;
        };
        Functional rise = solution.of_tractions(sign(here) * local_slope(row, here.e, reach(position)));
        rise.cancelled = local_slope.condition() * size(component, position) / reach(position);
        return rise;
      });
    };
    const auto estimate = [&](double position) {
      return Estimate{size(component, position), traction(component, place(position)).error};
    };
    return in_contact(
        place_of_maximum(maxima(component), {slope, slope_estimate}, estimate, 2 * half_length()));
  }
  /// Y of a position that was found, with the errors of the position, of the ends and, 2^-53 each, of the search's last
  /// step and of the product with the unit.
  [[nodiscard]] Estimate in_contact(Estimate position) const {
    position.error += unsure_end() + 0x1p-52 * half_length();
    return times(units.length, position);
  }
  void check_shears() const {
    if (!equations().sticks())
      throw data::BadInput("friction", "none", "must be full for places of the shear: there is none");
  }
};

ConvergedNip::ConvergedNip(std::unique_ptr<Implementation> implementation)
    : nip_(std::move(implementation)) {}
ConvergedNip::ConvergedNip(ConvergedNip&&) noexcept = default;
ConvergedNip::~ConvergedNip() = default;

Estimate ConvergedNip::contact_length() const {
  if (nip_->given_length) return {*nip_->given_length, 0};
  return times(2 * nip_->units.length, nip_->solved.half_length_estimate());
}

Estimate ConvergedNip::leading_length() const {
  if (nip_->is_symmetric()) return 0.5 * contact_length();
  return times(nip_->units.length, {nip_->half_length() + nip_->offset().value, nip_->unsure_end()});
}

Estimate ConvergedNip::trailing_length() const {
  if (nip_->is_symmetric()) return 0.5 * contact_length();
  return times(nip_->units.length, {nip_->half_length() - nip_->offset().value, nip_->unsure_end()});
}

Estimate ConvergedNip::load() const {
  return times(nip_->units.load, nip_->solved.estimate(&Solution::load));
}

Estimate ConvergedNip::indentation() const { return nip_->roller_displacement(0); }
Estimate ConvergedNip::leading_displacement() const { return nip_->end_displacement(false); }

Estimate ConvergedNip::trailing_displacement() const { return nip_->end_displacement(true); }

Estimate ConvergedNip::pressure(double y) const {
  return times(nip_->units.pressure, nip_->traction(TractionComponent::pressure, nip_->place_of(y)));
}

Estimate ConvergedNip::shear(double y) const {
  const ContactPlace place = nip_->place_of(y);
  // In the middle the shear is 0, because it is odd.
  if (!nip_->equations().sticks() || y == 0) return {0, 0};
  return times(nip_->units.pressure, nip_->traction(TractionComponent::shear, place));
}

Estimate ConvergedNip::peak_pressure() const { return nip_->peak(TractionComponent::pressure); }

Estimate ConvergedNip::peak_shear() const {
  if (!nip_->equations().sticks()) return {0, 0};
  return nip_->peak(TractionComponent::shear);
}

Estimate ConvergedNip::peak_pressure_position() const {
  if (nip_->is_symmetric()) return {0, 0};
  return nip_->peak_position(TractionComponent::pressure);
}

Estimate ConvergedNip::peak_shear_position() const {
  nip_->check_shears();
  return nip_->peak_position(TractionComponent::shear);
}

std::vector<Estimate> ConvergedNip::shear_zeros() const {
  nip_->check_shears();
  const PlaceFunction shear{
      [&](double position) { return nip_->value(TractionComponent::shear, position); },
      [&](double position) { return nip_->traction(TractionComponent::shear, nip_->place(position)); }};
  std::vector<Estimate> zeros{{0, 0}};
  for (const Estimate& zero : places_of_sure_zeros(shear, nip_->places()))
    zeros.push_back(nip_->in_contact(zero));
  return zeros;
}

Estimate ConvergedNip::rolling_resistance() const {
  if (nip_->is_symmetric()) return {0, 0};
  return times(nip_->units.length / nip_->roller_radius, nip_->solved.estimate([&](const Solution& solution) {
    return nip_->equations().eccentricity(solution);
  }));
}

Estimate ConvergedNip::creep_ratio() const {
  return times(nip_->units.creep, nip_->solved.estimate(nip_->creep_ratio()));
}

Estimate ConvergedNip::normal_displacement(double y) const {
  const ContactPlace place = nip_->place_of(y);
  if (place.e >= 0) return nip_->roller_displacement(y / nip_->units.length);
  const auto at = [&](const Solution& solution, const ContactPlace& there) {
    CountedKernels kernels = nip_->solved.kernels();
    return std::vector{nip_->equations().normal_displacement(solution, there, kernels)};
  };
  return times(nip_->units.displacement, nip_->solved.estimate(nip_->at_place(place, at).front()));
}

Estimate ConvergedNip::tangential_displacement(double y) const {
  const ContactPlace place = nip_->place_of(y);
  if (y == 0) return {0, 0};
  const double unit = nip_->units.creep * nip_->units.length;
  if (nip_->equations().sticks() && place.e >= 0) return times(y, creep_ratio());
  const SolvedNip::InBoth& displacement = nip_->along_surface(y)[0];
  if (nip_->is_symmetric()) return times(unit, nip_->solved.estimate(displacement));
  return times(unit, nip_->solved.estimate(displacement - nip_->along_surface(0)[0]));
}

Estimate ConvergedNip::surface_strain(double y) const {
  // Without friction the strain beside an end is a smooth function less a multiple of the pressure, which rises with the
  // distance from the end, so that shifts of the place to both sides show its error (SolvedNip::at_place).
  if (!nip_->equations().sticks())
    return times(nip_->units.creep, nip_->solved.estimate(nip_->along_surface(y)[1]));
  const ContactPlace place = nip_->place_of(y);
  if (place.e < 0) return times(nip_->units.creep / 2, nip_->field().at({place, 1, false}).along);
  Estimate creep = creep_ratio();
  // If the end may be farther inwards, the strain may be that outside the contact. At the distance d <= unsure_end() - e
  // from the end it differs from the creep by the Hilbert transform of the shear, at most |g(d)| inside. As g(e) or its
  // change to g(e + unsure_end()) is half of the latter or more, twice the errors of both tractions cover it.
  if (place.e < nip_->unsure_end()) {
    for (const auto component : {TractionComponent::pressure, TractionComponent::shear})
      creep.error += 2 * nip_->units.creep * nip_->traction(component, place).error;
  }
  return creep;
}

Estimate ConvergedNip::slip(double y) const {
  if (!nip_->equations().sticks())
    return times(nip_->units.creep, nip_->solved.estimate(nip_->along_surface(y)[1] - nip_->creep_ratio()));
  if (nip_->place_of(y).e >= nip_->unsure_end()) return {0, 0};
  const Estimate strain = surface_strain(y), creep = creep_ratio();
  return {strain.value - creep.value, strain.error + creep.error};
}

std::vector<InnerStresses> ConvergedNip::inner_stresses(std::span<const InnerPoint> points) const {
  std::vector<InnerStresses> result;
  for (const InnerPoint& point : points) {
    InnerStresses& here = result.emplace_back(nip_->field().at(nip_->sheet_point(point)));
    for (Estimate* stress : {&here.across, &here.along, &here.shear})
      *stress = times(nip_->units.pressure, *stress);
  }
  return result;
}

std::vector<InnerDisplacements> ConvergedNip::inner_displacements(std::span<const InnerPoint> points) const {
  const auto shares = nip_->equations().shares();
  if (!shares) throw data::BadInput("nip", "rolling", "must be elastic for displacements inside the sheet");
  std::vector<InnerDisplacements> result;
  std::map<double, InnerDisplacements> of_faces;
  for (const InnerPoint& point : points) {
    const InnerDisplacements beyond = nip_->field().from_face(nip_->sheet_point(point), *shares);
    const auto [face, is_new] = of_faces.try_emplace(point.y);
    if (is_new) face->second = {normal_displacement(point.y), tangential_displacement(point.y)};
    result.push_back(beyond_face(face->second, point.depth, nip_->units.displacement, beyond));
  }
  return result;
}

GreatestShear ConvergedNip::greatest_shear() const {
  const auto [value, y, depth] = nip_->field().greatest_shear();
  return {times(nip_->units.pressure, value), nip_->in_contact({y.value + nip_->offset().value, y.error}),
          depth};
}

bool ConvergedNip::refine() {
  nip_->forget();
  return nip_->solved.refine();
}

Work ConvergedNip::work() const { return nip_->solved.work(); }

ConvergedNip converged_nip(const NipShape& shape, double compliance,
                           std::shared_ptr<const NipEquations> equations, const GivenContact& given,
                           double accuracy) {
  check_contact_accuracy(accuracy);
  const ContactUnits units(shape, compliance);
  std::optional<double> load;
  if (given.length) check_contact_length(shape, *given.length);
  if (given.load) {
    internal::check_positive("load", *given.load);
    load = *given.load / units.load;
  }
  const double half_length = load ? equations->half_length_of(*load) : *given.length / shape.sheet_thickness;
  if (!load) equations->check(half_length);
  SolvedNip solved(equations, half_length, load, accuracy);
  if (load) {
    check_length_of_load(shape, *given.load, solved.half_length() * shape.sheet_thickness);
    equations->check(solved.half_length());
  }
  return ConvergedNip(std::make_unique<ConvergedNip::Implementation>(
      ConvergedNip::Implementation{units, shape.roller_radius, std::move(solved), given.length}));
}

}  // namespace nipref::fast
