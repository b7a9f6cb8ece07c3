#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/converged_parts.hpp>
#include <nipref/ref/nip/internal/inner_field.hpp>
#include <nipref/ref/nip/internal/proven_stresses.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int fewest_digits = 16;
/// Largest L/B for stresses inside, which are sums of waves over the whole contact.
constexpr double longest_inside = 80;
/// Extra digits of the fields of line loads, beyond those of the stresses summed from them.
constexpr int stress_guard = 4;

}  // namespace

void NipTask::check_digits() const {
  if (digits < fewest_digits || digits > most_digits)
    throw BadInput("digits", std::to_string(digits),
                   fmt::format("must be from {} to {} for {}", fewest_digits, most_digits, kind));
}

double NipTask::longest() const { return std::min(most, roller_radius / sheet_thickness); }

std::string NipTask::allowed_lengths() const {
  return fmt::format("must be at most the roller's radius and from {:g} to {:g} sheet thicknesses for {}",
                     shortest, most, kind);
}

bool NipTask::allows(double contact_length) const {
  return contact_length >= shortest * sheet_thickness && contact_length <= most * sheet_thickness &&
         contact_length <= roller_radius;
}

Exact NipTask::half_length(double contact_length) const {
  if (!allows(contact_length)) throw BadInput("contact_length", contact_length, allowed_lengths());
  return Exact(mpq_class(mpq_class(contact_length) / mpq_class(sheet_thickness)));
}

void NipTask::refuse_load(double load) const {
  throw BadInput("load", load, "gives a contact whose length " + allowed_lengths());
}

SolvedNip NipTask::solved_for_load(const SolvedNip::Sheet& sheet, double load, const Float& wanted,
                                   double guess) const {
  const auto check = [&](double half_length) {
    if (!(half_length > 0.1 * shortest && half_length < 8 * longest())) refuse_load(load);
    sheet->check(half_length);
  };
  SolvedNip solved =
      SolvedNip::of_load(sheet, wanted, std::clamp(guess, 0.5 * shortest, 2 * longest()), digits, check);
  if (!allows(static_cast<double>(solved.fine().half_length()) * sheet_thickness)) refuse_load(load);
  return solved;
}

double guessed_half_length(double load, const std::function<double(double half_length)>& softness) {
  double size = 1;
  for (int i = 0; i < 60; ++i)
    size = std::sqrt(size * std::sqrt(load * softness(size) / (std::numbers::pi + 8 * size / 3)));
  return size;
}

namespace {

using Traction = Float PressureAndShear::*;
using Unit = NipUnits;

// Scales of the kinds of results. 0 means that the scale is the value itself.
Float itself(const NipSolution&) { return 0; }
Float half_length_of(const NipSolution& of) { return of.half_length(); }
Float square_of(const NipSolution& of) { return of.half_length() * of.half_length(); }
/// Twice the mean pressure, which is more than the pressure in the middle.
Float pressure_of(const NipSolution& of) { return of.load() / of.half_length(); }

std::optional<Interval> unproven(const ProvenResults&) { return std::nullopt; }

/// Returns sample places x on all panels of both halves, rising.
std::vector<Float> samples_of(const NipSolution& of) {
  constexpr int per_panel = 40;
  std::vector<Float> samples;
  for (const TractionPanel& panel : of.panels())
    for (int i = 0; i < per_panel; ++i) samples.push_back(panel.left + i * panel.width / per_panel);
  const Float end = 2 * of.half_length();
  samples.push_back(of.half_length());
  for (std::size_t i = samples.size() - 1; i-- > 0;) samples.push_back(end - samples[i]);
  return samples;
}

/// Returns the x of the largest |part| of the tractions, near the largest sample, to the working precision. The
/// tractions are flat there, so they are computed with twice the digits. Of equal places the leading one is taken.
Float place_of_largest(const NipSolution& of, Traction part) {
  const std::vector<Float> samples = samples_of(of);
  const auto size = [&](const Float& x) -> Float { return abs(of.tractions(x).*part); };
  const auto largest = std::ranges::max_element(samples.begin() + 1, samples.end() - 1, {}, size);
  const int digits = digits_of(working_bits());
  Float place;
  {
    const WorkingDigits more(2 * digits);
    place = boost::math::tools::brent_find_minima([&](const Float& x) -> Float { return -size(x); },
                                                  *(largest - 1), *(largest + 1),
                                                  static_cast<int>(working_bits()))
                .first;
  }
  return at_working_precision(place);
}

/// Pairs of places x over the half length, falling, between which the shear changes its sign in both solutions.
std::vector<std::pair<Float, Float>> shear_changes(const SolvedNip& nip) {
  constexpr int steps = 400;
  std::vector<std::pair<Float, Float>> changes;
  std::optional<Float> last;
  bool was_positive = false;
  for (int i = 1; i <= steps; ++i) {
    const Float place = exp(log(Float(1e-6)) * i / steps);
    const auto shear_of = [&](const NipSolution& of) { return of.tractions(place * of.half_length()).shear; };
    const Float here = shear_of(nip.fine()), other = shear_of(nip.coarse());
    if (!(abs(here) > 2 * abs(here - other))) continue;
    if (last && was_positive != (here > 0)) changes.emplace_back(*last, place);
    last = place;
    was_positive = here > 0;
  }
  return changes;
}

FieldSource field_source(const NipSolution& of) {
  return {of.offset(), of.half_length(),
          [&of](const Float& left, const Float& right) { return of.tractions(right, left); }};
}

}  // namespace

/// The parts of a contact and the functions that compute results from them.
struct ConvergedNip::Computed : Parts {
  using Unit = mpq_class NipUnits::*;
  using Proven = std::function<std::optional<Interval>(const ProvenResults&)>;
  using ProvenTraction = Interval (ProvenResults::*)(const SurfacePoint&) const;

  explicit Computed(Parts parts) : Parts(std::move(parts)) {}

  [[nodiscard]] const NipSolution& fine() const { return by_panels().fine(); }
  [[nodiscard]] Float in_unit(Unit unit) const { return to_float(Exact(units.*unit)); }
  // The functions below are called at the working precision, or set it.
  [[nodiscard]] const SolvedNip& by_panels() const {
    if (!solved) solved = SolvedNip::of_half_length(sheet, size(), digits);
    return *solved;
  }

  [[nodiscard]] Float size() const {
    if (half_length) return to_float(*half_length);
    return proof ? middle_of(proof->contact->half_length()) : fine().half_length();
  }

  /// The result that `proven` takes from the proof. Nothing if there is no proof or it does not have that result.
  [[nodiscard]] std::optional<Estimate> by_proof(Unit unit, const Proven& proven) const {
    if (!proof) return std::nullopt;
    const WorkingDigits working(proof->working_digits);
    const std::optional<Interval> value = proven(*proof->contact);
    if (!value) return std::nullopt;
    return enclosure_of(Interval(Exact(units.*unit), working_bits()) * *value, digits);
  }

  /// The proven result if there is one, otherwise the estimate of a functional at the scale `size`.
  [[nodiscard]] Estimate number(Unit unit, const Proven& proven, const SolvedNip::Functional& functional,
                                const SolvedNip::Functional& size) const {
    if (const auto value = by_proof(unit, proven)) return *value;
    const WorkingDigits working(working_digits());
    return estimated(unit, functional, size(fine()));
  }

  /// The estimate of a functional whose scale is its value, or `least` if larger. `beside` is added to the error.
  [[nodiscard]] Estimate estimated(Unit unit, const SolvedNip::Functional& functional, const Float& least,
                                   const Float& beside = 0) const {
    const data::WithError<Float> estimate = by_panels().estimate(functional, least);
    return {in_unit(unit) * estimate.value, in_unit(unit) * (estimate.error + beside), digits};
  }

  /// The distance of Y behind the leading end.
  [[nodiscard]] Float behind(const NipSolution& of, double y) const {
    return of.half_length() + of.offset() - Float(y) / in_unit(&NipUnits::length);
  }

  [[nodiscard]] SurfacePoint place(double y) const {
    const ProvenResults& of = *proof->contact;
    const mpq_class distance = mpq_class(y) / units.length;
    // If the length is given, the place relative to the ends is exact.
    const Interval ahead = sheet->is_symmetric() && half_length
                               ? Interval(mpq_class(distance / half_length->value()), working_bits())
                               : (Interval(distance, working_bits()) - of.offset()) / of.half_length();
    const bool is_trailing = mpfr_sgn(ahead.lower()) < 0;
    return {is_trailing ? ahead + 1 : 1 - ahead, is_trailing};
  }

  /// The error of the place of the leading end.
  [[nodiscard]] Float end_error() const {
    if (sheet->is_symmetric() && half_length) return 0;
    return by_panels()
        .estimate([&](const NipSolution& of) { return behind(of, 0); }, fine().half_length())
        .error;
  }

  /// Whether x is outside the contact, wherever its ends are within their error.
  [[nodiscard]] bool is_outside(const Float& x) const {
    const Float known = end_error();
    return !(x > -known && x < 2 * fine().half_length() + known);
  }

  /// The error of a traction at x due to the error of the ends: the change of the traction over that distance. It
  /// counts near the ends, where the traction is as steep as a square root.
  [[nodiscard]] Float by_ends(const Float& x, Traction part) const {
    const Float known = end_error(), here = fine().tractions(x).*part;
    return abs(fine().tractions(x + known).*part - here) + abs(fine().tractions(x - known).*part - here);
  }

  [[nodiscard]] Estimate traction(double y, Traction part, ProvenTraction proven) const {
    if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
    if (const auto value =
            by_proof(&NipUnits::pressure, [&](const ProvenResults& of) { return (of.*proven)(place(y)); }))
      return *value;
    const WorkingDigits working(working_digits());
    const Float x = behind(fine(), y);
    if (is_outside(x)) return sheet->is_symmetric() ? Estimate(exact_zero(digits)) : Estimate(0, 0, digits);
    return estimated(
        &NipUnits::pressure, [&](const NipSolution& of) { return of.tractions(behind(of, y)).*part; },
        pressure_of(fine()), by_ends(x, part));
  }

  void check_place(double y) const {
    const WorkingDigits working(working_digits());
    if (!std::isfinite(y) || abs(Float(y) / in_unit(&NipUnits::length)) > farthest_inside + size())
      throw BadInput("y", y, "must be within 450 sheet thicknesses of the contact on the reference path");
  }

  void check_has_shear() const {
    if (!sheet->sticks()) throw BadInput("friction.model", "none", "must be full for places of the shear");
  }

  [[nodiscard]] const Float& tangential_at_middle(const NipSolution& of) const {
    const auto [place, is_new] = at_middle.try_emplace(&of, 0);
    if (is_new && !sheet->is_symmetric()) place->second = of.tangential(behind(of, 0));
    return place->second;
  }

  [[nodiscard]] ContactField field() const {
    const NipSolution& of = fine();
    if (of.half_length() > longest_inside) {
      throw BadInput("contact_length", static_cast<double>(2 * of.half_length() * in_unit(&NipUnits::length)),
                     "must be at most 80 sheet thicknesses for stresses inside on the reference path");
    }
    const Float scale = pressure_of(of);
    return {field_source(by_panels().coarse()), field_source(of), scale, scale * by_panels().difference(),
            digits};
  }

  /// The stresses of the proof, at its working precision. Nothing if there is no proof or it does not cover the point.
  [[nodiscard]] std::optional<InnerStresses> proven_stresses_at(const InnerPoint& point) const {
    if (!proof || proof->contact->expansion() == nullptr) return std::nullopt;
    const WorkingDigits working(proof->working_digits);
    const auto found = proven_stresses(*proof->contact->expansion(), place(point.y), Exact(point.depth),
                                       digits + stress_guard);
    if (!found) return std::nullopt;
    const Interval unit(Exact(units.pressure), working_bits());
    const bool no_shear = point.depth == 0 || (sheet->is_symmetric() && point.y == 0);
    return InnerStresses{enclosure_of(unit * found->across, digits),
                         enclosure_of(unit * found->along, digits),
                         no_shear ? exact_zero(digits) : enclosure_of(unit * found->shear, digits)};
  }

  mutable std::map<const NipSolution*, Float> at_middle = {};
};

ConvergedNip::ConvergedNip(Parts parts) : parts_(std::make_shared<const Computed>(std::move(parts))) {
  const WorkingDigits working(parts_->working_digits());
  if (!parts_->proof) (void)parts_->by_panels();
}

Estimate ConvergedNip::contact_length() const {
  const auto formula = [](const auto& of) { return 2 * of.half_length(); };
  return parts_->number(&Unit::length, formula, formula, itself);
}

Estimate ConvergedNip::leading_length() const {
  const auto formula = [](const auto& of) { return of.half_length() + of.offset(); };
  return parts_->number(&Unit::length, formula, formula, half_length_of);
}

Estimate ConvergedNip::trailing_length() const {
  const auto formula = [](const auto& of) { return of.half_length() - of.offset(); };
  return parts_->number(&Unit::length, formula, formula, half_length_of);
}

Estimate ConvergedNip::load() const {
  const auto formula = [](const auto& of) { return of.load(); };
  return parts_->number(&Unit::force, formula, formula, itself);
}

Estimate ConvergedNip::indentation() const {
  const auto formula = [](const auto& of) {
    const auto leading = of.half_length() + of.offset();
    return of.edge_displacement() + leading * leading;
  };
  return parts_->number(&Unit::displacement, formula, formula, square_of);
}

Estimate ConvergedNip::leading_displacement() const {
  const auto formula = [](const auto& of) { return of.edge_displacement(); };
  return parts_->number(&Unit::displacement, formula, formula, [&](const NipSolution& of) -> Float {
    return square_of(of) * (parts_->sheet->is_symmetric() ? SolvedNip::kernel_share() : Float(1));
  });
}

Estimate ConvergedNip::trailing_displacement() const {
  if (parts_->sheet->is_symmetric()) return leading_displacement();
  const auto formula = [](const auto& of) {
    return of.edge_displacement() + 4 * (of.offset() * of.half_length());
  };
  return parts_->number(&Unit::displacement, formula, formula, square_of);
}

Estimate ConvergedNip::rolling_resistance() const {
  if (parts_->sheet->is_symmetric()) return exact_zero(parts_->digits);
  const auto formula = [](const auto& of) { return 2 * of.lever(); };
  return parts_->number(&Unit::slope, formula, formula, half_length_of);
}

Estimate ConvergedNip::creep_ratio() const {
  const auto proven = [&](const ProvenResults& of) -> std::optional<Interval> {
    const std::optional<Interval> end = of.tangential({Interval(working_bits())});
    return end ? std::optional(*end / of.half_length()) : end;
  };
  const auto stretch = [&](const NipSolution& of) -> Float {
    const Float length = 2 * of.half_length();
    return (of.tangential(0) - of.tangential(length)) / length;
  };
  return parts_->number(&Unit::slope, proven, stretch, half_length_of);
}

Estimate ConvergedNip::peak_pressure() const {
  const auto largest = [](const NipSolution& of) {
    return of.tractions(place_of_largest(of, &PressureAndShear::pressure)).pressure;
  };
  return parts_->number(&Unit::pressure, std::mem_fn(&ProvenResults::peak_pressure), largest, itself);
}

Estimate ConvergedNip::peak_pressure_position() const {
  // The middle, by symmetry and if there is only one peak.
  if (parts_->sheet->is_symmetric() && (parts_->sheet->sticks() || !parts_->proof))
    return {0, 0, parts_->digits};
  const auto place = [](const NipSolution& of) -> Float {
    return of.half_length() + of.offset() - place_of_largest(of, &PressureAndShear::pressure);
  };
  return parts_->number(&Unit::length, std::mem_fn(&ProvenResults::peak_pressure_position), place,
                        half_length_of);
}

Estimate ConvergedNip::peak_shear() const {
  if (!parts_->sheet->sticks()) return exact_zero(parts_->digits);
  const auto largest = [](const NipSolution& of) -> Float {
    return abs(of.tractions(place_of_largest(of, &PressureAndShear::shear)).shear);
  };
  return parts_->number(
      &Unit::pressure, std::mem_fn(&ProvenResults::peak_shear), largest,
      [](const NipSolution& of) -> Float { return pressure_of(of) * SolvedNip::kernel_share(); });
}

Estimate ConvergedNip::peak_shear_position() const {
  parts_->check_has_shear();
  const auto place = [](const NipSolution& of) -> Float {
    return abs(of.half_length() - place_of_largest(of, &PressureAndShear::shear));
  };
  return parts_->number(&Unit::length, unproven, place, half_length_of);
}

std::vector<Estimate> ConvergedNip::shear_zeros() const {
  parts_->check_has_shear();
  const WorkingDigits working(parts_->working_digits());
  std::vector<Estimate> zeros{exact_zero(parts_->digits)};
  for (const auto& [inner, outer] : shear_changes(parts_->by_panels())) {
    const NipSolution& fine = parts_->fine();
    const int sign = fine.tractions(inner * fine.half_length()).shear > 0 ? 1 : -1;
    const auto zero = [&, inner = inner, outer = outer](const NipSolution& of) -> Float {
      const Float& size = of.half_length();
      const auto shear = [&](const Float& x) -> Float { return sign * of.tractions(x).shear; };
      // The tolerance, 10^-(digits + 10) of the half length, is far below what SolvedNip::estimate() adds.
      const auto place = bracketed_root<Float>(shear, inner * size, outer * size,
                                               outer * size * std::numeric_limits<Float>::epsilon() * 1e4);
      if (!place) throw std::logic_error("a zero of the shear that is not found");
      return size - *place;
    };
    zeros.push_back(parts_->estimated(&Unit::length, zero, fine.half_length()));
  }
  return zeros;
}

Estimate ConvergedNip::pressure(double y) const {
  return parts_->traction(y, &PressureAndShear::pressure, &ProvenResults::pressure);
}

Estimate ConvergedNip::shear(double y) const {
  if (std::isfinite(y) && (!parts_->sheet->sticks() || y == 0)) return exact_zero(parts_->digits);
  return parts_->traction(y, &PressureAndShear::shear, &ProvenResults::shear);
}

Estimate ConvergedNip::normal_displacement(double y) const {
  parts_->check_place(y);
  return parts_->number(
      &Unit::displacement, [&](const ProvenResults& of) { return of.normal(parts_->place(y)); },
      [&](const NipSolution& of) { return of.normal(parts_->behind(of, y)); }, square_of);
}

Estimate ConvergedNip::tangential_displacement(double y) const {
  parts_->check_place(y);
  if (y == 0) return exact_zero(parts_->digits);
  return parts_->number(
      &Unit::displacement, [&](const ProvenResults& of) { return of.tangential(parts_->place(y)); },
      [&](const NipSolution& of) -> Float {
        return of.tangential(parts_->behind(of, y)) - parts_->tangential_at_middle(of);
      },
      [&](const NipSolution& of) -> Float {
        const Float distance = abs(Float(y) / parts_->in_unit(&Unit::length)), &size = of.half_length();
        return size * std::clamp(distance, Float(size * SolvedNip::kernel_share()), size);
      });
}

Estimate ConvergedNip::surface_strain(double y) const {
  parts_->check_place(y);
  const auto proven = [&](const ProvenResults& of) { return of.strain(parts_->place(y)); };
  if (const auto value = parts_->by_proof(&Unit::slope, proven)) return *value;
  const WorkingDigits working(parts_->working_digits());
  const NipSolution& fine = parts_->fine();
  const Float x = parts_->behind(fine, y);
  // Without friction the strain contains -beta p, and so beta times the error of the pressure.
  const Float at_once = parts_->sheet->sticks() ? Float(0) : parts_->sheet->beta();
  return parts_->estimated(
      &Unit::slope, [&](const NipSolution& of) { return of.strain(parts_->behind(of, y)); },
      fine.half_length() + (parts_->is_outside(x) ? Float(0) : Float(at_once * pressure_of(fine))),
      at_once * parts_->by_ends(x, &PressureAndShear::pressure));
}

std::vector<InnerStresses> ConvergedNip::inner_stresses(std::span<const InnerPoint> points) const {
  const WorkingDigits working(parts_->working_digits());
  std::optional<ContactField> field;
  std::vector<InnerStresses> stresses;
  for (const InnerPoint& point : points) {
    const SheetPoint place = checked_point(point, parts_->in_unit(&Unit::length));
    if (const auto proven = parts_->proven_stresses_at(point)) {
      stresses.push_back(*proven);
      continue;
    }
    if (!field) field.emplace(parts_->field());
    stresses.push_back(field->at(place, parts_->sheet->is_symmetric(), parts_->in_unit(&Unit::pressure)));
  }
  return stresses;
}

/// The error common to both solutions is taken as their largest relative difference times a scale: that of surface
/// displacements, or that of the displacements which the pressure causes, if it is larger.
std::vector<InnerDisplacements> ConvergedNip::inner_displacements(std::span<const InnerPoint> points) const {
  const WorkingDigits working(parts_->working_digits());
  const NipSolution& fine = parts_->fine();
  const Float pressed = pressure_of(fine) * std::min(Float(1), fine.half_length()),
              uncertain = (parts_->by_panels().difference() + pow(Float(10), -parts_->digits - 2)) *
                          std::max(square_of(fine), pressed);
  const Float& beta = parts_->sheet->beta();
  const ContactField field = parts_->field();
  std::vector<InnerDisplacements> displacements;
  for (const InnerPoint& point : points)
    displacements.push_back(field.displacements_at(checked_point(point, parts_->in_unit(&Unit::length)),
                                                   {1 - beta, beta}, uncertain,
                                                   parts_->in_unit(&Unit::displacement)));
  return displacements;
}

GreatestShear ConvergedNip::greatest_shear() const {
  const WorkingDigits working(parts_->working_digits());
  return parts_->field().greatest(parts_->sheet->is_symmetric(), parts_->in_unit(&Unit::pressure),
                                  parts_->in_unit(&Unit::length));
}

int ConvergedNip::unknowns() const {
  return parts_->solved ? parts_->solved->unknowns() : parts_->proof->contact->terms();
}

KernelValues ConvergedNip::kernel_values() const {
  return (parts_->solved ? parts_->solved->kernel_values() : KernelValues()) +
         (parts_->proof ? parts_->proof->contact->kernel_values() : KernelValues());
}

}  // namespace nipref::ref
