#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/contact_field.hpp>
#include <nipref/ref/nip/internal/solved_nip.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/number/internal/local_slope.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/internal/proven_rolling.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_solution.hpp>

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
constexpr double most_oscillation = 10;
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

void check_oscillation(const RollingMaterial& material) {
  for (const RollingMemory& term : material.normal) {
    if (is_flow(term)) continue;
    const Float oscillation = term.rate.im / term.rate.re;
    if (oscillation > most_oscillation)
      throw BadInput("nip.material", static_cast<double>(oscillation),
                     "must have imaginary parts of rates at most 10 times the real parts for the reference");
  }
}

/// Of a half length in half-thicknesses.
void check_memories(const RollingMaterial& material, double half_length) {
  for (const RollingMemory& term : material.normal) {
    const double length = 2 * half_length;
    if (is_flow(term)) continue;
    const double shortest = 1 / static_cast<double>(abs(term.rate)),
                 longest = 1 / static_cast<double>(term.rate.re);
    if (shortest < shortest_memory * length || longest > longest_memory * length)
      throw BadInput("nip.material", shortest / length,
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

/// The same exactly.
struct ExactRollingUnits {
  mpq_class length, displacement, pressure, force, lever;

  ExactRollingUnits(const data::ViscoelasticNip& nip, const mpq_class& compliance)
      : length(mpq_class(nip.sheet_thickness) / 2), lever(length / mpq_class(nip.roller_radius)) {
    displacement = length * lever / 2;
    pressure = lever / (2 * compliance);
    force = pressure * length;
  }
};

/// A contact that is proven, with the working precision of its intervals.
struct Proof {
  ExactRollingUnits units;
  ProvenRolling contact;
  int working_digits;
};

/// A guess at the half length that carries a load, a few tens of per cent off at most where memories are long or short:
/// between a half-space and springs, with the compliance that the contact meets.
double guessed_half_length(double load, const std::vector<RollingMemory>& memory) {
  double size = 1;
  for (int i = 0; i < 60; ++i) {
    double softness = 1;
    for (const RollingMemory& term : memory)
      softness += static_cast<double>((term.amplitude / (term.rate + ComplexFloat(1 / size))).re);
    size = std::sqrt(size * std::sqrt(load * softness / (std::numbers::pi + 8 * size / 3)));
  }
  return size;
}

/// The rolling nip for SolvedNip.
class RollingModel {
 public:
  using Solution = RollingSolution;

  explicit RollingModel(RollingMaterial material)
      : sheet_(std::make_shared<const RollingSheet>(std::move(material))) {}

  [[nodiscard]] const RollingSheet& sheet() const { return *sheet_; }
  [[nodiscard]] int lost_digits() const { return sheet_->lost_digits(); }
  [[nodiscard]] Resolution resolution() const { return sheet_->resolution(); }
  [[nodiscard]] int unknowns(const std::vector<TractionPanel>& panels) const {
    int terms = 1;
    for (const TractionPanel& panel : panels) terms += panel.terms;
    return 2 * terms + 2 + 2 * static_cast<int>(sheet_->inverse.size());
  }
  [[nodiscard]] std::unique_ptr<Solution> solved(const Float& half_length, std::vector<TractionPanel> panels,
                                                 double nats, SheetKernels& kernels) const {
    return std::make_unique<Solution>(sheet_, Tractions(half_length, std::move(panels), 0, false, nats), nats,
                                      kernels);
  }

 private:
  std::shared_ptr<const RollingSheet> sheet_;
};

using SolvedRollingNip = SolvedNip<RollingModel>;

/// From the leading end, to all digits: the zero of the pressure's slope between the neighbours of the largest sample.
Float place_of_peak(const RollingSolution& contact) {
  constexpr int samples = 200;
  const Float end = 2 * contact.half_length();
  const auto place = [&](int i) -> Float { return end * (1 - cos(pi() * i / samples)) / 2; };
  int best = 1;
  Float largest = 0;
  for (int i = 1; i < samples; ++i) {
    const Float here = contact.pressure(place(i));
    if (here > largest) largest = here, best = i;
  }
  const auto pressure = [&](const Float& x) { return contact.pressure(x); };
  const auto slope = [&](const Float& x) -> Float {
    return local_slope(pressure, x, std::min({Float(x / 5), Float((end - x) / 5), Float(1)}));
  };
  // Not at the ends themselves, where the slope is infinite.
  const Float near = place(best), low = std::max(place(best - 1), Float(near / 16)),
              high = std::min(place(best + 1), Float(end - (end - near) / 16));
  const auto zero =
      bracketed_root<Float>(slope, low, high, end * std::numeric_limits<Float>::epsilon() * 1e4);
  return zero ? *zero : near;
}

bool is_between_ends(const Interval& cosine) {
  return mpfr_cmp_si(cosine.lower(), -1) > 0 && mpfr_cmp_si(cosine.upper(), 1) < 0;
}
bool is_outside(const Interval& cosine) {
  return mpfr_cmp_si(cosine.upper(), -1) < 0 || mpfr_cmp_si(cosine.lower(), 1) > 0;
}

FieldSource field_source(const RollingSolution& contact) {
  const auto tractions = [&contact](const Float& left, const Float& right) -> FaceTraction {
    return {contact.pressure(right, left), 0};
  };
  return {contact.offset(), contact.half_length(), tractions};
}

}  // namespace

struct ConvergedViscoelasticNip::Implementation {
  RollingUnits units;
  SolvedRollingNip solved;
  std::optional<Proof> proof;
  mutable std::map<const RollingSolution*, Float> at_middle = {};

  [[nodiscard]] const RollingSolution& fine() const { return solved.fine(); }
  [[nodiscard]] const Float& size() const { return fine().half_length(); }
  [[nodiscard]] Float mean_pressure() const { return fine().load() / size(); }
  [[nodiscard]] int working_digits() const {
    return SolvedRollingNip::working_digits(solved.digits(), solved.model().lost_digits());
  }
  /// The estimate of a functional whose scale is its value, or `least` if that is larger; with an error beside it.
  [[nodiscard]] Estimate number(const Float& unit, const SolvedRollingNip::Functional& functional,
                                const Float& least = 0, const Float& beside = 0) const {
    const WorkingDigits working(working_digits());
    const data::WithError<Float> estimate = solved.estimate(functional, least);
    return {unit * estimate.value, unit * (estimate.error + beside), solved.digits()};
  }
  /// What `proven` gives of the proof, in this unit, or `estimated`().
  template <class Proven, class Estimated>
  [[nodiscard]] Estimate number(mpq_class ExactRollingUnits::*unit, const Proven& proven,
                                const Estimated& estimated) const {
    if (!proof) return estimated();
    const WorkingDigits working(proof->working_digits);
    const std::optional<Interval> value = proven(proof->contact);
    if (!value) return estimated();
    return enclosure_of(Interval(Exact(proof->units.*unit), working_bits()) * *value, solved.digits());
  }
  [[nodiscard]] Estimate length(const SolvedRollingNip::Functional& functional) const {
    return number(units.length, functional, size());
  }
  [[nodiscard]] Estimate displacement(const SolvedRollingNip::Functional& functional) const {
    const WorkingDigits working(working_digits());
    return number(units.displacement, functional, size() * size());
  }
  void check_place(double y) const {
    if (!std::isfinite(y) || abs(y / units.length) > farthest_rolling)
      throw BadInput("y", y, "must be within 300 sheet thicknesses of the middle on the reference path");
  }
  [[nodiscard]] ContactField field() const {
    if (size() > longest_inside) {
      throw BadInput("contact_length", static_cast<double>(2 * size() * units.length),
                     "must be at most 10 sheet thicknesses for stresses inside on the reference path");
    }
    const Float scale = mean_pressure();
    return {field_source(solved.coarse()), field_source(fine()), scale, scale * solved.difference(),
            solved.digits()};
  }
  /// Of Y in half-thicknesses, and over the half length from the middle.
  [[nodiscard]] Interval place(double y) const {
    return {Exact(mpq_class(mpq_class(y) / proof->units.length)), working_bits()};
  }
  [[nodiscard]] Interval cosine(const ProvenRolling& of, double y) const {
    return (place(y) - of.offset) / of.half_length;
  }
  /// Of Y, from the leading end.
  [[nodiscard]] Float behind(const RollingSolution& contact, double y) const {
    return contact.half_length() + contact.offset() - y / units.length;
  }
  /// Of where the leading end is.
  [[nodiscard]] Float end_error() const {
    return solved.estimate([&](const RollingSolution& contact) { return behind(contact, 0); }, size()).error;
  }
  /// Of the pressure at x: nothing where the contact surely is not.
  [[nodiscard]] Float pressure_scale(const Float& x) const {
    const Float known = end_error();
    return x > -known && x < 2 * size() + known ? mean_pressure() : Float(0);
  }
  /// What the pressure at x may miss as the ends do: where it is as steep as a square root they count for as much as they
  /// are known.
  [[nodiscard]] Float pressure_by_ends(const Float& x) const {
    const Float known = end_error(), here = fine().pressure(x);
    return abs(fine().pressure(x + known) - here) + abs(fine().pressure(x - known) - here);
  }
  /// v at Y, up to a constant.
  [[nodiscard]] Float tangential(const RollingSolution& contact, double y) const {
    return contact.tangential(behind(contact, y), solved.kernels());
  }
  [[nodiscard]] const Float& tangential_at_middle(const RollingSolution& contact) const {
    const auto [place, is_new] = at_middle.try_emplace(&contact);
    if (is_new) place->second = tangential(contact, 0);
    return place->second;
  }
};

ConvergedViscoelasticNip::ConvergedViscoelasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedViscoelasticNip::ConvergedViscoelasticNip(ConvergedViscoelasticNip&&) noexcept = default;
ConvergedViscoelasticNip::~ConvergedViscoelasticNip() = default;

Estimate ConvergedViscoelasticNip::contact_length() const {
  return implementation_->number(
      &ExactRollingUnits::length,
      [](const ProvenRolling& of) -> std::optional<Interval> { return 2 * of.half_length; },
      [&]() -> Estimate {
        return implementation_->length(
            [](const RollingSolution& of) -> Float { return 2 * of.half_length(); });
      });
}

Estimate ConvergedViscoelasticNip::leading_length() const {
  return implementation_->number(
      &ExactRollingUnits::length,
      [](const ProvenRolling& of) -> std::optional<Interval> { return of.half_length + of.offset; },
      [&]() -> Estimate {
        return implementation_->length(
            [](const RollingSolution& of) -> Float { return of.half_length() + of.offset(); });
      });
}

Estimate ConvergedViscoelasticNip::trailing_length() const {
  return implementation_->number(
      &ExactRollingUnits::length,
      [](const ProvenRolling& of) -> std::optional<Interval> { return of.half_length - of.offset; },
      [&]() -> Estimate {
        return implementation_->length(
            [](const RollingSolution& of) -> Float { return of.half_length() - of.offset(); });
      });
}

Estimate ConvergedViscoelasticNip::load() const {
  return implementation_->number(
      &ExactRollingUnits::force, [](const ProvenRolling& of) -> std::optional<Interval> { return of.load(); },
      [&]() -> Estimate {
        const WorkingDigits working(implementation_->working_digits());
        const RollingUnits& units = implementation_->units;
        return implementation_->number(units.pressure * units.length, std::mem_fn(&RollingSolution::load));
      });
}

Estimate ConvergedViscoelasticNip::indentation() const {
  return implementation_->number(
      &ExactRollingUnits::displacement,
      [](const ProvenRolling& of) -> std::optional<Interval> {
        return of.edge_displacement + square(of.half_length + of.offset);
      },
      [&]() -> Estimate {
        return implementation_->displacement([](const RollingSolution& of) -> Float {
          const Float leading = of.half_length() + of.offset();
          return of.edge_displacement() + leading * leading;
        });
      });
}

Estimate ConvergedViscoelasticNip::leading_displacement() const {
  return implementation_->number(
      &ExactRollingUnits::displacement,
      [](const ProvenRolling& of) -> std::optional<Interval> { return of.edge_displacement; },
      [&]() -> Estimate {
        return implementation_->displacement(std::mem_fn(&RollingSolution::edge_displacement));
      });
}

Estimate ConvergedViscoelasticNip::trailing_displacement() const {
  return implementation_->number(
      &ExactRollingUnits::displacement,
      [](const ProvenRolling& of) -> std::optional<Interval> {
        return of.edge_displacement + 4 * of.offset * of.half_length;
      },
      [&]() -> Estimate {
        return implementation_->displacement([](const RollingSolution& of) -> Float {
          return of.edge_displacement() + 4 * of.offset() * of.half_length();
        });
      });
}

Estimate ConvergedViscoelasticNip::rolling_resistance() const {
  return implementation_->number(
      &ExactRollingUnits::lever,
      [](const ProvenRolling& of) -> std::optional<Interval> { return of.lever(); },
      [&]() -> Estimate {
        return implementation_->number(
            implementation_->units.lever,
            [](const RollingSolution& of) -> Float { return of.offset() + of.moment() / of.load(); },
            implementation_->size());
      });
}

Estimate ConvergedViscoelasticNip::peak_pressure() const {
  return implementation_->number(implementation_->units.pressure,
                                 [](const RollingSolution& of) { return of.pressure(place_of_peak(of)); });
}

Estimate ConvergedViscoelasticNip::peak_pressure_position() const {
  return implementation_->length(
      [](const RollingSolution& of) -> Float { return of.half_length() + of.offset() - place_of_peak(of); });
}

Estimate ConvergedViscoelasticNip::pressure(double y) const {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  return implementation_->number(
      &ExactRollingUnits::pressure,
      [&](const ProvenRolling& of) -> std::optional<Interval> {
        const Interval cosine = implementation_->cosine(of, y);
        if (is_between_ends(cosine)) return of.pressure(cosine);
        return is_outside(cosine) ? std::optional(Interval(working_bits())) : std::nullopt;
      },
      [&]() -> Estimate {
        const WorkingDigits working(implementation_->working_digits());
        const Float x = implementation_->behind(implementation_->fine(), y);
        return implementation_->number(
            implementation_->units.pressure,
            [&](const RollingSolution& of) { return of.pressure(implementation_->behind(of, y)); },
            implementation_->pressure_scale(x), implementation_->pressure_by_ends(x));
      });
}

Estimate ConvergedViscoelasticNip::creep_ratio() const {
  const WorkingDigits working(implementation_->working_digits());
  return implementation_->number(
      implementation_->units.lever / 2,
      [&](const RollingSolution& of) -> Float {
        SheetKernels& kernels = implementation_->solved.kernels();
        const Float length = 2 * of.half_length();
        return (of.tangential(0, kernels) - of.tangential(length, kernels)) / length;
      },
      implementation_->size());
}

Estimate ConvergedViscoelasticNip::tangential_displacement(double y) const {
  const WorkingDigits working(implementation_->working_digits());
  implementation_->check_place(y);
  if (y == 0) return exact_zero(implementation_->solved.digits());
  const Float distance = abs(y / implementation_->units.length);
  return implementation_->number(
      implementation_->units.displacement,
      [&](const RollingSolution& of) -> Float {
        return implementation_->tangential(of, y) - implementation_->tangential_at_middle(of);
      },
      implementation_->size() * std::min(implementation_->size(), distance));
}

Estimate ConvergedViscoelasticNip::surface_strain(double y) const {
  const WorkingDigits working(implementation_->working_digits());
  implementation_->check_place(y);
  const Float x = implementation_->behind(implementation_->fine(), y);
  // It is no surer than the pressure that stretches the surface at once.
  const Float& at_once = implementation_->solved.model().sheet().material.theta2_at_once;
  return implementation_->number(
      implementation_->units.lever / 2,
      [&](const RollingSolution& of) {
        return of.strain(implementation_->behind(of, y), implementation_->solved.kernels());
      },
      implementation_->size() + at_once * implementation_->pressure_scale(x),
      at_once * implementation_->pressure_by_ends(x));
}

Estimate ConvergedViscoelasticNip::normal_displacement(double y) const {
  const WorkingDigits working(implementation_->working_digits());
  implementation_->check_place(y);
  return implementation_->number(
      &ExactRollingUnits::displacement,
      [&](const ProvenRolling& of) -> std::optional<Interval> {
        if (!is_between_ends(implementation_->cosine(of, y))) return std::nullopt;
        return of.edge_displacement + square(of.half_length + of.offset) - square(implementation_->place(y));
      },
      [&]() -> Estimate {
        return implementation_->displacement([&](const RollingSolution& of) {
          return of.normal(implementation_->behind(of, y), implementation_->solved.kernels());
        });
      });
}

std::vector<InnerStresses> ConvergedViscoelasticNip::inner_stresses(
    std::span<const InnerPoint> points) const {
  const WorkingDigits working(implementation_->working_digits());
  const RollingUnits& units = implementation_->units;
  const ContactField field = implementation_->field();
  std::vector<InnerStresses> stresses;
  for (const InnerPoint& point : points)
    stresses.push_back(field.at(checked_point(point, units.length), false, units.pressure));
  return stresses;
}

GreatestShear ConvergedViscoelasticNip::greatest_shear() const {
  const WorkingDigits working(implementation_->working_digits());
  const RollingUnits& units = implementation_->units;
  return implementation_->field().greatest(false, units.pressure, units.length);
}

int ConvergedViscoelasticNip::unknowns() const { return implementation_->fine().unknowns(); }
long ConvergedViscoelasticNip::normal_values() const {
  return implementation_->solved.kernels().normal_values();
}
long ConvergedViscoelasticNip::coupling_values() const {
  return implementation_->solved.kernels().coupling_values();
}

namespace {

int rolling_working_digits(const RollingModel& model, int digits) {
  return SolvedRollingNip::working_digits(digits, model.lost_digits());
}

/// The sheet to more than the results' digits; what memories' parts lose as they cancel they do not lose of it.
RollingMaterial material_to(int digits, const data::ViscoelasticNip& nip) {
  const WorkingDigits working(SolvedRollingNip::working_digits(digits, 0));
  RollingMaterial material = rolling_material(nip);
  check_oscillation(material);
  return material;
}

/// To the working precision, which the sheet itself tells.
RollingModel model_of(const data::ViscoelasticNip& nip, int digits) {
  const RollingMaterial material = material_to(digits, nip);
  const WorkingDigits working(SolvedRollingNip::working_digits(digits, RollingModel(material).lost_digits()));
  return RollingModel(material);
}

/// What may be solved at a given length.
struct RollingOfLength {
  RollingModel model;
  Float half_length;
};

RollingOfLength checked_rolling(const data::ViscoelasticNip& nip, double contact_length, int digits) {
  nip.check();
  check_rolling_digits(digits);
  if (!rolling_length_is_allowed(nip, contact_length))
    throw BadInput("contact_length", contact_length, allowed_rolling_lengths);
  RollingModel model = model_of(nip, digits);
  const WorkingDigits working(rolling_working_digits(model, digits));
  Float half_length = Float(contact_length) / nip.sheet_thickness;
  check_memories(model.sheet().material, static_cast<double>(half_length));
  return {std::move(model), std::move(half_length)};
}

/// contact_at(units, memories) with the working precision that it takes; nothing where the proof does not reach.
template <class ContactAt>
std::optional<Proof> proof_of(const data::ViscoelasticNip& nip, double half_length, int digits,
                              const ContactAt& contact_at) {
  constexpr double longest_proven = 4;
  const std::optional<ProvenMemories> memories = proven_memories(nip);
  if (!memories || half_length > longest_proven) return std::nullopt;
  const int working_digits = proven_rolling_working_digits(*memories, half_length, digits);
  const WorkingDigits working(working_digits);
  const ExactRollingUnits units(nip, memories->at_once);
  std::optional<ProvenRolling> contact = contact_at(units, *memories);
  if (!contact || !contact->is_good_to(digits)) return std::nullopt;
  return Proof{units, *std::move(contact), working_digits};
}

}  // namespace

int rolling_unknowns(const data::ViscoelasticNip& nip, double contact_length, int digits) {
  const auto [model, half_length] = checked_rolling(nip, contact_length, digits);
  return SolvedRollingNip::first_unknowns(model, half_length, digits);
}

ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length,
                                              int digits) {
  const auto [model, half_length] = checked_rolling(nip, contact_length, digits);
  const WorkingDigits working(rolling_working_digits(model, digits));
  const Exact exact_half_length{mpq_class(mpq_class(contact_length) / mpq_class(nip.sheet_thickness))};
  auto proof =
      proof_of(nip, exact_half_length.approximate(), digits,
               [&](const ExactRollingUnits&, const ProvenMemories& memories) {
                 return proven_rolling(memories, Interval(exact_half_length, working_bits()), digits);
               });
  return ConvergedViscoelasticNip(std::make_unique<ConvergedViscoelasticNip::Implementation>(
      RollingUnits(nip, model.sheet().material), SolvedRollingNip::of_half_length(model, half_length, digits),
      std::move(proof)));
}

ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip& nip, double load, int digits) {
  nip.check();
  check_rolling_digits(digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const RollingModel model = model_of(nip, digits);
  const WorkingDigits working(rolling_working_digits(model, digits));
  const RollingUnits units(nip, model.sheet().material);
  const auto check = [&](double half_length) {
    if (!rolling_length_is_allowed(nip, half_length * nip.sheet_thickness))
      throw BadInput("load", load, std::string("gives a contact whose length ") + allowed_rolling_lengths);
    check_memories(model.sheet().material, half_length);
  };
  const Float wanted = load / (units.pressure * units.length);
  const double guess = guessed_half_length(static_cast<double>(wanted), model.sheet().material.normal);
  SolvedRollingNip solved = SolvedRollingNip::of_load(model, wanted, guess, digits, check);
  const RollingSolution& fine = solved.fine();
  auto proof =
      proof_of(nip, static_cast<double>(fine.half_length()), digits,
               [&](const ExactRollingUnits& exact, const ProvenMemories& memories) {
                 const Exact exact_load{mpq_class(mpq_class(load) / exact.force)};
                 return proven_rolling_for_load(
                     memories, exact_load, at_working_precision(fine.half_length()), fine.growth(), digits);
               });
  return ConvergedViscoelasticNip(
      std::make_unique<ConvergedViscoelasticNip::Implementation>(units, std::move(solved), std::move(proof)));
}

}  // namespace nipref::ref
