#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/converged_parts.hpp>
#include <nipref/ref/partial_slip/internal/plain_zones.hpp>
#include <nipref/ref/partial_slip/internal/slip_solution.hpp>
#include <nipref/ref/partial_slip/partial_slip.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

/// L/B.
constexpr double shortest_slip = 1e-8, longest_slip = 10;
/// The distance from the contact at which strains and displacements are computed, half-thicknesses.
constexpr double farthest_slip = 900;

NipTask slip_task(const data::PartialSlipNip& nip, int digits) {
  nip.check();
  if (!(std::isfinite(nip.friction_coefficient) && nip.friction_coefficient > 0))
    throw BadInput("friction_coefficient", nip.friction_coefficient, "must be finite and > 0");
  const NipTask task{
      nip.roller_radius, nip.sheet_thickness, "a contact with partial slip", 30, shortest_slip, digits};
  task.check_digits();
  return task;
}

bool is_allowed_length(const NipTask& task, double contact_length) {
  return task.allows(contact_length) && contact_length <= longest_slip * task.sheet_thickness;
}

std::string allowed_lengths() {
  return fmt::format(
      "must be at most the roller's radius and from {:g} to {:g} sheet thicknesses for a contact with partial slip",
      shortest_slip, longest_slip);
}

}  // namespace

struct PartialSlipNip::Parts {
  using Functional = std::function<Float(const SlipField&)>;
  /// Of results: its unit, and what their errors are measured by, without it.
  struct Kind {
    mpq_class unit;
    Float scale;
  };

  NipUnits units;
  int digits;
  std::unique_ptr<SheetKernels> kernels;
  SolvedSlip solved = {};
  Kind length = {}, slope = {}, displacement = {}, pressure = {}, force = {}, power = {};
  Float difference = 0;

  [[nodiscard]] const SlipField& fine() const { return *solved.fine; }
  [[nodiscard]] Float in_length(double y) const { return Float(y) / to_float(Exact(units.length)); }

  /// What both solutions have in common is as wrong as the largest of their differences; the finer is surer than their
  /// difference, and zones left out count for a hundredth of the last digit.
  [[nodiscard]] Estimate number(Kind Parts::*kind, const Functional& functional) const {
    const WorkingDigits working(working_digits_of_slip(digits));
    const auto& [unit, scale] = this->*kind;
    const Float value = functional(fine()), apart = abs(functional(*solved.coarse) - value),
                in_unit = to_float(Exact(unit));
    return {value * in_unit, (2 * apart + scale * (difference + pow(Float(10), -digits - 2))) * in_unit,
            digits};
  }
  /// At a place in or next to the contact, where functionals take its distance from the leading end.
  [[nodiscard]] Estimate number_at(
      double y, Kind Parts::*kind,
      const std::function<Float(const SlipField&, const Float& e)>& functional) const {
    return number(kind, [&](const SlipField& of) { return functional(of, of.leading() - in_length(y)); });
  }

  /// From the solutions.
  void measure() {
    const SlipField &a = *solved.coarse, &b = fine();
    const Float &size = b.length(), load = b.load(), mean = load / size;
    length = {units.length, size};
    slope = {units.slope, size + mean};
    displacement = {units.displacement, size * slope.scale};
    pressure = {units.pressure, mean};
    force = {units.force, load};
    power = {units.force * units.slope, b.contact().problem().friction * load * slope.scale};
    const auto count = [&](const Float& apart) { difference = std::max(difference, Float(abs(apart))); };
    count((a.length() - size) / size);
    count((a.leading() - b.leading()) / size);
    count((a.creep() - b.creep()) / size);
    count((a.load() - load) / load);
    count((a.traction() - b.traction()) / load);
    const auto &zones = a.contact().zones(), &finer = b.contact().zones();
    if (zones.count() != finer.count()) return;
    for (GridIndex i = 0; i < zones.count(); ++i) count((zones[i].length - finer[i].length) / size);
  }

  void check_place(double y) const {
    const WorkingDigits working(working_digits_of_slip(digits));
    if (!std::isfinite(y) || abs(in_length(y)) > farthest_slip + length.scale)
      throw BadInput("y", y, "must be within 450 sheet thicknesses of the contact on the reference path");
  }

  [[nodiscard]] Estimate traction(double y, std::size_t of) const {
    if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
    return number_at(y, &Parts::pressure,
                     [of](const SlipField& field, const Float& e) { return field.tractions(e)[of]; });
  }

  [[nodiscard]] Estimate peak(std::size_t of) const {
    return number(&Parts::pressure, [of](const SlipField& field) { return field.largest(of).size; });
  }

  /// Both solutions' places of the same local maximum are compared. Another one that is as large, within the errors of both, may
  /// be the largest.
  [[nodiscard]] Estimate peak_position(std::size_t of) const {
    const Estimate size = peak(of);
    const WorkingDigits working(working_digits_of_slip(digits));
    const SlipField::Hump largest = fine().largest(of);
    const auto from_largest = [&](const SlipField::Hump& hump) -> Float { return abs(hump.e - largest.e); };
    Estimate place = number(&Parts::length, [&](const SlipField& field) -> Float {
      return field.leading() - std::ranges::min(field.humps(of), {}, from_largest).e;
    });
    Float reach = 0;
    for (const SlipField::Hump& hump : fine().humps(of))
      if ((largest.size - hump.size) * to_float(Exact(units.pressure)) <= 2 * size.error)
        reach = std::max(reach, from_largest(hump));
    place.error += reach * to_float(Exact(units.length));
    return place;
  }
};

namespace {

using SlipParts = PartialSlipNip::Parts;

/// The problem but for what is given: of Y, q and T change their signs.
SlipProblem problem_of(const data::PartialSlipNip& nip, const NipUnits& units) {
  SlipProblem problem;
  const mpq_class poisson = nip.material.poisson;
  problem.beta = to_float(Exact(mpq_class((1 - 2 * poisson) / (2 * (1 - poisson)))));
  problem.friction = nip.friction_coefficient;
  if (const auto* creep = std::get_if<data::GivenCreep>(&nip.drive))
    problem.creep =
        to_float(Exact(mpq_class(mpq_class(Exact(creep->creep_ratio, "creep_ratio").value()) / units.slope)));
  else
    problem.shear = -to_float(Exact(mpq_class(
        Exact(std::get<data::GivenTraction>(nip.drive).force_per_length, "force_per_length").value() /
        units.force)));
  return problem;
}

void refuse_traction(const data::PartialSlipNip& nip) {
  throw BadInput("force_per_length", std::get<data::GivenTraction>(nip.drive).force_per_length,
                 "must be smaller in size than friction_coefficient times load");
}

/// A traction that is given must be less than what full sliding transmits.
void check_traction(const data::PartialSlipNip& nip, const SlipProblem& problem, SheetKernels& kernels,
                    double guess) {
  if (problem.creep) return;
  Float load = problem.load;
  if (problem.length) {
    SlipProblem sliding = problem;
    sliding.creep = Float(problem.shear < 0 ? -1000 : 1000) * (1 + problem.friction) * *problem.length;
    const SolvedSlip slid =
        solved_slip(sliding, kernels, Row<SlipZone>{{problem.shear < 0 ? -1 : 1, Float(guess)}}, 16);
    if (slid.fine) load = slid.fine->load();
  }
  if (!(abs(problem.shear) < problem.friction * load)) refuse_traction(nip);
}

std::unique_ptr<SlipParts> solved_parts(const data::PartialSlipNip& nip, const NipUnits& units,
                                        SlipProblem problem, double guess, int digits) {
  auto parts = std::make_unique<SlipParts>(
      SlipParts{units, digits, std::make_unique<SheetKernels>(kernel_digits_of_slip(digits))});
  problem.unit = guess;
  check_traction(nip, problem, *parts->kernels, guess);
  const Row<SlipZone> zones = plain_zones(problem, *parts->kernels, guess);
  parts->solved = solved_slip(problem, *parts->kernels, zones, digits);
  if (!parts->solved.fine)
    throw BadInput("friction_coefficient", nip.friction_coefficient,
                   "gives zones of stick and slip that are not found on the reference path");
  parts->measure();
  return parts;
}

NipUnits slip_units(const data::ElasticNip& nip) {
  const mpq_class poisson = nip.material.poisson, young = nip.material.young;
  return {nip.roller_radius, nip.sheet_thickness, mpq_class(2 * (1 - poisson) * (1 + poisson) / young)};
}

}  // namespace

PartialSlipNip partial_slip_for_length(const data::PartialSlipNip& nip, double contact_length, int digits) {
  const NipTask task = slip_task(nip, digits);
  if (!is_allowed_length(task, contact_length))
    throw BadInput("contact_length", contact_length, allowed_lengths());
  const WorkingDigits working(working_digits_of_slip(digits));
  const NipUnits units = slip_units(nip);
  SlipProblem problem = problem_of(nip, units);
  problem.length = to_float(Exact(mpq_class(mpq_class(contact_length) / units.length)));
  const auto guess = static_cast<double>(*problem.length);
  return PartialSlipNip(solved_parts(nip, units, std::move(problem), guess, digits));
}

PartialSlipNip partial_slip_for_load(const data::PartialSlipNip& nip, double load, int digits) {
  const NipTask task = slip_task(nip, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const WorkingDigits working(working_digits_of_slip(digits));
  const NipUnits units = slip_units(nip);
  SlipProblem problem = problem_of(nip, units);
  problem.load = to_float(Exact(mpq_class(mpq_class(load) / units.force)));
  // The guess is good to a few tens of per cent.
  const double guess = 2 * guessed_half_length(static_cast<double>(problem.load), [](double) { return 1; });
  const auto refuse = [&] {
    throw BadInput("load", load, "gives a contact whose length " + allowed_lengths());
  };
  if (!(guess > shortest_slip && guess < 4 * longest_slip)) refuse();
  auto parts = solved_parts(nip, units, std::move(problem), guess, digits);
  if (!is_allowed_length(task, static_cast<double>(parts->length.scale) * nip.half_thickness())) refuse();
  return PartialSlipNip(std::move(parts));
}

PartialSlipNip::PartialSlipNip(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
PartialSlipNip::PartialSlipNip(PartialSlipNip&&) noexcept = default;
PartialSlipNip::~PartialSlipNip() = default;

Estimate PartialSlipNip::contact_length() const { return parts_->number(&Parts::length, &SlipField::length); }
Estimate PartialSlipNip::leading_length() const {
  return parts_->number(&Parts::length, &SlipField::leading);
}
Estimate PartialSlipNip::trailing_length() const {
  return parts_->number(&Parts::length, &SlipField::trailing);
}
Estimate PartialSlipNip::load() const { return parts_->number(&Parts::force, &SlipField::load); }
Estimate PartialSlipNip::indentation() const {
  return parts_->number(&Parts::displacement, &SlipField::indentation);
}
Estimate PartialSlipNip::leading_displacement() const {
  return parts_->number(&Parts::displacement, &SlipField::leading_displacement);
}
Estimate PartialSlipNip::trailing_displacement() const {
  return parts_->number(&Parts::displacement, &SlipField::trailing_displacement);
}
Estimate PartialSlipNip::traction() const { return -1 * parts_->number(&Parts::force, &SlipField::traction); }
Estimate PartialSlipNip::creep_ratio() const { return parts_->number(&Parts::slope, &SlipField::creep); }
Estimate PartialSlipNip::rolling_resistance() const {
  return parts_->number(&Parts::slope, &SlipField::rolling_resistance);
}
Estimate PartialSlipNip::dissipation() const {
  return parts_->number(&Parts::power, &SlipField::dissipation);
}

Estimate PartialSlipNip::peak_pressure() const { return parts_->peak(pressure_part); }
Estimate PartialSlipNip::peak_pressure_position() const { return parts_->peak_position(pressure_part); }
Estimate PartialSlipNip::peak_shear() const { return parts_->peak(shear_part); }
Estimate PartialSlipNip::peak_shear_position() const { return parts_->peak_position(shear_part); }

Estimate PartialSlipNip::pressure(double y) const { return parts_->traction(y, pressure_part); }
Estimate PartialSlipNip::shear(double y) const { return -1 * parts_->traction(y, shear_part); }

Estimate PartialSlipNip::surface_strain(double y) const {
  parts_->check_place(y);
  return parts_->number_at(y, &Parts::slope, &SlipField::strain);
}

Estimate PartialSlipNip::slip(double y) const {
  parts_->check_place(y);
  return parts_->number_at(y, &Parts::slope, [](const SlipField& of, const Float& e) -> Float {
    return of.strain(e) - of.creep();
  });
}

Estimate PartialSlipNip::normal_displacement(double y) const {
  parts_->check_place(y);
  return parts_->number_at(y, &Parts::displacement,
                           [](const SlipField& of, const Float& e) { return of.displacement(e).normal; });
}

Estimate PartialSlipNip::tangential_displacement(double y) const {
  parts_->check_place(y);
  return parts_->number_at(y, &Parts::displacement, [](const SlipField& of, const Float& e) -> Float {
    return of.displacement(of.leading()).tangential - of.displacement(e).tangential;
  });
}

std::vector<Estimate> PartialSlipNip::zone_boundaries() const {
  std::vector<Estimate> boundaries;
  for (GridIndex i = 0; i <= parts_->fine().contact().zones().count(); ++i) {
    boundaries.push_back(parts_->number(&Parts::length, [&](const SlipField& of) {
      Float place = of.leading();
      for (GridIndex zone = 0; zone < std::min(i, of.contact().zones().count()); ++zone)
        place -= of.contact().zones()[zone].length;
      return place;
    }));
  }
  return boundaries;
}

std::vector<int> PartialSlipNip::zone_signs() const {
  std::vector<int> signs;
  for (const SlipZone& zone : parts_->fine().contact().zones()) signs.push_back(-zone.sign);
  return signs;
}

int PartialSlipNip::unknowns() const { return static_cast<int>(parts_->fine().contact().sizes().count()); }

}  // namespace nipref::ref
