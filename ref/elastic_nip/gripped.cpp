#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/gripped.hpp>
#include <nipref/ref/elastic_nip/internal/grip_expansion.hpp>
#include <nipref/ref/elastic_nip/internal/grip_precision.hpp>
#include <nipref/ref/elastic_nip/internal/nip_units.hpp>
#include <nipref/ref/nip/internal/contact_field.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/number/internal/golden_section.hpp>
#include <nipref/ref/number/internal/local_slope.hpp>

namespace nipref::ref {
namespace {

constexpr int least_grip_digits = 16, most_grip_digits = 50;
/// In sheet thicknesses.
constexpr double shortest_grip = 1e-8, longest_grip = 80;
/// Of a displacement, in half-thicknesses: ref's kernels end somewhat farther away.
constexpr double farthest_grip = 900;
constexpr int most_grip_terms = 1200;
/// Of the search for a length.
constexpr int most_grip_steps = 40;
constexpr int first_grip_digits = 8;

constexpr auto allowed_grip_lengths =
    "must be at most the roller's radius and from 1e-8 to 80 sheet thicknesses for the reference expansion";

bool grip_length_is_allowed(const data::ElasticNip& nip, double length) {
  return length >= shortest_grip * nip.sheet_thickness && length <= longest_grip * nip.sheet_thickness &&
         length <= nip.roller_radius;
}

void check_grip_digits(int digits) {
  if (digits < least_grip_digits || digits > most_grip_digits)
    throw data::BadInput("digits", std::to_string(digits), "must be from 16 to 50 with full friction");
}

void check_grip_terms(double half_length, int expansion, int digits) {
  if (grip_terms(half_length, expansion) <= most_grip_terms) return;
  int fewer = digits;
  while (fewer > 0 && grip_terms(half_length, expansion - digits + fewer) > most_grip_terms) --fewer;
  throw data::BadInput(
      "digits", std::to_string(digits),
      fmt::format("must be fewer for a contact with friction of {:.6g} sheet thicknesses: with {} terms, the "
                  "most that are tried, its expansion is good to {}",
                  half_length, most_grip_terms, fewer));
}

/// Solves at half lengths, and finds the one that carries a load.
class GripSolver {
 public:
  GripSolver(const mpq_class& beta, const GripPrecision& precision, GripKernels& kernels)
      : beta_(to_float(Exact(beta))), precision_(precision), kernels_(kernels) {}

  using Layout = GripLayout (*)(double half_length, int expansion);

  [[nodiscard]] GripExpansion at(const Float& half_length, Layout layout, int expansion) const {
    const auto near = static_cast<double>(half_length);
    check_grip_terms(near, expansion, precision_.digits);
    return {half_length, beta_, layout(near, expansion), kernels_};
  }

  /// Newton's steps for ln W as a function of ln A, with few digits first.
  [[nodiscard]] GripExpansion carrying(const Float& load, Float half_length, Layout layout) const {
    int digits = std::min(first_grip_digits, precision_.expansion);
    for (int step = 0;; ++step) {
      GripExpansion here = at(half_length, layout, digits);
      const Float change = log(load / here.load()) / here.growth();
      const bool last = digits == precision_.expansion;
      if (last && abs(change) <= pow(Float(10), -digits)) return here;
      if (step == most_grip_steps) throw std::logic_error("a length for a load that is not found");
      half_length *= exp(change);
      const double known = -std::log10(std::max(std::fabs(static_cast<double>(change)), 1e-300));
      if (2 * known > digits) digits = std::min(precision_.expansion, 2 * digits + 4);
    }
  }

 private:
  Float beta_;
  GripPrecision precision_;
  GripKernels& kernels_;
};

/// Angle of a place, t = cos(angle), between which and the next the largest |part| of the tractions lies.
struct LargestBetween {
  Float low, high;
};

Float size_at_angle(const GripExpansion& contact, Float GripTraction::*part, const Float& angle) {
  const Float half = sin(angle / 2);
  return abs(contact.traction(2 * half * half).*part);
}

/// By samples even in the angle.
LargestBetween largest_between(const GripExpansion& contact, Float GripTraction::*part) {
  const int samples = 2 * contact.terms() + 100;
  const Float step = pi() / (2 * samples);
  int best = 0;
  Float largest = 0;
  {
    const WorkingDigits few(25);
    for (int i = 0; i <= samples; ++i) {
      const Float here = at_working_precision(size_at_angle(contact, part, i * step));
      if (here > largest) largest = here, best = i;
    }
  }
  return {std::max(0, best - 1) * step, std::min(samples, best + 1) * step};
}

/// By golden section, which places it to half the digits.
Float largest_traction(const GripExpansion& contact, Float GripTraction::*part) {
  const auto size = [&](const Float& angle) { return size_at_angle(contact, part, angle); };
  const auto [low, high] = largest_between(contact, part);
  const Float enough = sqrt(std::numeric_limits<Float>::epsilon()) * (high - low);
  return std::max({size(place_of_largest(size, low, high, enough)), size(low), size(high)});
}

/// Y > 0 of the largest shear, half-thicknesses, to all digits: the zero of its slope.
Float place_of_largest_shear(const GripExpansion& contact) {
  const auto shear = [&](const Float& before_end) { return contact.traction(before_end).shear; };
  const auto [low, high] = largest_between(contact, &GripTraction::shear);
  const auto before_end = [](const Float& angle) -> Float {
    const Float half = sin(angle / 2);
    return 2 * half * half;
  };
  // The first sample is at the end itself, where the largest shear is not.
  const Float nearer = std::max(before_end(low), before_end(high) / 64), farther = before_end(high);
  const int sign = shear(farther) > 0 ? 1 : -1;
  const auto slope = [&](const Float& place) -> Float { return sign * local_slope(shear, place, place / 4); };
  const Float enough = nearer * std::numeric_limits<Float>::epsilon() * 1e4;
  const auto place = bracketed_root<Float>(slope, nearer, farther, enough);
  if (!place) throw std::logic_error("a largest shear that is not found");
  return contact.half_length() * (1 - *place);
}

/// Places before the end, in half lengths and falling, between which and the next the shear of both changes its sign.
std::vector<std::pair<Float, Float>> shear_changes(const GripExpansion& fine, const GripExpansion& coarse) {
  constexpr int steps = 400;
  std::vector<std::pair<Float, Float>> changes;
  std::optional<Float> last;
  bool was_positive = false;
  for (int i = 1; i <= steps; ++i) {
    const Float place = exp(log(Float(1e-6)) * i / steps);
    const Float here = fine.traction(place).shear, other = coarse.traction(place).shear;
    if (!(abs(here) > 2 * abs(here - other))) continue;
    if (last && was_positive != (here > 0)) changes.emplace_back(*last, place);
    last = place;
    was_positive = here > 0;
  }
  return changes;
}

}  // namespace

namespace {

FieldSource field_source(const GripExpansion& contact) {
  const auto tractions = [&contact](const Float& left, const Float& right) -> FaceTraction {
    const GripTraction here = contact.traction(std::min(left, right) / contact.half_length());
    return {here.pressure, left < right ? -here.shear : here.shear};
  };
  return {0, contact.half_length(), tractions};
}

}  // namespace

struct GrippedElasticNip::Implementation {
  NipUnits units;
  std::optional<double> length;  ///< where it is given
  GripPrecision precision;
  GripKernels kernels;
  std::optional<GripExpansion> coarse, fine;

  Implementation(NipUnits the_units, std::optional<double> the_length, const GripPrecision& the_precision)
      : units(std::move(the_units)),
        length(the_length),
        precision(the_precision),
        kernels(the_precision.kernel) {}

  /// Twice the distance of both expansions, and for rounding a hundredth of the last digit of the value or of
  /// `least`, which it is measured by.
  [[nodiscard]] Estimate estimated(const mpq_class& unit, const Float& rough, const Float& value,
                                   const Float& least = 0, const Float& further = 0) const {
    const Float size = std::max(abs(value), least);
    const Float error = 2 * abs(value - rough) + further + size * pow(Float(10), -precision.digits - 2);
    const Float factor = to_float(Exact(unit));
    return {factor * value, factor * error, precision.digits};
  }

  template <class Result>
  [[nodiscard]] Estimate number(const mpq_class& unit, const Result& result, const Float& least = 0) const {
    return estimated(unit, result(*coarse), result(*fine), least);
  }

  [[nodiscard]] ContactField field() const {
    return {field_source(*coarse), field_source(*fine), fine->traction(1).pressure, 0, precision.digits};
  }

  /// Of |y| from the end, in half lengths.
  [[nodiscard]] Float before_end(double y, const GripExpansion& contact) const {
    const mpq_class distance = abs(exactly(y));
    if (length) return to_float(Exact(1 - 2 * distance / exactly(*length)));
    return 1 - to_float(Exact(distance / units.length)) / contact.half_length();
  }
  [[nodiscard]] Float square_length() const { return fine->half_length() * fine->half_length(); }

  [[nodiscard]] Estimate traction(double y, Float GripTraction::*part, bool odd) const {
    if (!std::isfinite(y)) throw data::BadInput("y", y, "must be finite");
    const auto value = [&](const GripExpansion& contact) {
      const Float size = contact.traction(before_end(y, contact)).*part;
      return odd && y < 0 ? -size : size;
    };
    if (!(before_end(y, *fine) > 0) || (odd && y == 0)) return exact_zero(precision.digits);
    const Float middle = fine->traction(1).pressure;
    return number(units.pressure, value, middle);
  }

  /// `inside` in the contact, where it has a closed form; else by quadrature. Measured by `least` at least.
  template <class Inside>
  [[nodiscard]] Estimate displacement(double y, const mpq_class& unit, const Float& least,
                                      Float GripDisplacement::*part, bool odd, const Inside& inside) {
    if (!std::isfinite(y) || abs(exactly(y)) > farthest_grip * units.length)
      throw data::BadInput("y", y,
                           "must be within 450 sheet thicknesses of the middle on the reference path");
    if (odd && y == 0) return exact_zero(precision.digits);
    Float further = 0;
    const auto value = [&](const GripExpansion& contact) -> Float {
      const Float place = before_end(y, contact);
      if (!(place < 0)) return inside(contact, place);
      const Float enough = pow(Float(10), -precision.digits - 3);
      const GripOutside outside = contact.displacement_outside(place, enough, kernels);
      further = std::max(further, outside.error.*part);
      return outside.value.*part;
    };
    const Float rough = value(*coarse), finer = value(*fine);
    const int sign = odd && y < 0 ? -1 : 1;
    return estimated(unit, sign * rough, sign * finer, least, further);
  }
};

GrippedElasticNip::GrippedElasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
GrippedElasticNip::GrippedElasticNip(GrippedElasticNip&&) noexcept = default;
GrippedElasticNip::~GrippedElasticNip() = default;

Estimate GrippedElasticNip::contact_length() const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->number(2 * implementation_->units.length, std::mem_fn(&GripExpansion::half_length));
}

Estimate GrippedElasticNip::load() const {
  const WorkingDigits working(implementation_->precision.working);
  const NipUnits& units = implementation_->units;
  return implementation_->number(units.pressure * units.length, std::mem_fn(&GripExpansion::load));
}

Estimate GrippedElasticNip::indentation() const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->number(implementation_->units.displacement,
                                 std::mem_fn(&GripExpansion::indentation), implementation_->square_length());
}

Estimate GrippedElasticNip::edge_displacement() const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->number(implementation_->units.displacement,
                                 std::mem_fn(&GripExpansion::edge_displacement),
                                 implementation_->square_length());
}

Estimate GrippedElasticNip::creep_ratio() const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->number(implementation_->units.slope, std::mem_fn(&GripExpansion::creep),
                                 implementation_->fine->half_length());
}

Estimate GrippedElasticNip::peak_pressure() const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->number(implementation_->units.pressure, [](const GripExpansion& contact) {
    return largest_traction(contact, &GripTraction::pressure);
  });
}

Estimate GrippedElasticNip::peak_shear() const {
  const WorkingDigits working(implementation_->precision.working);
  const Float middle = implementation_->fine->traction(1).pressure;
  return implementation_->number(
      implementation_->units.pressure,
      [](const GripExpansion& contact) { return largest_traction(contact, &GripTraction::shear); }, middle);
}

Estimate GrippedElasticNip::peak_shear_position() const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->number(implementation_->units.length, place_of_largest_shear,
                                 implementation_->fine->half_length());
}

std::vector<Estimate> GrippedElasticNip::shear_zeros() const {
  const WorkingDigits working(implementation_->precision.working);
  const auto& fine = *implementation_->fine;
  std::vector<Estimate> zeros{exact_zero(implementation_->precision.digits)};
  for (const auto& [inner, outer] : shear_changes(fine, *implementation_->coarse)) {
    const auto zero = [&](const GripExpansion& contact) -> Float {
      const int sign = fine.traction(inner).shear > 0 ? 1 : -1;
      const auto shear = [&](const Float& place) -> Float { return sign * contact.traction(place).shear; };
      const auto place =
          bracketed_root<Float>(shear, inner, outer, outer * std::numeric_limits<Float>::epsilon() * 1e4);
      if (!place) throw std::logic_error("a zero of the shear that is not found");
      return contact.half_length() * (1 - *place);
    };
    zeros.push_back(implementation_->number(implementation_->units.length, zero, fine.half_length()));
  }
  return zeros;
}

Estimate GrippedElasticNip::pressure(double y) const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->traction(y, &GripTraction::pressure, false);
}

Estimate GrippedElasticNip::shear(double y) const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->traction(y, &GripTraction::shear, true);
}

Estimate GrippedElasticNip::normal_displacement(double y) const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->displacement(
      y, implementation_->units.displacement, implementation_->square_length(), &GripDisplacement::normal,
      false, [](const GripExpansion& contact, const Float& before_end) {
        const Float length = contact.half_length();
        return contact.edge_displacement() + length * length * before_end * (2 - before_end);
      });
}

Estimate GrippedElasticNip::tangential_displacement(double y) const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->displacement(y, implementation_->units.displacement,
                                       implementation_->square_length(), &GripDisplacement::tangential, true,
                                       [](const GripExpansion& contact, const Float& before_end) {
                                         return contact.creep() * contact.half_length() * (1 - before_end);
                                       });
}

std::vector<InnerStresses> GrippedElasticNip::inner_stresses(std::span<const InnerPoint> points) const {
  const WorkingDigits working(implementation_->precision.working);
  const NipUnits& units = implementation_->units;
  const ContactField field = implementation_->field();
  std::vector<InnerStresses> stresses;
  for (const InnerPoint& point : points)
    stresses.push_back(
        field.at(checked_point(point, to_float(Exact(units.length))), true, to_float(Exact(units.pressure))));
  return stresses;
}

GreatestShear GrippedElasticNip::greatest_shear() const {
  const WorkingDigits working(implementation_->precision.working);
  const NipUnits& units = implementation_->units;
  return implementation_->field().greatest(true, to_float(Exact(units.pressure)),
                                           to_float(Exact(units.length)));
}

Estimate GrippedElasticNip::surface_strain(double y) const {
  const WorkingDigits working(implementation_->precision.working);
  return implementation_->displacement(
      y, implementation_->units.slope, implementation_->fine->half_length(), &GripDisplacement::strain, false,
      [](const GripExpansion& contact, const Float&) { return contact.creep(); });
}

int GrippedElasticNip::terms() const { return implementation_->fine->terms(); }
long GrippedElasticNip::normal_values() const { return implementation_->kernels.normal.kernel_values(); }
long GrippedElasticNip::coupling_values() const { return implementation_->kernels.coupling.kernel_values(); }
long GrippedElasticNip::stretch_values() const { return implementation_->kernels.stretch.kernel_values(); }

namespace {

/// What may be solved at a given length, in half-thicknesses.
struct GripOfLength {
  Exact half_length;
  GripPrecision precision;

  GripOfLength(const data::ElasticNip& nip, double contact_length, int digits)
      : half_length(exactly(contact_length) / exactly(nip.sheet_thickness)),
        precision(half_length.approximate(), digits, false) {}
};

GripOfLength checked_grip(const data::ElasticNip& nip, double contact_length, int digits) {
  nip.check();
  check_grip_digits(digits);
  if (!grip_length_is_allowed(nip, contact_length))
    throw data::BadInput("contact_length", contact_length, allowed_grip_lengths);
  GripOfLength grip(nip, contact_length, digits);
  check_grip_terms(grip.half_length.approximate(), grip.precision.expansion, digits);
  return grip;
}

}  // namespace

int gripped_unknowns(const data::ElasticNip& nip, double contact_length, int digits) {
  const auto [half_length, precision] = checked_grip(nip, contact_length, digits);
  return fine_layout(half_length.approximate(), precision.expansion).terms + 2;
}

GrippedElasticNip gripped_for_length(const data::ElasticNip& nip, double contact_length, int digits) {
  const auto [half_length, precision] = checked_grip(nip, contact_length, digits);
  const WorkingDigits working(precision.working);
  auto solved = std::make_unique<GrippedElasticNip::Implementation>(NipUnits(nip), contact_length, precision);
  const GripSolver solver(solved->units.beta, precision, solved->kernels);
  const Float here = to_float(half_length);
  solved->coarse = solver.at(here, coarse_layout, precision.expansion);
  solved->fine = solver.at(here, fine_layout, precision.expansion);
  return GrippedElasticNip(std::move(solved));
}

GrippedElasticNip gripped_for_load(const data::ElasticNip& nip, double load, int digits) {
  nip.check();
  check_grip_digits(digits);
  if (!(std::isfinite(load) && load > 0)) throw data::BadInput("load", load, "must be finite and > 0");
  const auto refuse = [&] {
    throw data::BadInput("load", load, std::string("gives a contact whose length ") + allowed_grip_lengths);
  };
  const NipUnits units(nip);
  const Exact wanted(exactly(load) / (units.pressure * units.length));
  const double guess = guessed_half_length(wanted.approximate());
  const double most = std::min(longest_grip, nip.roller_radius / nip.sheet_thickness);
  if (!(guess > 0.5 * shortest_grip && guess < 2 * most)) refuse();
  const GripPrecision precision(guess, digits, true);
  const WorkingDigits working(precision.working);
  auto solved = std::make_unique<GrippedElasticNip::Implementation>(units, std::nullopt, precision);
  const GripSolver solver(units.beta, precision, solved->kernels);
  solved->fine = solver.carrying(to_float(wanted), guess, fine_layout);
  solved->coarse = solver.carrying(to_float(wanted), solved->fine->half_length(), coarse_layout);
  const auto length = static_cast<double>(solved->fine->half_length()) * nip.sheet_thickness;
  if (!grip_length_is_allowed(nip, length)) refuse();
  return GrippedElasticNip(std::move(solved));
}

}  // namespace nipref::ref
