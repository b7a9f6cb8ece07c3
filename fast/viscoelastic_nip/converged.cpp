#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/nip/internal/contact_field.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/internal/functionals.hpp>
#include <nipref/fast/viscoelastic_nip/internal/levels.hpp>
#include <nipref/fast/viscoelastic_nip/internal/short_memories.hpp>

namespace nipref::fast {
namespace {

NipShape shape(const data::ViscoelasticNip& nip) { return {nip.roller_radius, nip.sheet_thickness}; }

ContactUnits units_of(const data::ViscoelasticNip& nip, const EffectiveSheet& sheet) {
  return {shape(nip), sheet.compliance};
}

/// What a contact of about this load meets: its length is guessed for a sheet whose memories are all those that
/// the shortest contact meets.
EffectiveSheet effective_sheet_for_load(const data::ViscoelasticNip& nip, double load, double accuracy) {
  const data::MaterialFunctions functions = material_functions(nip.material);
  const EffectiveSheet shortest = effective_sheet(nip, functions, shortest_half_length, accuracy);
  const ViscoelasticNipLevels levels(shortest.material);
  return effective_sheet(nip, functions, levels.half_length_guess(load / units_of(nip, shortest).load),
                         accuracy);
}

/// Beyond it pressures are nearly as large next to the leading end as where nothing gives way at once, and levels
/// alike there by chance: from five times that on peaks were wrong by more than their estimates.
void check_softening(const ViscoelasticNipLevels& levels, double half_length) {
  constexpr double most = 3e4;
  const double softening = levels.softening_over(half_length);
  if (!(softening <= most))
    throw data::BadInput(
        "nip.material", softening,
        "times as soft over the contact as at once, must be at most 3e4 times: with less at once "
        "the pressure at the leading end is nearly infinite");
}

}  // namespace

struct ConvergedViscoelasticNip::Implementation {
  Implementation(const data::ViscoelasticNip& nip, EffectiveSheet met, ViscoelasticNipLadder solved)
      : units(units_of(nip, met)),
        roller_radius(nip.roller_radius),
        sheet(std::move(met)),
        ladder(std::move(solved)) {}

  ContactUnits units;
  double roller_radius;
  EffectiveSheet sheet;
  ViscoelasticNipLadder ladder;
  /// What the surface's strains in the halves of the contact contribute to their mean, dimensionless.
  struct HalfStrains {
    double leading, trailing;
  };
  /// Of solutions of which they were asked for.
  mutable std::map<const ViscoelasticPressure*, HalfStrains> strains;

  [[nodiscard]] double half_length() const { return ladder.last().half_length(); }
  [[nodiscard]] double neglected() const { return sheet.neglected(half_length()); }
  /// With what the sheet's short memories do beside, relative to the same scale.
  [[nodiscard]] Estimate with_neglected(const Estimate& solved, double scale) const {
    return {solved.value, solved.error + neglected() * std::max(scale, std::fabs(solved.value))};
  }
  [[nodiscard]] Estimate estimate(const ViscoelasticNipLadder::Functional& functional, double scale = 0,
                                  Rate rate = Rate::of_expansions) const {
    return with_neglected(ladder.estimate(functional, scale, rate), scale);
  }
  [[nodiscard]] Estimate estimate_of_integral(const ViscoelasticNipLadder::Functional& functional,
                                              double scale) const {
    return with_neglected(ladder.estimate_of_integral(functional, scale), scale);
  }
  [[nodiscard]] ContactField<ViscoelasticNipLadder> field() const;
  [[nodiscard]] const HalfStrains& half_strains(const ViscoelasticPressure& contact,
                                                CountedKernels& kernels) const {
    const auto [known, is_new] = strains.try_emplace(&contact);
    if (is_new) {
      const auto strain = [&](const ContactPlace& place, const ContactPlace& reference) {
        return contact.tangential_displacement(place, reference, ladder.tolerance(), kernels) /
               (2 * contact.half_length());
      };
      const ContactPlace middle{Half::leading, contact.half_length()};
      known->second = {strain({Half::leading, 0}, middle), strain(middle, {Half::trailing, 0})};
    }
    return known->second;
  }
  /// Mean strain of the surface in the contact, dimensionless.
  [[nodiscard]] double creep(const ViscoelasticPressure& contact, CountedKernels& kernels) const {
    const HalfStrains& of = half_strains(contact, kernels);
    return of.leading + of.trailing;
  }
  /// What the creep is relative to, dimensionless: the halves may nearly cancel in the mean.
  [[nodiscard]] double creep_size(CountedKernels& kernels) const {
    const auto [leading, trailing] = half_strains(ladder.last(), kernels);
    return std::fabs(leading) + std::fabs(trailing);
  }
  [[nodiscard]] double creep_rounding(CountedKernels& kernels) const {
    return difference_rounding * ladder.last().tangential_size(ladder.tolerance(), kernels) / half_length();
  }
  /// The surface's strain at y beyond `zero`, a strain of each solution that is at most about `zero_size`,
  /// dimensionless.
  [[nodiscard]] Estimate strain_beyond(const ViscoelasticNipLadder::Functional& zero, double zero_size,
                                       double y) const;
  /// What the pressure's expansion at `place` is about to leave out: where it converges more slowly than elsewhere, the
  /// last one lacks more than levels tell.
  [[nodiscard]] double tail_at(const ContactPlace& place) const {
    return place.e > 0 ? ladder.last().tail_at({place.half, std::min(place.e, half_length())}) : 0;
  }
  /// How well the nearer end of the contact is known, half-thicknesses.
  [[nodiscard]] double unsure_end(Half half) const {
    return estimate(std::mem_fn(half == Half::leading ? &ViscoelasticPressure::leading_length
                                                      : &ViscoelasticPressure::trailing_length),
                    half_length())
        .error;
  }
  /// How large a normal displacement can be at `place`, outside the contact.
  [[nodiscard]] double displacement_size(const ContactPlace& place) const {
    double slowest = 2;
    if (place.half == Half::trailing) {
      for (const MemoryTerm& term : sheet.material.normal) slowest = std::min(slowest, term.rate.real());
    }
    return std::pow(half_length(), 2) * faded(-place.e, slowest);
  }
  /// Dimensionless, at Y half-thicknesses.
  [[nodiscard]] Estimate pressure_at(double position) const;
  /// Dimensionless Y.
  [[nodiscard]] double position(double y) const {
    check_position(y);
    return y / units.length;
  }
};

namespace {

/// 0 outside the contact.
double pressure(const ViscoelasticPressure& contact, const ContactPlace& place) {
  return place.e > 0 ? contact.pressure({place.half, std::min(place.e, contact.half_length())}) : 0;
}

FieldOfContact field_of_pressure(const ViscoelasticPressure& contact) {
  const auto traction = [&](bool right, double e) -> FaceTraction {
    return {contact.pressure({right ? Half::leading : Half::trailing, std::min(e, contact.half_length())}),
            0};
  };
  return {TractionField(contact.half_length(), false, traction), contact.offset(), contact.half_length()};
}

/// What is further than half the contact from one end, counted from the other.
ContactPlace across(double half_length, Half half, double e) {
  return {half == Half::leading ? Half::trailing : Half::leading, 2 * half_length - e};
}

/// How far from y the pressure is one polynomial of its panel's degree, or nearly: well inside the contact.
double slope_reach(const ViscoelasticPressure& contact, double y) {
  const ContactPlace place = contact.place(y);
  const double e = std::max(place.e, 1e-9 * contact.half_length());
  const ViscoelasticPanel& panel = contact.layout().panels()[contact.layout().panel_of({place.half, e})];
  return std::min(e / 4, panel.width / 2);
}

/// Where the pressure of a panel is looked at, Y in half-thicknesses.
void add_places(const ViscoelasticPanel& panel, const ViscoelasticPressure& contact,
                std::vector<double>& places) {
  constexpr int steps = 12;
  for (int i = 0; i < steps; ++i) {
    const double e = panel.left + panel.width * (i + 0.5) / steps, from_middle = contact.half_length() - e;
    places.push_back(contact.offset() + (panel.half == Half::leading ? from_middle : -from_middle));
  }
}

}  // namespace

ContactField<ViscoelasticNipLadder> ConvergedViscoelasticNip::Implementation::field() const {
  const double unsure = std::max(unsure_end(Half::leading), unsure_end(Half::trailing));
  const auto neglected_there = [this](double away) {
    return sheet.neglected_near_end(half_length(), std::min(away, half_length()));
  };
  return {ladder, field_of_pressure, fast::peak_pressure(ladder.last()), {unsure, neglected_there}};
}

Estimate ConvergedViscoelasticNip::Implementation::pressure_at(double position) const {
  // At its distance from each level's own end the pressure is smooth; levels that agree there by chance do not beside
  // it. Then it matters how well the end is known.
  const ContactPlace place = ladder.last().place(position);
  const double to_middle = half_length();
  const double middle = ladder.last().pressure({Half::leading, to_middle});
  const auto at = [&](double e) {
    const ContactPlace there =
        e <= to_middle ? ContactPlace{place.half, e} : across(to_middle, place.half, e);
    return ladder.estimate(
        [&](const ViscoelasticPressure& contact) { return fast::pressure(contact, there); },
        e > 0 ? middle : 0);
  };
  Estimate solved = at(place.e);
  for (const double beside : {0.8 * place.e, std::min(1.25 * place.e, to_middle), 1.25 * place.e})
    solved.error = std::max(solved.error, at(beside).error);
  solved.error = std::max(solved.error, tail_at(place));
  if (place.e > 0) solved.error += middle * sheet.neglected_near_end(to_middle, place.e);
  const double unsure = unsure_end(place.half);
  double shifted = 0;
  for (const double moved : {place.e - unsure, place.e + unsure})
    shifted = std::max(shifted, std::fabs(fast::pressure(ladder.last(), {place.half, moved}) - solved.value));
  solved.error += shifted;
  return solved;
}

Estimate ConvergedViscoelasticNip::Implementation::strain_beyond(
    const ViscoelasticNipLadder::Functional& zero, double zero_size, double y) const {
  const double middle = position(y);
  CountedKernels kernels = ladder.kernels();
  const auto strain_at = [&](const ViscoelasticPressure& contact, const ContactPlace& place) {
    const double e = std::min(place.e, contact.half_length());
    return contact.strain({place.half, e}, ladder.tolerance(), kernels) - zero(contact);
  };
  // As for the pressure: at its distance from each level's own end, beside it, and as far as the end is known.
  const ViscoelasticPressure& last = ladder.last();
  const ContactPlace place = last.place(middle);
  const double peak = fast::peak_pressure(last);
  // What the pressure does where it acts, and what the sheet does beside it.
  const double size = peak * (std::fabs(sheet.material.theta2_instantaneous) + std::min(half_length(), 1.0));
  const double scale =
      zero_size + (place.e > 0 ? size : displacement_size(place) / (half_length() * half_length()) * size);
  const auto at = [&](double e) {
    return ladder.estimate_of_fading(
        [&, e](const ViscoelasticPressure& contact) {
          return strain_at(contact, {place.half, e});
        },
        size + zero_size, scale);
  };
  Estimate strain = at(place.e);
  for (const double beside : {0.8 * place.e, 1.25 * place.e})
    strain.error = std::max(strain.error, at(beside).error);
  strain = with_neglected(strain, scale);
  if (place.e > 0) strain.error += peak * sheet.neglected_near_end(half_length(), place.e);
  const double unsure = unsure_end(place.half);
  if (place.e <= 0 && place.half == Half::trailing)
    strain.error += peak * sheet.neglected_behind(half_length(), std::max(-place.e - unsure, 0.0));
  double shifted = 0;
  for (const double moved : {place.e - unsure, place.e + unsure})
    shifted = std::max(shifted, std::fabs(strain_at(last, {place.half, moved}) - strain.value));
  strain.error += shifted;
  // What the pressure lacks there it makes at once; next to an end that may round more than all else.
  if (place.e > 0)
    strain.error =
        std::max(strain.error, std::fabs(sheet.material.theta2_instantaneous) * pressure_at(middle).error);
  return strain;
}

ConvergedViscoelasticNip::ConvergedViscoelasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedViscoelasticNip::ConvergedViscoelasticNip(ConvergedViscoelasticNip&&) noexcept = default;
ConvergedViscoelasticNip::~ConvergedViscoelasticNip() = default;

Estimate ConvergedViscoelasticNip::contact_length() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  return times(2 * units.length, implementation_->estimate(std::mem_fn(&ViscoelasticPressure::half_length)));
}

Estimate ConvergedViscoelasticNip::leading_length() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  return times(units.length, implementation_->estimate(std::mem_fn(&ViscoelasticPressure::leading_length),
                                                       implementation_->half_length()));
}

Estimate ConvergedViscoelasticNip::trailing_length() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  return times(units.length, implementation_->estimate(std::mem_fn(&ViscoelasticPressure::trailing_length),
                                                       implementation_->half_length()));
}

Estimate ConvergedViscoelasticNip::load() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  return times(units.load, implementation_->estimate(std::mem_fn(&ViscoelasticPressure::load)));
}

Estimate ConvergedViscoelasticNip::indentation() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  return times(units.displacement, implementation_->estimate(fast::indentation));
}

Estimate ConvergedViscoelasticNip::leading_displacement() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  return times(units.displacement,
               implementation_->estimate(std::mem_fn(&ViscoelasticPressure::edge_displacement),
                                         std::pow(implementation_->half_length(), 2)));
}

Estimate ConvergedViscoelasticNip::trailing_displacement() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  return times(units.displacement, implementation_->estimate(fast::trailing_displacement,
                                                             std::pow(implementation_->half_length(), 2)));
}

Estimate ConvergedViscoelasticNip::pressure(double y) const {
  const double position = implementation_->position(y);
  return times(implementation_->units.pressure, implementation_->pressure_at(position));
}

Estimate ConvergedViscoelasticNip::peak_pressure() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  Estimate peak = implementation_->estimate(fast::peak_pressure);
  peak.error *= 2;  // levels are alike by chance more often where the place of the maximum moves
  const double half_length = implementation_->half_length();
  peak.error += peak.value * sheet.neglected_near_end(half_length, place_of_peak(ladder.last()).e);
  // At an end the pressure could be larger still.
  const double at_end = sheet.neglected_near_end(half_length, 0);
  if (at_end > 1) peak.error += at_end * peak.value;
  return times(units.pressure, peak);
}

Estimate ConvergedViscoelasticNip::peak_pressure_position() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  const ViscoelasticPressure& last = ladder.last();
  const double half_length = last.half_length(), largest = fast::peak_pressure(last);
  const auto at = [](const ViscoelasticPressure& contact, double y) {
    return fast::pressure(contact, contact.place(y));
  };
  const auto from_end = [&](double y) { return std::max(last.place(y).e, 1e-9 * half_length); };
  // A memory that swings may need all terms of a panel.
  const LocalSlope local_slope(std::max(16, 2 * last.layout().terms()));
  const auto slope_of = [&](const ViscoelasticPressure& contact, double y) {
    return local_slope([&](double place) { return at(contact, place); }, y, slope_reach(last, y));
  };
  const auto estimated = [&](double y) {
    return implementation_->estimate(
        [&](const ViscoelasticPressure& contact) { return slope_of(contact, y); },
        largest / slope_reach(last, y), Rate::own);
  };
  // Levels that agree at a place by chance do not beside it.
  const PlaceFunction slope{
      [&](double y) { return slope_of(last, y); },
      [&](double y) {
        Estimate solved = estimated(y);
        for (const double beside : {-0.5, 0.5})
          solved.error = std::max(solved.error, estimated(y + beside * slope_reach(last, y)).error);
        // What is left out swings as the first polynomial that is: by its slope where it is 0 and by itself where its
        // slope is 0.
        const double swing =
            ladder.truncation_error([&](const ViscoelasticPressure& contact) { return at(contact, y); });
        solved.error = std::hypot(solved.error, last.layout().terms() * swing / slope_reach(last, y));
        solved.error += largest * sheet.neglected_near_end(half_length, from_end(y)) / from_end(y);
        return solved;
      }};
  const auto difference = [&](double y, double other) {
    return implementation_->estimate(
        [&](const ViscoelasticPressure& contact) { return at(contact, y) - at(contact, other); }, largest);
  };
  std::vector<double> places;
  for (const ViscoelasticPanel& panel : last.layout().panels()) add_places(panel, last, places);
  std::ranges::sort(places);
  Estimate place = place_of_maximum([&](double y) { return at(last, y); }, slope, difference, places);
  // Next to an end the maximum moves with it.
  const ContactPlace at_maximum = last.place(place.value);
  place.error =
      std::max(place.error, implementation_->unsure_end(at_maximum.half) * (1 - at_maximum.e / half_length));
  // At an end the pressure could be larger still.
  if (sheet.neglected_near_end(half_length, 0) > 1) place.error += last.leading_length() - place.value;
  return times(units.length, place);
}

Estimate ConvergedViscoelasticNip::rolling_resistance() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  const double lever = units.length / radius, half_length = implementation_->half_length();
  if (sheet.is_shifted_only()) return times(lever, {sheet.shift, sheet.neglected_of_shift(half_length)});
  const Estimate solved = ladder.estimate_down_to_rounding(fast::eccentricity);
  return times(lever, {solved.value, eccentricity_error_margin * solved.error +
                                         sheet.neglected(half_length) * half_length});
}

Estimate ConvergedViscoelasticNip::creep_ratio() const {
  const Implementation& solved = *implementation_;
  CountedKernels kernels = solved.ladder.kernels();
  Estimate creep = solved.estimate_of_integral(
      [&](const ViscoelasticPressure& contact) { return solved.creep(contact, kernels); },
      std::max(solved.half_length(), solved.creep_size(kernels)));
  // Levels that agree on the mean by chance do not on one half's.
  creep.error =
      std::max(creep.error, solved.ladder.truncation_error([&](const ViscoelasticPressure& contact) {
        return solved.half_strains(contact, kernels).leading;
      }));
  creep.error += solved.creep_rounding(kernels);
  return times(solved.units.creep, creep);
}

Estimate ConvergedViscoelasticNip::normal_displacement(double y) const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  const double position = implementation_->position(y);
  CountedKernels kernels = ladder.kernels();
  const auto displacement = [&](const ViscoelasticPressure& contact) {
    return contact.normal_displacement(contact.place(position), ladder.tolerance(), kernels);
  };
  const double parabola = std::pow(implementation_->half_length(), 2);
  const double size = implementation_->displacement_size(ladder.last().place(position));
  return times(units.displacement, implementation_->with_neglected(
                                       ladder.estimate_of_fading(displacement, parabola, size), size));
}

Estimate ConvergedViscoelasticNip::tangential_displacement(double y) const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  const double position = implementation_->position(y);
  if (position == 0) return {0, 0};
  CountedKernels kernels = ladder.kernels();
  // Next to the middle it may be much less than the strains around let it change with the contact's length.
  const double half_length = implementation_->half_length();
  const double strain = std::max(half_length, 2 * implementation_->creep_size(kernels));
  const double scale = strain * std::min(std::fabs(position), half_length);
  const auto at = [&](double place) {
    return implementation_->estimate_of_integral(
        [&, place](const ViscoelasticPressure& contact) {
          return contact.tangential_displacement(contact.place(place), contact.place(0), ladder.tolerance(),
                                                 kernels);
        },
        scale);
  };
  // Levels that agree at a place by chance do not beside it.
  Estimate estimate = at(position);
  const double further = std::copysign(std::min(2.5 * std::fabs(position), half_length), position);
  for (const double beside : {0.8 * position, std::fabs(position) < half_length ? further : position})
    estimate.error = std::max(estimate.error, at(beside).error);
  estimate.error += difference_rounding * ladder.last().tangential_size(ladder.tolerance(), kernels);
  return times(units.creep * units.length, estimate);
}

Estimate ConvergedViscoelasticNip::surface_strain(double y) const {
  const auto nothing = [](const ViscoelasticPressure&) { return 0.0; };
  return times(implementation_->units.creep, implementation_->strain_beyond(nothing, 0, y));
}

Estimate ConvergedViscoelasticNip::slip(double y) const {
  const Implementation& solved = *implementation_;
  CountedKernels kernels = solved.ladder.kernels();
  Estimate slip = solved.strain_beyond(
      [&](const ViscoelasticPressure& contact) { return solved.creep(contact, kernels); },
      std::max(solved.half_length(), solved.creep_size(kernels)), y);
  slip.error += solved.creep_rounding(kernels);
  return times(solved.units.creep, slip);
}

std::vector<InnerStresses> ConvergedViscoelasticNip::inner_stresses(
    std::span<const InnerPoint> points) const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  std::vector<SheetPoint> places;
  for (const InnerPoint& point : points) places.push_back(checked_point(point, units.length));
  auto stresses = implementation_->field().at(places);
  for (InnerStresses& here : stresses) here = in_unit(units.pressure, here);
  return stresses;
}

GreatestShear ConvergedViscoelasticNip::greatest_shear() const {
  const auto& [units, radius, sheet, ladder, strains] = *implementation_;
  const auto [value, y, depth] = implementation_->field().greatest(false);
  return {times(units.pressure, value), times(units.length, y), depth};
}

bool ConvergedViscoelasticNip::refine() { return implementation_->ladder.refine(); }

Work ConvergedViscoelasticNip::work() const { return implementation_->ladder.work(); }

ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length,
                                              double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_length(shape(nip), contact_length);
  const double half_length = contact_length / nip.sheet_thickness;
  const EffectiveSheet sheet = effective_sheet(nip, material_functions(nip.material), half_length, accuracy);
  const ViscoelasticNipLevels levels(sheet.material);
  check_softening(levels, half_length);
  return ConvergedViscoelasticNip(std::make_unique<ConvergedViscoelasticNip::Implementation>(
      nip, sheet, ViscoelasticNipLadder::at_half_length(levels, half_length, accuracy)));
}

ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip& nip, double load, double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_load(load);
  const EffectiveSheet sheet = effective_sheet_for_load(nip, load, accuracy);
  const ViscoelasticNipLevels levels(sheet.material);
  auto solved = std::make_unique<ConvergedViscoelasticNip::Implementation>(
      nip, sheet, ViscoelasticNipLadder::at_load(levels, load / units_of(nip, sheet).load, accuracy));
  check_length_of_load(shape(nip), load, solved->half_length() * nip.sheet_thickness);
  check_softening(levels, solved->half_length());
  return ConvergedViscoelasticNip(std::move(solved));
}

}  // namespace nipref::fast
