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
  const NipTask task{nip.roller_radius,
                     nip.sheet_thickness,
                     "a contact with partial slip",
                     30,
                     shortest_slip,
                     digits};
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
  NipUnits units;
  int digits;
  std::unique_ptr<SheetKernels> kernels;
  SolvedSlip solved;
  Float difference = 0;

  using Functional = std::function<Float(const SlipField&)>;

  [[nodiscard]] const SlipField& fine() const { return *solved.fine; }
  [[nodiscard]] Float size() const { return fine().contact().length(); }
  [[nodiscard]] Float mean_pressure() const { return fine().contact().integral(pressure_part) / size(); }
  [[nodiscard]] Float in_length(double y) const { return Float(y) / to_float(Exact(units.length)); }
  /// Of Y, from the leading end.
  [[nodiscard]] static Float behind(const SlipField& of, const Float& y) {
    return of.contact().leading() - y;
  }

  /// What both solutions have in common is as wrong as the largest of their differences; the finer is surer than their
  /// difference, and zones left out count for a hundredth of the last digit.
  [[nodiscard]] Estimate estimated(const mpq_class& unit, const Functional& functional,
                                   const std::function<Float()>& scale) const {
    const WorkingDigits working(working_digits_of_slip(digits));
    const Float value = functional(fine()), apart = abs(functional(*solved.coarse) - value),
                in_unit = to_float(Exact(unit));
    return {value * in_unit,
            (2 * apart + abs(scale()) * (difference + pow(Float(10), -digits - 2))) * in_unit, digits};
  }

  void measure() {
    const SlipContact &a = solved.coarse->contact(), &b = fine().contact();
    const Float &length = b.length(), load = b.integral(pressure_part);
    const auto count = [&](const Float& apart) { difference = std::max(difference, Float(abs(apart))); };
    count((a.length() - length) / length);
    count((a.leading() - b.leading()) / length);
    count((a.creep() - b.creep()) / length);
    count((a.integral(pressure_part) - load) / load);
    count((a.integral(shear_part) - b.integral(shear_part)) / load);
    if (a.zones().count() != b.zones().count()) return;
    for (GridIndex i = 0; i < a.zones().count(); ++i)
      count((a.zones()[i].length - b.zones()[i].length) / length);
  }

  void check_place(double y) const {
    const WorkingDigits working(working_digits_of_slip(digits));
    if (!std::isfinite(y) || abs(in_length(y)) > farthest_slip + size())
      throw BadInput("y", y, "must be within 450 sheet thicknesses of the contact on the reference path");
  }

  [[nodiscard]] Estimate of_length(const Functional& functional) const {
    return estimated(units.length, functional, [this] { return size(); });
  }
  [[nodiscard]] Estimate of_slope(const Functional& functional) const {
    return estimated(units.slope, functional, [this]() -> Float { return size() + mean_pressure(); });
  }
  [[nodiscard]] Estimate of_displacement(const Functional& functional) const {
    return estimated(units.displacement, functional,
                     [this]() -> Float { return size() * (size() + mean_pressure()); });
  }
  [[nodiscard]] Estimate of_pressure(const Functional& functional) const {
    return estimated(units.pressure, functional, [this] { return mean_pressure(); });
  }
  [[nodiscard]] Estimate of_force(const Functional& functional) const {
    return estimated(units.force, functional, [this]() -> Float { return mean_pressure() * size(); });
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
    if (slid.fine) load = slid.fine->contact().integral(pressure_part);
  }
  if (!(abs(problem.shear) < problem.friction * load)) refuse_traction(nip);
}

std::unique_ptr<SlipParts> solved_parts(const data::PartialSlipNip& nip, const NipUnits& units,
                                        SlipProblem problem, double guess, int digits) {
  auto parts = std::make_unique<SlipParts>(
      SlipParts{units, digits, std::make_unique<SheetKernels>(kernel_digits_of_slip(digits)), {}});
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
  if (!is_allowed_length(task, static_cast<double>(parts->size()) * nip.half_thickness())) refuse();
  return PartialSlipNip(std::move(parts));
}

PartialSlipNip::PartialSlipNip(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
PartialSlipNip::PartialSlipNip(PartialSlipNip&&) noexcept = default;
PartialSlipNip::~PartialSlipNip() = default;

Estimate PartialSlipNip::contact_length() const {
  return parts_->of_length([](const SlipField& of) { return of.contact().length(); });
}

Estimate PartialSlipNip::leading_length() const {
  return parts_->of_length([](const SlipField& of) { return of.contact().leading(); });
}

Estimate PartialSlipNip::trailing_length() const {
  return parts_->of_length(
      [](const SlipField& of) -> Float { return of.contact().length() - of.contact().leading(); });
}

Estimate PartialSlipNip::load() const {
  return parts_->of_force([](const SlipField& of) { return of.contact().integral(pressure_part); });
}

Estimate PartialSlipNip::indentation() const {
  return parts_->of_displacement([](const SlipField& of) -> Float {
    const Float& leading = of.contact().leading();
    return of.displacement(0).normal + leading * leading;
  });
}

Estimate PartialSlipNip::leading_displacement() const {
  return parts_->of_displacement([](const SlipField& of) { return of.displacement(0).normal; });
}

Estimate PartialSlipNip::trailing_displacement() const {
  return parts_->of_displacement(
      [](const SlipField& of) { return of.displacement(of.contact().length()).normal; });
}

Estimate PartialSlipNip::traction() const {
  return parts_->of_force([](const SlipField& of) -> Float { return -of.contact().integral(shear_part); });
}

Estimate PartialSlipNip::creep_ratio() const {
  return parts_->of_slope([](const SlipField& of) { return of.contact().creep(); });
}

Estimate PartialSlipNip::rolling_resistance() const {
  return parts_->of_slope(
      [](const SlipField& of) -> Float { return 2 * of.moment() / of.contact().integral(pressure_part); });
}

Estimate PartialSlipNip::dissipation() const {
  return parts_->estimated(
      parts_->units.force * parts_->units.slope, [](const SlipField& of) { return of.dissipation(); },
      [this]() -> Float {
        const Float size = parts_->size(), pressure = parts_->mean_pressure();
        return parts_->fine().contact().problem().friction * pressure * size * (size + pressure);
      });
}

Estimate PartialSlipNip::peak_pressure() const {
  return parts_->of_pressure(
      [](const SlipField& of) { return of.traction(pressure_part, of.place_of_largest(pressure_part)); });
}

Estimate PartialSlipNip::peak_pressure_position() const {
  return parts_->of_length([](const SlipField& of) -> Float {
    return of.contact().leading() - of.place_of_largest(pressure_part);
  });
}

Estimate PartialSlipNip::peak_shear() const {
  return parts_->of_pressure([](const SlipField& of) -> Float {
    return abs(of.traction(shear_part, of.place_of_largest(shear_part)));
  });
}

Estimate PartialSlipNip::peak_shear_position() const {
  return parts_->of_length(
      [](const SlipField& of) -> Float { return of.contact().leading() - of.place_of_largest(shear_part); });
}

Estimate PartialSlipNip::pressure(double y) const {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  return parts_->of_pressure([&](const SlipField& of) {
    return of.traction(pressure_part, SlipParts::behind(of, parts_->in_length(y)));
  });
}

Estimate PartialSlipNip::shear(double y) const {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  return parts_->of_pressure([&](const SlipField& of) -> Float {
    return -of.traction(shear_part, SlipParts::behind(of, parts_->in_length(y)));
  });
}

Estimate PartialSlipNip::surface_strain(double y) const {
  parts_->check_place(y);
  return parts_->of_slope(
      [&](const SlipField& of) { return of.strain(SlipParts::behind(of, parts_->in_length(y))); });
}

Estimate PartialSlipNip::slip(double y) const {
  parts_->check_place(y);
  return parts_->of_slope([&](const SlipField& of) -> Float {
    return of.strain(SlipParts::behind(of, parts_->in_length(y))) - of.contact().creep();
  });
}

Estimate PartialSlipNip::normal_displacement(double y) const {
  parts_->check_place(y);
  return parts_->of_displacement([&](const SlipField& of) {
    return of.displacement(SlipParts::behind(of, parts_->in_length(y))).normal;
  });
}

Estimate PartialSlipNip::tangential_displacement(double y) const {
  parts_->check_place(y);
  return parts_->of_displacement([&](const SlipField& of) -> Float {
    return of.displacement(of.contact().leading()).tangential -
           of.displacement(SlipParts::behind(of, parts_->in_length(y))).tangential;
  });
}

std::vector<Estimate> PartialSlipNip::zone_boundaries() const {
  std::vector<Estimate> boundaries;
  for (GridIndex i = 0; i <= parts_->fine().contact().zones().count(); ++i) {
    boundaries.push_back(parts_->of_length([&](const SlipField& of) -> Float {
      Float place = of.contact().leading();
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

int PartialSlipNip::unknowns() const { return static_cast<int>(parts_->fine().contact().unknowns()); }

}  // namespace nipref::ref
