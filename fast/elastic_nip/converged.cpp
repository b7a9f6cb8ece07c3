#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/internal/functionals.hpp>
#include <nipref/fast/elastic_nip/internal/levels.hpp>
#include <nipref/fast/nip/internal/contact_field.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/places.hpp>

namespace nipref::fast {
namespace {

NipShape shape(const data::ElasticNip& nip) { return {nip.roller_radius, nip.sheet_thickness}; }

ContactUnits units_of(const data::ElasticNip& nip) { return {shape(nip), nip.material.normal_compliance()}; }

double checked_position(double y) {
  check_position(y);
  return std::fabs(y);
}

}  // namespace

namespace {

FieldOfContact field_of_half_contact(const HalfContact& contact) {
  // The shear of a solution is not quite 0 in the middle, where that of both halves would jump, and the stress along a
  // face have a logarithm.
  const double jump = contact.traction(contact.half_length).shear;
  const auto traction = [&](bool right, double e) -> FaceTraction {
    const Traction half = contact.traction(std::min(e, contact.half_length));
    const double shear = half.shear - jump * std::pow(e / contact.half_length, 2);
    return {half.pressure, right ? shear : -shear};
  };
  return {TractionField(contact.half_length, true, traction), 0, contact.half_length};
}

}  // namespace

struct ConvergedElasticNip::Implementation {
  Implementation(const data::ElasticNip& nip, data::Friction friction, ElasticNipLadder solved,
                 std::optional<double> length)
      : units(units_of(nip)),
        surface{friction, nip.material.theta2() / nip.material.normal_compliance(), solved.tolerance()},
        ladder(std::move(solved)),
        given_length(length) {}

  ContactUnits units;
  SurfaceDisplacements surface;
  ElasticNipLadder ladder;
  std::optional<double> given_length;  ///< unit of length
  mutable std::optional<ContactField<ElasticNipLadder>> inner_field;
  mutable std::map<const HalfContact*, double>
      creeps;  ///< without friction, of solutions of which it was asked for

  [[nodiscard]] double half_length() const { return ladder.last().half_length; }
  [[nodiscard]] Estimate half_length_estimate() const {
    return ladder.estimate([](const HalfContact& contact) { return contact.half_length; });
  }
  /// Dimensionless.
  [[nodiscard]] Estimate gripped_creep() const {
    return ladder.estimate([](const HalfContact& contact) { return contact.creep; }, half_length());
  }
  /// Distance of y >= 0 from the contact's end; without loss where that is given.
  [[nodiscard]] double from_end(double y) const {
    if (given_length) return (*given_length / 2 - y) / units.length;
    return half_length() - y / units.length;
  }
  [[nodiscard]] Estimate traction_at(double y, double Traction::*component, double scale) const {
    const double position = checked_position(y);
    const auto traction = [&](const HalfContact& contact, double e) {
      return e > 0 ? contact.traction(std::min(e, contact.half_length)).*component : 0;
    };
    // At its distance from each level's own end the traction is smooth; levels that agree there by chance do not beside
    // it. Then it matters how well the end is known.
    const double e = from_end(position);
    const auto at = [&](double place) {
      return ladder.estimate([&, place](const HalfContact& contact) { return traction(contact, place); },
                             e > 0 ? scale : 0);
    };
    Estimate estimate = at(e);
    for (const double beside : {0.8 * e, 0.9 * e, 1.25 * e})
      estimate.error = std::max(estimate.error, at(beside).error);
    // Where an expansion converges more slowly than the others, the last one lacks more than levels tell.
    if (e > 0) estimate.error = std::max(estimate.error, ladder.last().tail_at(e).*component);
    const double unsure = given_length ? 0 : half_length_estimate().error;
    double shifted = 0;
    for (const double moved : {e - unsure, e + unsure})
      shifted = std::max(shifted, std::fabs(traction(ladder.last(), moved) - estimate.value));
    estimate.error += shifted;
    return times(std::copysign(units.pressure, component == &Traction::shear ? y : 1), estimate);
  }
  [[nodiscard]] bool grips() const { return surface.friction == data::Friction::full; }
  /// What pressure and shear together lack at y, unit of length, dimensionless.
  [[nodiscard]] double traction_error(double y) const {
    const double shear =
        grips() ? 2 * traction_at(y, &Traction::shear, fast::peak_shear(ladder.last())).error : 0;
    return (pressure_at(y).error + shear) / units.pressure;
  }
  [[nodiscard]] Estimate pressure_at(double y) const {
    return traction_at(y, &Traction::pressure, ladder.last().traction(half_length()).pressure);
  }
  /// Mean strain of the surface in a contact without friction, dimensionless.
  [[nodiscard]] double sliding_creep(const HalfContact& contact, CountedKernels& kernels) const {
    const auto [known, is_new] = creeps.try_emplace(&contact);
    const double end = contact.half_length;
    if (is_new) known->second = fast::tangential_displacement(contact, end, surface, kernels) / end;
    return known->second;
  }
  /// What the pressure's stretching and its own share contribute to it at most.
  [[nodiscard]] double sliding_creep_size() const {
    return ladder.last().load * (0.25 + surface.beta / 2) / half_length();
  }
  /// Without friction, the surface's strain at y >= 0, unit of length, beyond `zero`, a strain of each solution that is
  /// at most about `zero_size`, dimensionless.
  [[nodiscard]] Estimate sliding_strain_beyond(const ElasticNipLadder::Functional& zero, double zero_size,
                                               double y) const {
    CountedKernels kernels = ladder.kernels();
    const double alpha = y / units.length;
    // The integral of stretch_over_pi is 1/2, its largest value below 1/4.
    const double size = fast::peak_pressure(ladder.last()) * std::min(half_length(), 1.0) / 2;
    const Estimate smooth = ladder.estimate_of_fading(
        [&](const HalfContact& contact) {
          return smooth_strain(contact, alpha, surface, kernels) - zero(contact);
        },
        size + zero_size, size * faded(alpha - half_length()) + zero_size);
    const Estimate pressure = times(1 / units.pressure, pressure_at(y));
    return {smooth.value - surface.beta * pressure.value,
            smooth.error + std::fabs(surface.beta) * pressure.error};
  }
  /// Made when it is asked for first.
  [[nodiscard]] ContactField<ElasticNipLadder>& field() const {
    if (!inner_field) {
      const double unsure = given_length ? 0 : half_length_estimate().error;
      inner_field.emplace(ladder, field_of_half_contact, fast::peak_pressure(ladder.last()),
                          FieldUncertainty{unsure, [](double) { return 0.0; }});
    }
    return *inner_field;
  }
  void check_shears() const {
    if (!grips())
      throw data::BadInput("friction", "none", "must be full for places of the shear: there is none");
  }
  /// Distances from the end where the shear is looked at, rising to the middle, half-thicknesses.
  [[nodiscard]] std::vector<double> shear_places() const {
    constexpr int steps = 400;
    constexpr double nearest = 1e-6;
    std::vector<double> places;
    for (int i = steps; i >= 0; --i)
      places.push_back(half_length() * std::pow(nearest, static_cast<double>(i) / steps));
    return places;
  }
  /// Odd about the middle, 0 outside.
  static double shear_of(const HalfContact& contact, double e) {
    if (!(e > 0)) return 0;
    const bool beyond = e > contact.half_length;
    const double shear = contact.traction(beyond ? std::max(0.0, 2 * contact.half_length - e) : e).shear;
    return beyond ? -shear : shear;
  }
  /// An error that can be seen, dimensionless: the expansions know nothing of the sign's change in the middle. Where
  /// they are as wrong as there, twice that.
  [[nodiscard]] double shear_error_seen() const {
    return 2 * std::fabs(shear_of(ladder.last(), half_length()));
  }
  /// Y of a distance from the end, which is no surer than that end.
  [[nodiscard]] Estimate from_middle(const Estimate& from_end) const {
    const double unsure = given_length ? 0 : half_length_estimate().error;
    return times(units.length, {half_length() - from_end.value, from_end.error + unsure});
  }
  /// Twice the ladder's: it finds levels alike by chance more often where the place of the maximum moves.
  [[nodiscard]] Estimate peak(double (*largest)(const HalfContact&)) const {
    const Estimate estimate = ladder.estimate(largest);
    return times(units.pressure, {estimate.value, 2 * estimate.error});
  }
};

ConvergedElasticNip::ConvergedElasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedElasticNip::ConvergedElasticNip(ConvergedElasticNip&&) noexcept = default;
ConvergedElasticNip::~ConvergedElasticNip() = default;

Estimate ConvergedElasticNip::contact_length() const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  return times(2 * units.length, implementation_->half_length_estimate());
}

Estimate ConvergedElasticNip::load() const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  return times(units.load, ladder.estimate([](const HalfContact& contact) { return contact.load; }));
}

Estimate ConvergedElasticNip::indentation() const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  return times(units.displacement, ladder.estimate([](const HalfContact& contact) {
    return contact.edge_displacement + contact.half_length * contact.half_length;
  }));
}

Estimate ConvergedElasticNip::edge_displacement() const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const double parabola = std::pow(implementation_->half_length(), 2);
  return times(
      units.displacement,
      ladder.estimate([](const HalfContact& contact) { return contact.edge_displacement; }, parabola));
}

Estimate ConvergedElasticNip::creep_ratio() const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const double size = implementation_->half_length();
  if (surface.friction == data::Friction::full) return times(units.creep, implementation_->gripped_creep());
  CountedKernels kernels = ladder.kernels();
  Estimate creep = ladder.estimate_of_integral(
      [&](const HalfContact& contact) { return implementation_->sliding_creep(contact, kernels); }, size);
  creep.error += difference_rounding * implementation_->sliding_creep_size();
  return times(units.creep, creep);
}

Estimate ConvergedElasticNip::pressure(double y) const { return implementation_->pressure_at(y); }

Estimate ConvergedElasticNip::shear(double y) const {
  // In the middle it changes its sign.
  if (implementation_->surface.friction == data::Friction::none || y == 0) {
    checked_position(y);
    return {0, 0};
  }
  const double scale = fast::peak_shear(implementation_->ladder.last());
  Estimate shear = implementation_->traction_at(y, &Traction::shear, scale);
  shear.error += implementation_->units.pressure * implementation_->shear_error_seen();
  return shear;
}

Estimate ConvergedElasticNip::peak_pressure() const { return implementation_->peak(fast::peak_pressure); }

Estimate ConvergedElasticNip::peak_shear() const {
  if (implementation_->surface.friction == data::Friction::none) return {0, 0};
  return implementation_->peak(fast::peak_shear);
}

Estimate ConvergedElasticNip::peak_shear_position() const {
  implementation_->check_shears();
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const double largest = fast::peak_shear(ladder.last());
  const auto size_of = [](const HalfContact& contact, double e) {
    return std::fabs(Implementation::shear_of(contact, e));
  };
  const auto size = [&](double e) { return size_of(ladder.last(), e); };
  const auto reach = [](double e) { return std::min(e / 4, 0.5); };
  const LocalSlope local_slope;
  const auto slope_of = [&](const HalfContact& contact, double e) {
    const auto shear = [&](double at) { return Implementation::shear_of(contact, at); };
    return std::copysign(1, Implementation::shear_of(ladder.last(), e)) * local_slope(shear, e, reach(e));
  };
  const PlaceFunction slope{[&](double e) { return slope_of(ladder.last(), e); },
                            [&](double e) {
                              Estimate here = ladder.estimate(
                                  [&](const HalfContact& contact) { return slope_of(contact, e); },
                                  largest / reach(e));
                              here.error *= 1.5;  // it converges later than what it is the slope of
                              return here;
                            }};
  const auto difference = [&](double e, double other) {
    return ladder.estimate(
        [&](const HalfContact& contact) { return size_of(contact, e) - size_of(contact, other); }, largest);
  };
  return implementation_->from_middle(
      place_of_maximum(size, slope, difference, implementation_->shear_places()));
}

std::vector<Estimate> ConvergedElasticNip::shear_zeros() const {
  implementation_->check_shears();
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const double largest = fast::peak_shear(ladder.last());
  const auto at = [&](double e) {
    return ladder.estimate([&](const HalfContact& contact) { return Implementation::shear_of(contact, e); },
                           largest);
  };
  const PlaceFunction shear{[&](double e) { return Implementation::shear_of(ladder.last(), e); },
                            [&](double e) {
                              // Levels that agree there by chance do not beside it.
                              Estimate here = at(e);
                              for (const double beside : {0.8 * e, 1.25 * e})
                                here.error = std::max(here.error, at(beside).error);
                              here.error += implementation_->shear_error_seen();
                              return here;
                            }};
  std::vector<Estimate> zeros;
  for (const Estimate& zero : places_of_sure_zeros(shear, implementation_->shear_places()))
    zeros.push_back(implementation_->from_middle(zero));
  zeros.push_back({0, 0});
  std::ranges::reverse(zeros);
  return zeros;
}

Estimate ConvergedElasticNip::normal_displacement(double y) const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const double position = checked_position(y) / units.length;
  CountedKernels kernels = ladder.kernels();
  const auto displacement = [&](const HalfContact& contact) {
    return fast::normal_displacement(contact, position, surface, kernels);
  };
  const double half_length = implementation_->half_length(), parabola = half_length * half_length;
  return times(units.displacement,
               ladder.estimate_of_fading(displacement, parabola, parabola * faded(position - half_length)));
}

Estimate ConvergedElasticNip::tangential_displacement(double y) const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const double position = checked_position(y) / units.length;
  const double half_length = implementation_->half_length(), inside = std::min(position, half_length);
  const auto dimensional = [&](const Estimate& estimate) {
    return times(std::copysign(units.creep * units.length, y), estimate);
  };
  const bool grips = surface.friction == data::Friction::full;
  if (grips && position == inside) return dimensional(times(position, implementation_->gripped_creep()));
  CountedKernels kernels = ladder.kernels();
  const auto displacement = [&](const HalfContact& contact) {
    return fast::tangential_displacement(contact, position, surface, kernels);
  };
  Estimate estimate = ladder.estimate_of_integral(displacement, half_length * inside);
  if (grips) {
    // No surer than the contact's end.
    estimate.error += half_length * implementation_->gripped_creep().error;
  } else if (position > 0) {
    estimate.error += difference_rounding * ladder.last().load * (0.25 + surface.beta / 2);
  }
  return dimensional(estimate);
}

Estimate ConvergedElasticNip::surface_strain(double y) const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const double position = checked_position(y);
  const double from_end = implementation_->from_end(position);
  const double unsure = given_length ? 0 : implementation_->half_length_estimate().error;
  if (implementation_->grips() && from_end >= 0) {
    Estimate creep = implementation_->gripped_creep();
    if (from_end < unsure) creep.error += implementation_->traction_error(position);
    return times(units.creep, creep);
  }
  const double alpha = position / units.length;
  if (implementation_->grips()) return times(units.creep / 2, implementation_->field().along_face(alpha));
  const auto nothing = [](const HalfContact&) { return 0.0; };
  return times(units.creep, implementation_->sliding_strain_beyond(nothing, 0, position));
}

Estimate ConvergedElasticNip::slip(double y) const {
  const Implementation& solved = *implementation_;
  const double position = checked_position(y);
  if (solved.grips()) {
    const double unsure = solved.given_length ? 0 : solved.half_length_estimate().error;
    if (solved.from_end(position) >= unsure) return {0, 0};
    const Estimate strain = surface_strain(y), creep = creep_ratio();
    return {strain.value - creep.value, strain.error + creep.error};
  }
  CountedKernels kernels = solved.ladder.kernels();
  Estimate slip = solved.sliding_strain_beyond(
      [&](const HalfContact& contact) { return solved.sliding_creep(contact, kernels); },
      solved.sliding_creep_size(), position);
  slip.error += difference_rounding * solved.sliding_creep_size();
  return times(solved.units.creep, slip);
}

std::vector<InnerStresses> ConvergedElasticNip::inner_stresses(std::span<const InnerPoint> points) const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  std::vector<SheetPoint> places;
  for (const InnerPoint& point : points) places.push_back(checked_point(point, units.length));
  auto stresses = implementation_->field().at(places);
  for (InnerStresses& here : stresses) here = in_unit(units.pressure, here);
  return stresses;
}

GreatestShear ConvergedElasticNip::greatest_shear() const {
  const auto& [units, surface, ladder, given_length, inner_field, creeps] = *implementation_;
  const auto [value, y, depth] = implementation_->field().greatest(true);
  return {times(units.pressure, value), times(units.length, y), depth};
}

bool ConvergedElasticNip::refine() {
  implementation_->inner_field.reset();
  return implementation_->ladder.refine();
}

Work ConvergedElasticNip::work() const { return implementation_->ladder.work(); }

ConvergedElasticNip converged_for_length(const data::ElasticNip& nip, data::Friction friction,
                                         double contact_length, double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_length(shape(nip), contact_length);
  return ConvergedElasticNip(std::make_unique<ConvergedElasticNip::Implementation>(
      nip, friction,
      ElasticNipLadder::at_half_length({friction, nip.material.poisson}, contact_length / nip.sheet_thickness,
                                       accuracy),
      contact_length));
}

ConvergedElasticNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                       double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_load(load);
  auto solved = std::make_unique<ConvergedElasticNip::Implementation>(
      nip, friction,
      ElasticNipLadder::at_load({friction, nip.material.poisson}, load / units_of(nip).load, accuracy),
      std::nullopt);
  check_length_of_load(shape(nip), load, solved->half_length() * nip.sheet_thickness);
  return ConvergedElasticNip(std::move(solved));
}

}  // namespace nipref::fast
