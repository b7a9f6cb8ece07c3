#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/contact_field.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_contact.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int fewest_rolling_digits = 16;
constexpr int most_rolling_digits = 30;
/// Contacts in sheet thicknesses.
constexpr double shortest_rolling = 1e-6, longest_rolling = 1000;
/// The same, of contacts whose stresses inside the sheet are asked for: their waves are summed over all of the contact.
constexpr double longest_inside = 10;
/// Relaxation lengths in contacts.
constexpr double shortest_memory = 1e-8, longest_memory = 1e8;
/// Of a rate, its imaginary part over the real one.
constexpr double most_swing = 10;
/// Of a displacement, in half-thicknesses.
constexpr double farthest_rolling = 600;

constexpr auto allowed_rolling_lengths =
    "must be at most the roller's radius and from 1e-6 to 1000 sheet thicknesses for the reference's rolling "
    "contact";

void check_rolling_digits(int digits) {
  if (digits < fewest_rolling_digits || digits > most_rolling_digits)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 30 for a rolling contact");
}

bool rolling_length_is_allowed(const data::ViscoelasticNip& nip, double length) {
  return length >= shortest_rolling * nip.sheet_thickness &&
         length <= longest_rolling * nip.sheet_thickness && length <= nip.roller_radius;
}

void check_swing(const RollingMaterial& material) {
  for (const RollingMemory& term : material.normal) {
    if (is_flow(term)) continue;
    const Float swing = term.rate.im / term.rate.re;
    if (swing > most_swing)
      throw BadInput("nip.material", static_cast<double>(swing),
                     "must have imaginary parts of rates at most 10 times the real parts for the reference");
  }
}

/// Of a half length in half-thicknesses.
void check_memories(const RollingMaterial& material, double half_length) {
  for (const RollingMemory& term : material.normal) {
    const double length = 2 * half_length;
    if (is_flow(term)) continue;
    const double way = 1 / static_cast<double>(abs(term.rate)),
                 longest = 1 / static_cast<double>(term.rate.re);
    if (way < shortest_memory * length || longest > longest_memory * length)
      throw BadInput("nip.material", way / length,
                     "must have relaxation lengths from 1e-8 to 1e8 contacts for the reference");
  }
}

/// Units of the dimensionless contact.
struct RollingUnits {
  Float length;        ///< b
  Float displacement;  ///< b^2/(2R)
  Float pressure;      ///< b/(2 R N_0)
  Float lever;         ///< b/R

  RollingUnits(const data::ViscoelasticNip& nip, const RollingMaterial& material)
      : length(Float(nip.sheet_thickness) / 2),
        displacement(length * length / (2 * Float(nip.roller_radius))),
        pressure(length / (2 * Float(nip.roller_radius) * material.compliance)),
        lever(length / nip.roller_radius) {}
};

/// To more than the results' digits; what memories' parts lose as they cancel they do not lose of it.
RollingMaterial material_to(int digits, const data::ViscoelasticNip& nip) {
  const WorkingDigits working(digits + 14);
  return rolling_material(nip);
}

FieldSource field_source(const RollingPressure& contact) {
  const auto tractions = [&contact](const Float& left, const Float& right) -> FaceTraction {
    return {contact.pressure(right, left), 0};
  };
  return {contact.offset(), contact.half_length(), tractions};
}

Estimate estimated_of(const Float& unit, const data::WithError<Float>& estimate, int digits) {
  return {unit * estimate.value, unit * estimate.error, digits};
}

}  // namespace

struct ConvergedViscoelasticNip::Implementation {
  RollingUnits units;
  RollingContact contact;
  mutable std::map<const RollingPressure*, Float> at_middle = {};

  [[nodiscard]] const Float& size() const { return contact.fine().half_length(); }
  [[nodiscard]] Estimate estimated(const Float& unit, const RollingContact::Functional& functional,
                                   const std::function<Float(const RollingPressure&)>& scale) const {
    const WorkingDigits working(contact.working_digits());
    return estimated_of(unit, contact.estimate(functional, scale(contact.fine())), contact.digits());
  }
  [[nodiscard]] Estimate length(const RollingContact::Functional& functional) const {
    return estimated(units.length, functional, std::mem_fn(&RollingPressure::half_length));
  }
  [[nodiscard]] Estimate displacement(const RollingContact::Functional& functional) const {
    return estimated(units.displacement, functional, [](const RollingPressure& contact_here) {
      return contact_here.half_length() * contact_here.half_length();
    });
  }
  void check_place(double y) const {
    if (!std::isfinite(y) || abs(y / units.length) > farthest_rolling)
      throw BadInput("y", y, "must be within 300 sheet thicknesses of the middle on the reference path");
  }
  [[nodiscard]] ContactField field() const {
    const RollingPressure& fine = contact.fine();
    if (fine.half_length() > longest_inside) {
      throw BadInput("contact_length", static_cast<double>(2 * fine.half_length() * units.length),
                     "must be at most 10 sheet thicknesses for stresses inside on the reference path");
    }
    const Float scale = fine.load() / fine.half_length();
    return {field_source(contact.coarse()), field_source(fine), scale, scale * contact.difference(),
            contact.digits()};
  }
  /// Of where the leading end is.
  [[nodiscard]] Float end_error() const {
    return contact.estimate([&](const RollingPressure& of) { return downstream(of, 0); }, size()).error;
  }
  /// Of the pressure at d: nothing where the contact surely is not.
  [[nodiscard]] Float pressure_scale(const Float& d) const {
    const Float known = end_error();
    return d > -known && d < 2 * size() + known ? contact.fine().load() / size() : Float(0);
  }
  /// What the pressure at d may miss as the ends do: where it is as steep as a square root they count for as much as
  /// they are known.
  [[nodiscard]] Float pressure_by_ends(const Float& d) const {
    const RollingPressure& fine = contact.fine();
    const Float known = end_error(), here = fine.pressure(d);
    return abs(fine.pressure(d + known) - here) + abs(fine.pressure(d - known) - here);
  }
  /// Of v at Y = 0.
  [[nodiscard]] const Float& tangential_at_middle(const RollingPressure& of) const {
    const auto [place, is_new] = at_middle.try_emplace(&of);
    if (is_new) place->second = of.response(downstream(of, 0), contact.tangential_kernel());
    return place->second;
  }
  /// Of Y, from the leading end.
  [[nodiscard]] Float downstream(const RollingPressure& of, double y) const {
    return of.half_length() + of.offset() - y / units.length;
  }
};

ConvergedViscoelasticNip::ConvergedViscoelasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedViscoelasticNip::ConvergedViscoelasticNip(ConvergedViscoelasticNip&&) noexcept = default;
ConvergedViscoelasticNip::~ConvergedViscoelasticNip() = default;

Estimate ConvergedViscoelasticNip::contact_length() const {
  return implementation_->length([](const RollingPressure& of) { return 2 * of.half_length(); });
}

Estimate ConvergedViscoelasticNip::leading_length() const {
  return implementation_->length([](const RollingPressure& of) { return of.half_length() + of.offset(); });
}

Estimate ConvergedViscoelasticNip::trailing_length() const {
  return implementation_->length([](const RollingPressure& of) { return of.half_length() - of.offset(); });
}

Estimate ConvergedViscoelasticNip::load() const {
  const WorkingDigits working(implementation_->contact.working_digits());
  const RollingUnits& units = implementation_->units;
  return implementation_->estimated(units.pressure * units.length, std::mem_fn(&RollingPressure::load),
                                    std::mem_fn(&RollingPressure::load));
}

Estimate ConvergedViscoelasticNip::indentation() const {
  return implementation_->displacement([](const RollingPressure& of) {
    const Float leading = of.half_length() + of.offset();
    return of.edge_displacement() + leading * leading;
  });
}

Estimate ConvergedViscoelasticNip::leading_displacement() const {
  return implementation_->displacement(std::mem_fn(&RollingPressure::edge_displacement));
}

Estimate ConvergedViscoelasticNip::trailing_displacement() const {
  return implementation_->displacement(
      [](const RollingPressure& of) { return of.edge_displacement() + 4 * of.offset() * of.half_length(); });
}

Estimate ConvergedViscoelasticNip::rolling_resistance() const {
  return implementation_->estimated(
      implementation_->units.lever,
      [](const RollingPressure& of) { return of.offset() + of.moment() / of.load(); },
      std::mem_fn(&RollingPressure::half_length));
}

Estimate ConvergedViscoelasticNip::peak_pressure() const {
  return implementation_->estimated(implementation_->units.pressure,
                                    std::mem_fn(&RollingPressure::peak_pressure),
                                    std::mem_fn(&RollingPressure::peak_pressure));
}

Estimate ConvergedViscoelasticNip::peak_pressure_position() const {
  return implementation_->length(
      [](const RollingPressure& of) { return of.half_length() + of.offset() - of.place_of_peak(); });
}

Estimate ConvergedViscoelasticNip::pressure(double y) const {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  const WorkingDigits working(implementation_->contact.working_digits());
  const auto& [units, contact, at_middle] = *implementation_;
  const Float d = implementation_->downstream(contact.fine(), y);
  data::WithError<Float> result = contact.estimate(
      [&](const RollingPressure& of) { return of.pressure(implementation_->downstream(of, y)); },
      implementation_->pressure_scale(d));
  result.error += implementation_->pressure_by_ends(d);
  return estimated_of(units.pressure, result, contact.digits());
}

Estimate ConvergedViscoelasticNip::creep_ratio() const {
  const WorkingDigits working(implementation_->contact.working_digits());
  RollingKernel& kernel = implementation_->contact.tangential_kernel();
  return implementation_->estimated(
      implementation_->units.lever / 2,
      [&](const RollingPressure& of) {
        const Float length = 2 * of.half_length();
        return (of.response(0, kernel) - of.response(length, kernel)) / length;
      },
      std::mem_fn(&RollingPressure::half_length));
}

Estimate ConvergedViscoelasticNip::tangential_displacement(double y) const {
  const WorkingDigits working(implementation_->contact.working_digits());
  implementation_->check_place(y);
  if (y == 0) return exact_zero(implementation_->contact.digits());
  RollingKernel& kernel = implementation_->contact.tangential_kernel();
  const Float& size = implementation_->size();
  const Float way = abs(y / implementation_->units.length);
  return implementation_->estimated(
      implementation_->units.displacement,
      [&](const RollingPressure& of) {
        return of.response(implementation_->downstream(of, y), kernel) -
               implementation_->tangential_at_middle(of);
      },
      [&](const RollingPressure&) { return size * std::min(size, way); });
}

Estimate ConvergedViscoelasticNip::surface_strain(double y) const {
  const WorkingDigits working(implementation_->contact.working_digits());
  implementation_->check_place(y);
  const auto& [units, contact, at_middle] = *implementation_;
  StretchRollingKernel& kernel = contact.stretch_kernel();
  const Float at = implementation_->downstream(contact.fine(), y);
  // No surer than the pressure that stretches the surface at once.
  data::WithError<Float> result = contact.estimate(
      [&](const RollingPressure& of) -> Float {
        const Float d = implementation_->downstream(of, y);
        return -(of.response(d, kernel) + kernel.jump() * of.pressure(d));
      },
      implementation_->size() + kernel.jump() * implementation_->pressure_scale(at));
  result.error += kernel.jump() * implementation_->pressure_by_ends(at);
  return estimated_of(units.lever / 2, result, contact.digits());
}

Estimate ConvergedViscoelasticNip::normal_displacement(double y) const {
  const WorkingDigits working(implementation_->contact.working_digits());
  implementation_->check_place(y);
  return implementation_->displacement([&](const RollingPressure& of) {
    return of.normal_displacement(implementation_->downstream(of, y),
                                  implementation_->contact.normal_kernel());
  });
}

std::vector<InnerStresses> ConvergedViscoelasticNip::inner_stresses(
    std::span<const InnerPoint> points) const {
  const auto& [units, contact, at_middle] = *implementation_;
  const WorkingDigits working(contact.working_digits());
  const ContactField field = implementation_->field();
  std::vector<InnerStresses> stresses;
  for (const InnerPoint& point : points)
    stresses.push_back(field.at(checked_point(point, units.length), false, units.pressure));
  return stresses;
}

GreatestShear ConvergedViscoelasticNip::greatest_shear() const {
  const WorkingDigits working(implementation_->contact.working_digits());
  const RollingUnits& units = implementation_->units;
  return implementation_->field().greatest(false, units.pressure, units.length);
}

int ConvergedViscoelasticNip::unknowns() const { return implementation_->contact.fine().unknowns(); }
long ConvergedViscoelasticNip::normal_kernel_values() const {
  return implementation_->contact.normal_kernel().kernel_values();
}
long ConvergedViscoelasticNip::tangential_kernel_values() const {
  const RollingContact& contact = implementation_->contact;
  return contact.tangential_kernel().kernel_values() + contact.stretch_kernel().kernel_values();
}
long ConvergedViscoelasticNip::kernel_evaluations() const {
  const RollingContact& contact = implementation_->contact;
  return contact.normal_kernel().evaluations() + contact.tangential_kernel().evaluations() +
         contact.stretch_kernel().evaluations();
}

namespace {

/// What may be solved at a given length.
struct RollingOfLength {
  RollingMaterial material;
  Float half_length;
};

RollingOfLength checked_rolling(const data::ViscoelasticNip& nip, double contact_length, int digits) {
  nip.check();
  check_rolling_digits(digits);
  if (!rolling_length_is_allowed(nip, contact_length))
    throw BadInput("contact_length", contact_length, allowed_rolling_lengths);
  RollingMaterial material = material_to(digits, nip);
  const WorkingDigits working(RollingContact::working_digits(material, digits));
  Float half_length = Float(contact_length) / nip.sheet_thickness;
  check_swing(material);
  check_memories(material, static_cast<double>(half_length));
  return {std::move(material), std::move(half_length)};
}

}  // namespace

int rolling_unknowns(const data::ViscoelasticNip& nip, double contact_length, int digits) {
  const auto [material, half_length] = checked_rolling(nip, contact_length, digits);
  return RollingContact::first_unknowns(half_length, material, digits);
}

ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length,
                                              int digits) {
  const auto [material, half_length] = checked_rolling(nip, contact_length, digits);
  const WorkingDigits working(RollingContact::working_digits(material, digits));
  return ConvergedViscoelasticNip(std::make_unique<ConvergedViscoelasticNip::Implementation>(
      RollingUnits(nip, material), RollingContact::of_half_length(half_length, material, digits)));
}

ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip& nip, double load, int digits) {
  nip.check();
  check_rolling_digits(digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const RollingMaterial material = material_to(digits, nip);
  const WorkingDigits working(RollingContact::working_digits(material, digits));
  check_swing(material);
  const RollingUnits units(nip, material);
  const auto check = [&](double half_length) {
    if (!rolling_length_is_allowed(nip, half_length * nip.sheet_thickness))
      throw BadInput("load", load, std::string("gives a contact whose length ") + allowed_rolling_lengths);
    check_memories(material, half_length);
  };
  return ConvergedViscoelasticNip(std::make_unique<ConvergedViscoelasticNip::Implementation>(
      units, RollingContact::of_load(load / (units.pressure * units.length), material, digits, check)));
}

}  // namespace nipref::ref
