#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/internal/displacements_inside.hpp>
#include <nipref/ref/elastic_nip/internal/nip_units.hpp>
#include <nipref/ref/nip/internal/contact_field.hpp>
#include <nipref/ref/nip/internal/solved_nip.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/number/internal/golden_section.hpp>
#include <nipref/ref/number/internal/local_slope.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int fewest_elastic_digits = 16, most_elastic_digits = 100;
/// Contact lengths in sheet thicknesses. Stresses inside sum the waves of all of the contact, so that they are computed of
/// shorter ones only.
constexpr double shortest_elastic = 1e-8, longest_elastic = 1000, longest_elastic_inside = 80;
/// The largest distance from the contact at which displacements are computed, in half-thicknesses.
constexpr double farthest_elastic = 900;

constexpr auto allowed_elastic_lengths =
    "must be at most the roller's radius and from 1e-8 to 1000 sheet thicknesses for the reference";

bool elastic_length_is_allowed(const data::ElasticNip& nip, double length) {
  return length >= shortest_elastic * nip.sheet_thickness &&
         length <= longest_elastic * nip.sheet_thickness && length <= nip.roller_radius;
}

void check_elastic_digits(int digits) {
  if (digits < fewest_elastic_digits || digits > most_elastic_digits)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 100 for a nip by panels");
}

/// The elastic nip for SolvedNip.
class ElasticModel {
 public:
  using Solution = ElasticSolution;

  ElasticModel(const NipUnits& units, data::Friction friction)
      : sheet_(friction == data::Friction::full, to_float(Exact(units.beta))) {}

  [[nodiscard]] bool grips() const { return sheet_.grips; }
  [[nodiscard]] Resolution resolution() const { return sheet_.resolution(); }
  [[nodiscard]] static int lost_digits() { return 0; }
  [[nodiscard]] int unknowns(const std::vector<TractionPanel>& panels) const {
    int terms = 0;
    for (const TractionPanel& panel : panels) terms += panel.terms;
    return grips() ? 2 * terms + 2 : terms + 1;
  }
  [[nodiscard]] std::unique_ptr<Solution> solved(const Float& half_length, std::vector<TractionPanel> panels,
                                                 double nats, SheetKernels& kernels) const {
    return std::make_unique<Solution>(
        sheet_, Tractions(half_length, std::move(panels), sheet_.epsilon(), grips(), nats), kernels);
  }

 private:
  ElasticSheet sheet_;
};

using SolvedElasticNip = SolvedNip<ElasticModel>;

/// Distances from the end between which and the next the largest |part| of the tractions lies.
struct Between {
  Float low, high;
};

/// Distances from the end, rising, on all panels.
std::vector<Float> samples_of(const ElasticSolution& contact) {
  constexpr int per_panel = 40;
  std::vector<Float> samples;
  for (const TractionPanel& panel : contact.panels()) {
    for (int i = 0; i < per_panel; ++i) samples.push_back(panel.left + i * panel.width / per_panel);
  }
  samples.push_back(contact.half_length());
  return samples;
}

Between largest_between(const ElasticSolution& contact, Float PressureAndShear::*part) {
  const std::vector<Float> samples = samples_of(contact);
  std::size_t best = 0;
  Float largest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Float here = abs(contact.tractions(samples[i]).*part);
    if (here > largest) largest = here, best = i;
  }
  return {samples[best == 0 ? 0 : best - 1], samples[std::min(best + 1, samples.size() - 1)]};
}

/// The largest |part|, by golden section, which finds its place to half the digits.
Float largest_traction(const ElasticSolution& contact, Float PressureAndShear::*part) {
  const auto size = [&](const Float& e) -> Float { return abs(contact.tractions(e).*part); };
  const auto [low, high] = largest_between(contact, part);
  const Float enough = sqrt(std::numeric_limits<Float>::epsilon()) * (high - low);
  return std::max({size(place_of_largest(size, low, high, enough)), size(low), size(high)});
}

/// Y > 0 of the largest shear, half-thicknesses, to all digits: the zero of its slope.
Float place_of_largest_shear(const ElasticSolution& contact) {
  const auto shear = [&](const Float& e) { return contact.tractions(e).shear; };
  const auto [low, high] = largest_between(contact, &PressureAndShear::shear);
  // The first sample is at the end itself, where the largest shear is not.
  const Float nearer = std::max(low, Float(high / 64));
  const int sign = shear(high) > 0 ? 1 : -1;
  const auto slope = [&](const Float& place) -> Float { return sign * local_slope(shear, place, place / 4); };
  const Float enough = nearer * std::numeric_limits<Float>::epsilon() * 1e4;
  const auto place = bracketed_root<Float>(slope, nearer, high, enough);
  if (!place) throw std::logic_error("a largest shear that is not found");
  return contact.half_length() - *place;
}

/// Places before the end, over the half length and falling, between which and the next the shear of both solutions changes
/// its sign.
std::vector<std::pair<Float, Float>> shear_changes(const ElasticSolution& fine,
                                                   const ElasticSolution& coarse) {
  constexpr int steps = 400;
  std::vector<std::pair<Float, Float>> changes;
  std::optional<Float> last;
  bool was_positive = false;
  for (int i = 1; i <= steps; ++i) {
    const Float place = exp(log(Float(1e-6)) * i / steps);
    const Float here = fine.tractions(place * fine.half_length()).shear,
                other = coarse.tractions(place * coarse.half_length()).shear;
    if (!(abs(here) > 2 * abs(here - other))) continue;
    if (last && was_positive != (here > 0)) changes.emplace_back(*last, place);
    last = place;
    was_positive = here > 0;
  }
  return changes;
}

FieldSource field_source(const ElasticSolution& contact) {
  const auto tractions = [&contact](const Float& left, const Float& right) -> FaceTraction {
    const PressureAndShear here = contact.tractions(std::min(left, right));
    return {here.pressure, left < right ? Float(-here.shear) : here.shear};
  };
  return {0, contact.half_length(), tractions};
}

}  // namespace

struct ConvergedElasticNip::Implementation {
  NipUnits units;
  std::optional<double> length;  ///< where it is given
  SolvedElasticNip solved;

  [[nodiscard]] const ElasticSolution& fine() const { return solved.fine(); }
  [[nodiscard]] Float size() const { return fine().half_length(); }
  [[nodiscard]] Float square() const { return size() * size(); }
  [[nodiscard]] Float middle_pressure() const { return fine().tractions(size()).pressure; }
  [[nodiscard]] int working_digits() const { return SolvedElasticNip::working_digits(solved.digits(), 0); }

  /// The estimate of a functional whose scale is its value, or `least` if that is larger.
  [[nodiscard]] Estimate number(const mpq_class& unit, const SolvedElasticNip::Functional& functional,
                                const std::function<Float()>& least) const {
    const WorkingDigits working(working_digits());
    const data::WithError<Float> estimate = solved.estimate(functional, least());
    const Float factor = to_float(Exact(unit));
    return {factor * estimate.value, factor * estimate.error, solved.digits()};
  }
  [[nodiscard]] Estimate number(const mpq_class& unit, const SolvedElasticNip::Functional& functional) const {
    return number(unit, functional, [] { return Float(0); });
  }
  void check_has_shear() const {
    if (!solved.model().grips())
      throw BadInput("friction.model", "none", "must be full for places of the shear");
  }
  /// e of |y|.
  [[nodiscard]] Float before_end(double y, const ElasticSolution& contact) const {
    const mpq_class distance = abs(exactly(y)) / units.length;
    if (length) return to_float(Exact(exactly(*length) / (2 * units.length) - distance));
    return contact.half_length() - to_float(Exact(distance));
  }
  [[nodiscard]] Estimate traction(double y, Float PressureAndShear::*part, bool odd) const {
    if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
    const WorkingDigits working(working_digits());
    if (!(before_end(y, fine()) > 0) || (odd && (y == 0 || !solved.model().grips())))
      return exact_zero(solved.digits());
    const int sign = odd && y < 0 ? -1 : 1;
    return number(
        units.pressure,
        [&](const ElasticSolution& contact) -> Float {
          return sign * contact.tractions(before_end(y, contact)).*part;
        },
        [&] { return middle_pressure(); });
  }
  using Displacement = Float (ElasticSolution::*)(const Float&, SheetKernels&) const;
  [[nodiscard]] Estimate displacement(double y, const mpq_class& unit, Displacement function, bool odd,
                                      const std::function<Float()>& least) const {
    const WorkingDigits working(working_digits());
    if (!std::isfinite(y) || before_end(y, fine()) < -farthest_elastic)
      throw BadInput("y", y, "must be within 450 sheet thicknesses of the contact on the reference path");
    if (odd && y == 0) return exact_zero(solved.digits());
    const int sign = odd && y < 0 ? -1 : 1;
    return number(
        unit,
        [&](const ElasticSolution& contact) -> Float {
          return sign * (contact.*function)(before_end(y, contact), solved.kernels());
        },
        least);
  }
  [[nodiscard]] ContactField field() const {
    if (size() > longest_elastic_inside) {
      throw BadInput("contact_length", static_cast<double>(2 * size() * to_float(Exact(units.length))),
                     "must be at most 80 sheet thicknesses inside on the reference path");
    }
    const Float scale = middle_pressure();
    return {field_source(solved.coarse()), field_source(fine()), scale, scale * solved.difference(),
            solved.digits()};
  }
};

ConvergedElasticNip::ConvergedElasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedElasticNip::ConvergedElasticNip(ConvergedElasticNip&&) noexcept = default;
ConvergedElasticNip::~ConvergedElasticNip() = default;

Estimate ConvergedElasticNip::contact_length() const {
  return implementation_->number(2 * implementation_->units.length,
                                 std::mem_fn(&ElasticSolution::half_length));
}

Estimate ConvergedElasticNip::load() const {
  const NipUnits& units = implementation_->units;
  return implementation_->number(units.pressure * units.length, std::mem_fn(&ElasticSolution::load));
}

Estimate ConvergedElasticNip::indentation() const {
  return implementation_->number(implementation_->units.displacement,
                                 std::mem_fn(&ElasticSolution::indentation),
                                 [this] { return implementation_->square(); });
}

Estimate ConvergedElasticNip::edge_displacement() const {
  return implementation_->number(
      implementation_->units.displacement, std::mem_fn(&ElasticSolution::edge_displacement),
      [this] { return implementation_->square() * SolvedElasticNip::kernel_share(); });
}

Estimate ConvergedElasticNip::creep_ratio() const {
  return implementation_->number(
      implementation_->units.slope,
      [&](const ElasticSolution& contact) { return contact.creep(implementation_->solved.kernels()); },
      [this] { return implementation_->size(); });
}

Estimate ConvergedElasticNip::peak_pressure() const {
  return implementation_->number(implementation_->units.pressure, [](const ElasticSolution& contact) {
    return largest_traction(contact, &PressureAndShear::pressure);
  });
}

Estimate ConvergedElasticNip::peak_pressure_position() const {
  return exact_zero(implementation_->solved.digits());
}

Estimate ConvergedElasticNip::peak_shear() const {
  if (!implementation_->solved.model().grips()) return exact_zero(implementation_->solved.digits());
  return implementation_->number(
      implementation_->units.pressure,
      [](const ElasticSolution& contact) { return largest_traction(contact, &PressureAndShear::shear); },
      [this] { return implementation_->middle_pressure() * SolvedElasticNip::kernel_share(); });
}

Estimate ConvergedElasticNip::peak_shear_position() const {
  implementation_->check_has_shear();
  return implementation_->number(implementation_->units.length, place_of_largest_shear,
                                 [this] { return implementation_->size(); });
}

std::vector<Estimate> ConvergedElasticNip::shear_zeros() const {
  implementation_->check_has_shear();
  const WorkingDigits working(implementation_->working_digits());
  const ElasticSolution& fine = implementation_->fine();
  std::vector<Estimate> zeros{exact_zero(implementation_->solved.digits())};
  for (const auto& [inner, outer] : shear_changes(fine, implementation_->solved.coarse())) {
    const int sign = fine.tractions(inner * fine.half_length()).shear > 0 ? 1 : -1;
    const auto zero = [&, inner = inner, outer = outer](const ElasticSolution& contact) -> Float {
      const Float& size = contact.half_length();
      const auto shear = [&](const Float& e) -> Float { return sign * contact.tractions(e).shear; };
      const auto place = bracketed_root<Float>(shear, inner * size, outer * size,
                                               outer * size * std::numeric_limits<Float>::epsilon() * 1e4);
      if (!place) throw std::logic_error("a zero of the shear that is not found");
      return size - *place;
    };
    zeros.push_back(implementation_->number(implementation_->units.length, zero,
                                            [this] { return implementation_->size(); }));
  }
  return zeros;
}

Estimate ConvergedElasticNip::pressure(double y) const {
  return implementation_->traction(y, &PressureAndShear::pressure, false);
}

Estimate ConvergedElasticNip::shear(double y) const {
  return implementation_->traction(y, &PressureAndShear::shear, true);
}

Estimate ConvergedElasticNip::normal_displacement(double y) const {
  return implementation_->displacement(y, implementation_->units.displacement, &ElasticSolution::normal,
                                       false, [this] { return implementation_->square(); });
}

Estimate ConvergedElasticNip::tangential_displacement(double y) const {
  return implementation_->displacement(y, implementation_->units.displacement, &ElasticSolution::tangential,
                                       true, [this] { return implementation_->square(); });
}

Estimate ConvergedElasticNip::surface_strain(double y) const {
  return implementation_->displacement(y, implementation_->units.slope, &ElasticSolution::strain, false,
                                       [this] { return implementation_->size(); });
}

std::vector<InnerStresses> ConvergedElasticNip::inner_stresses(std::span<const InnerPoint> points) const {
  const WorkingDigits working(implementation_->working_digits());
  const NipUnits& units = implementation_->units;
  const ContactField field = implementation_->field();
  std::vector<InnerStresses> stresses;
  for (const InnerPoint& point : points)
    stresses.push_back(
        field.at(checked_point(point, to_float(Exact(units.length))), true, to_float(Exact(units.pressure))));
  return stresses;
}

/// What both solutions have in common is wrong by their largest difference, of the scales of surface displacements and, where
/// pressures are larger than those, of the sheet's answer to them.
std::vector<InnerDisplacements> ConvergedElasticNip::inner_displacements(
    std::span<const InnerPoint> points) const {
  const Implementation& nip = *implementation_;
  const WorkingDigits working(nip.working_digits());
  const Float pressed = nip.middle_pressure() * std::min(Float(1), nip.size());
  const Float uncertain =
      (nip.solved.difference() + pow(Float(10), -nip.solved.digits() - 2)) * std::max(nip.square(), pressed);
  return displacements_inside(nip.field(), nip.units, points, uncertain);
}

GreatestShear ConvergedElasticNip::greatest_shear() const {
  const WorkingDigits working(implementation_->working_digits());
  const NipUnits& units = implementation_->units;
  return implementation_->field().greatest(true, to_float(Exact(units.pressure)),
                                           to_float(Exact(units.length)));
}

int ConvergedElasticNip::unknowns() const { return implementation_->fine().unknowns(); }
long ConvergedElasticNip::normal_values() const { return implementation_->solved.kernels().normal_values(); }
long ConvergedElasticNip::coupling_values() const {
  return implementation_->solved.kernels().coupling_values();
}
long ConvergedElasticNip::stretch_values() const {
  return implementation_->solved.kernels().stretch_values();
}

namespace {

void check_elastic_length(const data::ElasticNip& nip, double contact_length, int digits) {
  nip.check();
  check_elastic_digits(digits);
  if (!elastic_length_is_allowed(nip, contact_length))
    throw BadInput("contact_length", contact_length, allowed_elastic_lengths);
}

Float half_length_of(const data::ElasticNip& nip, double contact_length) {
  return to_float(Exact(exactly(contact_length) / exactly(nip.sheet_thickness)));
}

}  // namespace

int elastic_unknowns(const data::ElasticNip& nip, data::Friction friction, double contact_length,
                     int digits) {
  check_elastic_length(nip, contact_length, digits);
  const WorkingDigits working(SolvedElasticNip::working_digits(digits, 0));
  return SolvedElasticNip::first_unknowns(ElasticModel(NipUnits(nip), friction),
                                          half_length_of(nip, contact_length), digits);
}

ConvergedElasticNip converged_for_length(const data::ElasticNip& nip, data::Friction friction,
                                         double contact_length, int digits) {
  check_elastic_length(nip, contact_length, digits);
  const WorkingDigits working(SolvedElasticNip::working_digits(digits, 0));
  const NipUnits units(nip);
  return ConvergedElasticNip(std::make_unique<ConvergedElasticNip::Implementation>(
      units, contact_length,
      SolvedElasticNip::of_half_length(ElasticModel(units, friction), half_length_of(nip, contact_length),
                                       digits)));
}

ConvergedElasticNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                       int digits) {
  nip.check();
  check_elastic_digits(digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const auto refuse = [&] {
    throw BadInput("load", load, std::string("gives a contact whose length ") + allowed_elastic_lengths);
  };
  const NipUnits units(nip);
  const Exact wanted(exactly(load) / (units.pressure * units.length));
  const double most = std::min(longest_elastic, nip.roller_radius / nip.sheet_thickness);
  const double guess =
      std::clamp(guessed_half_length(wanted.approximate()), 0.5 * shortest_elastic, 2 * most);
  const auto check = [&](double half_length) {
    if (!(half_length > 0.1 * shortest_elastic && half_length < 8 * most)) refuse();
  };
  const WorkingDigits working(SolvedElasticNip::working_digits(digits, 0));
  auto solved =
      SolvedElasticNip::of_load(ElasticModel(units, friction), to_float(wanted), guess, digits, check);
  const auto length = static_cast<double>(solved.fine().half_length()) * nip.sheet_thickness;
  if (!elastic_length_is_allowed(nip, length)) refuse();
  return ConvergedElasticNip(
      std::make_unique<ConvergedElasticNip::Implementation>(units, std::nullopt, std::move(solved)));
}

}  // namespace nipref::ref
