#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/internal/displacements_inside.hpp>
#include <nipref/ref/elastic_nip/internal/nip_units.hpp>
#include <nipref/ref/elastic_nip/internal/solved_contact.hpp>
#include <nipref/ref/elastic_nip/proven.hpp>
#include <nipref/ref/nip/internal/contact_field.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int least_digits = 16;
constexpr int most_digits = 100;
/// In sheet thicknesses.
constexpr double shortest = 1e-8, longest = 80;
/// Of a displacement, in half-thicknesses: ref's kernels end somewhat farther away.
constexpr double farthest = 900;

constexpr auto allowed_lengths =
    "must be at most the roller's radius and from 1e-8 to 80 sheet thicknesses for the reference expansion";

void check_digits_here(int digits) {
  if (digits < least_digits || digits > most_digits)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 100");
}

bool length_is_allowed(const data::ElasticNip& nip, double length) {
  return length >= shortest * nip.sheet_thickness && length <= longest * nip.sheet_thickness &&
         length <= nip.roller_radius;
}

Interval operator*(const mpq_class& unit, const Interval& x) {
  return Interval(Exact(unit), x.precision()) * x;
}

/// 2A sum_m c_m sin((2m + 1) theta) by Clenshaw's sum; e = 1 - cos theta from either end, in half lengths.
Float pressure_of(const std::vector<Float>& coefficients, const Float& half_length, const Float& e) {
  const Float square = e * (2 - e), twofold = 2 - 4 * square;  // sin^2 theta, 2 cos 2 theta
  Float now, last;
  for (std::size_t m = coefficients.size(); m-- > 0;)
    last = std::exchange(now, coefficients[m] + twofold * now - last);
  return 2 * half_length * sqrt(square) * (now + last);
}

FieldSource field_source(const ProvenExpansion& expansion, const Float& half_length) {
  const auto tractions = [&expansion, half_length](const Float& left, const Float& right) -> FaceTraction {
    return {pressure_of(expansion.coefficients, half_length, std::min(left, right) / half_length), 0};
  };
  return {0, half_length, tractions};
}

/// Both ends of what the half length may be. Where pressures miss up to a radius r, a half-plane's stresses miss r at
/// most and the sheet's, with both of them and what the faces reflect, not four times that.
ContactField field_of(const ContactFunctionals& contact, int digits) {
  const ProvenExpansion& expansion = contact.expansion();
  const Interval& A = contact.half_length();
  const Float lower = -upper_end(-A), upper = upper_end(A);
  const Float missed = 4 * 2 * upper * upper_end(expansion.radius);
  return {field_source(expansion, lower), field_source(expansion, upper),
          pressure_of(expansion.coefficients, upper, 1), missed, digits};
}

}  // namespace

struct ProvenElasticNip::Implementation {
  NipUnits units;
  std::optional<double> length;  ///< where it is given
  SolvedContact contact;

  template <class Result>
  [[nodiscard]] Enclosure enclosed(const mpq_class& unit, const Result& result) const {
    const WorkingDigits working(contact.working_digits());
    return enclosure_of(unit * result(*contact), contact.digits());
  }
  /// Of |y|.
  [[nodiscard]] SurfacePoint place(double y) const {
    const mpq_class distance = abs(exactly(y));
    if (length) return {Interval(Exact(1 - 2 * distance / exactly(*length)), working_bits())};
    return {1 - Interval(Exact(distance / units.length), working_bits()) / contact->half_length()};
  }
  void prove_largest_in_the_middle() const {
    const WorkingDigits working(contact.working_digits());
    if (!contact->falls_outwards())
      throw std::logic_error("a pressure that is not proven largest in the middle");
  }
  void check_distance(double y) const {
    if (!std::isfinite(y) || abs(exactly(y)) > farthest * units.length) {
      throw BadInput("y", y, "must be within 450 sheet thicknesses of the middle on the reference path");
    }
  }
};

ProvenElasticNip::ProvenElasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ProvenElasticNip::ProvenElasticNip(ProvenElasticNip&&) noexcept = default;
ProvenElasticNip::~ProvenElasticNip() = default;

Enclosure ProvenElasticNip::contact_length() const {
  return implementation_->enclosed(2 * implementation_->units.length,
                                   std::mem_fn(&ContactFunctionals::half_length));
}

Enclosure ProvenElasticNip::load() const {
  const NipUnits& units = implementation_->units;
  return implementation_->enclosed(units.pressure * units.length, std::mem_fn(&ContactFunctionals::load));
}

Enclosure ProvenElasticNip::indentation() const {
  return implementation_->enclosed(implementation_->units.displacement,
                                   std::mem_fn(&ContactFunctionals::indentation));
}

Enclosure ProvenElasticNip::edge_displacement() const {
  return implementation_->enclosed(implementation_->units.displacement,
                                   [](const ContactFunctionals& contact) {
                                     return contact.indentation() - square(contact.half_length());
                                   });
}

Enclosure ProvenElasticNip::creep_ratio() const {
  const NipUnits& units = implementation_->units;
  return implementation_->enclosed(units.slope, [&](const ContactFunctionals& contact) {
    const SurfacePoint end{Interval(working_bits())};
    const Interval beta(Exact(units.beta), working_bits());
    return contact.tangential_displacement(end, beta) / contact.half_length();
  });
}

Enclosure ProvenElasticNip::peak_pressure() const {
  implementation_->prove_largest_in_the_middle();
  return pressure(0);
}

Enclosure ProvenElasticNip::peak_pressure_position() const {
  implementation_->prove_largest_in_the_middle();
  return exact_zero(implementation_->contact.digits());
}

Enclosure ProvenElasticNip::pressure(double y) const {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  return implementation_->enclosed(implementation_->units.pressure, [&](const ContactFunctionals& contact) {
    return contact.pressure(implementation_->place(y));
  });
}

Enclosure ProvenElasticNip::normal_displacement(double y) const {
  implementation_->check_distance(y);
  return implementation_->enclosed(implementation_->units.displacement,
                                   [&](const ContactFunctionals& contact) {
                                     return contact.normal_displacement(implementation_->place(y));
                                   });
}

Enclosure ProvenElasticNip::tangential_displacement(double y) const {
  implementation_->check_distance(y);
  const NipUnits& units = implementation_->units;
  return implementation_->enclosed(units.displacement, [&](const ContactFunctionals& contact) {
    if (y == 0) return Interval(working_bits());
    const Interval beta(Exact(units.beta), working_bits());
    const Interval v = contact.tangential_displacement(implementation_->place(y), beta);
    return y < 0 ? -v : v;
  });
}

std::vector<InnerStresses> ProvenElasticNip::inner_stresses(std::span<const InnerPoint> points) const {
  const auto& [units, length, contact] = *implementation_;
  const WorkingDigits working(contact.working_digits());
  const ContactField field = field_of(*contact, contact.digits());
  std::vector<InnerStresses> stresses;
  for (const InnerPoint& point : points)
    stresses.push_back(
        field.at(checked_point(point, to_float(Exact(units.length))), true, to_float(Exact(units.pressure))));
  return stresses;
}

/// Pressures miss 2A r at most. Under a line load v is at most 1.3 and u at most (2/pi) (2 + ln(1/a)) at a distance a < 1, which
/// over the contact makes less than 4A (2 + ln(1/A)).
std::vector<InnerDisplacements> ProvenElasticNip::inner_displacements(
    std::span<const InnerPoint> points) const {
  const auto& [units, length, contact] = *implementation_;
  const WorkingDigits working(contact.working_digits());
  const Float A = upper_end(contact->half_length());
  const Float uncertain =
      2 * A * upper_end(contact->expansion().radius) * 4 * A * (2 - log(std::min(Float(1), A))) +
      A * A * pow(Float(10), -contact.digits() - 2);
  return displacements_inside(field_of(*contact, contact.digits()), units, points, uncertain);
}

GreatestShear ProvenElasticNip::greatest_shear() const {
  const auto& [units, length, contact] = *implementation_;
  const WorkingDigits working(contact.working_digits());
  return field_of(*contact, contact.digits())
      .greatest(true, to_float(Exact(units.pressure)), to_float(Exact(units.length)));
}

Enclosure ProvenElasticNip::surface_strain(double y) const {
  implementation_->check_distance(y);
  const NipUnits& units = implementation_->units;
  return implementation_->enclosed(units.slope, [&](const ContactFunctionals& contact) {
    return contact.strain(implementation_->place(y), Interval(Exact(units.beta), working_bits()));
  });
}

int ProvenElasticNip::terms() const { return implementation_->contact->terms(); }
long ProvenElasticNip::kernel_values() const { return implementation_->contact.kernel_values(); }
long ProvenElasticNip::coupling_values() const { return implementation_->contact->coupling_values(); }

namespace {

Exact checked_half_length(const data::ElasticNip& nip, double contact_length, int digits) {
  nip.check();
  check_digits_here(digits);
  if (!length_is_allowed(nip, contact_length))
    throw BadInput("contact_length", contact_length, allowed_lengths);
  return Exact(exactly(contact_length) / exactly(nip.sheet_thickness));
}

}  // namespace

ProvenElasticNip proven_for_length(const data::ElasticNip& nip, double contact_length, int digits) {
  const Exact half_length = checked_half_length(nip, contact_length, digits);
  return ProvenElasticNip(std::make_unique<ProvenElasticNip::Implementation>(
      NipUnits(nip), contact_length, SolvedContact::of_half_length(half_length, digits, I1_interval)));
}

int proven_terms(const data::ElasticNip& nip, double contact_length, int digits) {
  return SolvedContact::terms_of(checked_half_length(nip, contact_length, digits).approximate(), digits);
}

ProvenElasticNip proven_for_load(const data::ElasticNip& nip, double load, int digits) {
  nip.check();
  check_digits_here(digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const auto refuse = [&] {
    throw BadInput("load", load, std::string("gives a contact whose length ") + allowed_lengths);
  };
  const NipUnits units(nip);
  const Exact wanted(exactly(load) / (units.pressure * units.length));
  const double guess = guessed_half_length(wanted.approximate());
  const double most = std::min(longest, nip.roller_radius / nip.sheet_thickness);
  if (!(guess > 0.8 * shortest && guess < 1.25 * most)) refuse();
  const auto check = [&](double half_length) {
    if (!length_is_allowed(nip, half_length * nip.sheet_thickness)) refuse();
  };
  auto solved = std::make_unique<ProvenElasticNip::Implementation>(
      units, std::nullopt, SolvedContact::of_load(wanted, guess, check, digits, I1_interval));
  return ProvenElasticNip(std::move(solved));
}

}  // namespace nipref::ref
