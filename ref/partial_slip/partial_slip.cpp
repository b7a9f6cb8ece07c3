#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/converged_parts.hpp>
#include <nipref/ref/nip/internal/inner_field.hpp>
#include <nipref/ref/partial_slip/internal/slip_solution.hpp>
#include <nipref/ref/partial_slip/partial_slip.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

/// Limits of L/B.
constexpr double shortest_slip = 1e-8, longest_slip = 10;

NipTask slip_task(const data::PartialSlipNip& nip, int digits) {
  nip.check();
  if (!(std::isfinite(nip.friction_coefficient) && nip.friction_coefficient > 0))
    throw BadInput("friction_coefficient", nip.friction_coefficient, "must be finite and > 0");
  const NipTask task{
      nip.roller_radius, nip.sheet_thickness, "a contact with partial slip", 30, shortest_slip, digits,
      longest_slip};
  task.check_digits();
  return task;
}

}  // namespace

struct PartialSlipNip::Parts {
  using Functional = std::function<Float(const SlipField&)>;
  using FunctionalAt = std::function<Float(const SlipField&, const Float& e)>;

  NipUnits units;
  int digits;
  SheetKernels kernels;
  SlipProblem problem;
  SolvedSlip solved = {};
  Float size = 0, pressed = 0, steep = 0;  ///< length, load, and the scale of strains and slopes
  Float difference = 0;

  /// Sets the problem up without its length or load. It counts q and T along +e, so that their signs change.
  Parts(const data::PartialSlipNip& nip, int the_digits)
      : units(nip.roller_radius, nip.sheet_thickness,
              normal_compliance(Exact(nip.material.young), Exact(nip.material.poisson))),
        digits(the_digits),
        kernels(kernel_digits_of_slip(digits)) {
    problem.beta = to_float(ThetaShares(Exact(nip.material.poisson)).theta2);
    problem.friction = nip.friction_coefficient;
    if (const auto* creep = std::get_if<data::GivenCreep>(&nip.drive))
      problem.creep = to_float(Exact(creep->creep_ratio, "creep_ratio")) / to_float(units.slope);
    else
      problem.shear = -to_float(Exact(given_traction(nip), "force_per_length")) / to_float(units.force);
  }

  static double given_traction(const data::PartialSlipNip& nip) {
    return std::get<data::GivenTraction>(nip.drive).force_per_length;
  }

  /// Solves the contact; `guess` is a guess of its length.
  void solve(const data::PartialSlipNip& nip, double guess) {
    problem.unit = guess;
    const bool is_load_given = !problem.length;
    if (is_load_given && !problem.creep) check_traction(nip, problem.load);
    solved = solved_slip(problem, kernels, plain_zones(problem, kernels, guess), digits);
    if (!solved.fine) {
      if (!is_load_given && !problem.creep) check_traction(nip, load_of_sliding());
      throw BadInput("friction_coefficient", nip.friction_coefficient,
                     "gives zones of stick and slip that are not found on the reference path");
    }
    measure();
  }

  /// A traction that is given must be less than what full sliding transmits.
  void check_traction(const data::PartialSlipNip& nip, const Float& load) const {
    if (!(abs(problem.shear) < problem.friction * load))
      throw BadInput("force_per_length", given_traction(nip),
                     "must be smaller in size than friction_coefficient times load");
  }

  /// The load of a contact of this length in full sliding, 0 if it is not found.
  [[nodiscard]] Float load_of_sliding() {
    const int sign = problem.shear < 0 ? -1 : 1;
    SlipProblem sliding = problem;
    sliding.creep = 1000 * sign * (1 + problem.friction) * *problem.length;
    const SolvedSlip slid = solved_slip(sliding, kernels, {{sign, *problem.length}}, 16);
    return slid.fine ? slid.fine->load() : Float(0);
  }

  void measure() {
    const SlipField &a = *solved.coarse, &b = *solved.fine;
    size = b.length();
    pressed = b.load();
    steep = size + pressed / size;
    const auto count = [&](const Float& apart) { difference = std::max(difference, Float(abs(apart))); };
    count((a.length() - size) / size);
    count((a.leading() - b.leading()) / size);
    count((a.creep() - b.creep()) / size);
    count((a.load() - pressed) / pressed);
    count((a.traction() - b.traction()) / pressed);
    for (GridIndex i = 0; i < b.zones().count(); ++i)
      count((a.zones()[std::min(i, a.zones().count() - 1)].length - b.zones()[i].length) / size);
  }

  [[nodiscard]] const SlipField& fine() const { return *solved.fine; }

  /// The error is twice the difference of both solutions, plus `scale` times their largest relative difference and
  /// times a hundredth of the last digit. The latter is a thousand times the length, over that of the contact, below
  /// which the finer grid leaves out zones.
  [[nodiscard]] Estimate number(const mpq_class& unit, const Float& scale,
                                const Functional& functional) const {
    const WorkingDigits working(working_digits_of_slip(digits));
    const Float value = functional(fine()), apart = abs(functional(*solved.coarse) - value),
                in_unit = to_float(unit);
    return {value * in_unit, (2 * apart + scale * (difference + pow(Float(10), -digits - 2))) * in_unit,
            digits};
  }
  [[nodiscard]] Estimate length(const Functional& of) const { return number(units.length, size, of); }
  [[nodiscard]] Estimate slope(const Functional& of) const { return number(units.slope, steep, of); }
  [[nodiscard]] Estimate displacement(const Functional& of) const {
    return number(units.displacement, size * steep, of);
  }
  [[nodiscard]] Estimate pressure(const Functional& of) const {
    return number(units.pressure, pressed / size, of);
  }
  [[nodiscard]] Estimate force(const Functional& of) const { return number(units.force, pressed, of); }
  [[nodiscard]] Estimate power(const Functional& of) const {
    return number(units.force * units.slope, problem.friction * pressed * steep, of);
  }

  /// A functional of the distance of a place from the leading end.
  [[nodiscard]] Functional at(double y, const FunctionalAt& functional) const {
    if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
    return
        [=, this](const SlipField& of) { return functional(of, of.leading() - y / to_float(units.length)); };
  }
  [[nodiscard]] Functional near(double y, const FunctionalAt& functional) const {
    const WorkingDigits working(working_digits_of_slip(digits));
    if (!std::isfinite(y) || abs(y / to_float(units.length)) > farthest_inside + size)
      throw BadInput("y", y, "must be within 450 sheet thicknesses of the contact on the reference path");
    return at(y, functional);
  }

  [[nodiscard]] Estimate boundary(GridIndex zone) const {
    return length([=](const SlipField& of) -> Float { return of.leading() - of.boundary(zone); });
  }

  /// Tractions and strains are as steep as a root of the distance from a boundary of zones. So their change over the
  /// boundaries' error is added to `result`. This error is more than the length of a zone that is left out, which moves
  /// what begins behind it by at most this length.
  [[nodiscard]] Estimate with_boundaries(Estimate result, const mpq_class& unit, double y,
                                         const FunctionalAt& functional) const {
    const WorkingDigits working(working_digits_of_slip(digits));
    Float known = 0;
    for (GridIndex i = 0; i <= fine().zones().count(); ++i) known = std::max(known, boundary(i).error);
    const Float in_unit = to_float(units.length), e = fine().leading() - y / in_unit,
                here = functional(fine(), e);
    for (const int side : {-1, 1})
      result.error += abs(functional(fine(), e + side * known / in_unit) - here) * to_float(unit);
    return result;
  }
  [[nodiscard]] Estimate traction(double y, const FunctionalAt& functional) const {
    return with_boundaries(pressure(at(y, functional)), units.pressure, y, functional);
  }
  [[nodiscard]] Estimate strain(double y, const FunctionalAt& functional) const {
    return with_boundaries(slope(near(y, functional)), units.slope, y, functional);
  }

  [[nodiscard]] Estimate peak(std::size_t of) const {
    return pressure([of](const SlipField& field) { return field.largest(of).size; });
  }

  /// The places of the same local maximum in both solutions are compared. The error reaches to every other maximum that
  /// is as large within the errors, since it may be the largest.
  [[nodiscard]] Estimate peak_position(std::size_t of) const {
    const Estimate highest = peak(of);
    const WorkingDigits working(working_digits_of_slip(digits));
    const SlipField::Hump largest = fine().largest(of);
    const auto from_largest = [&](const SlipField::Hump& hump) -> Float { return abs(hump.e - largest.e); };
    Estimate place = length([&](const SlipField& field) -> Float {
      return field.leading() - std::ranges::min(field.humps(of), {}, from_largest).e;
    });
    Float reach = 0;
    for (const SlipField::Hump& hump : fine().humps(of))
      if ((largest.size - hump.size) * to_float(units.pressure) <= 2 * highest.error)
        reach = std::max(reach, from_largest(hump));
    place.error += reach * to_float(units.length);
    return place;
  }
};

PartialSlipNip partial_slip_for_length(const data::PartialSlipNip& nip, double contact_length, int digits) {
  const Exact half_length = slip_task(nip, digits).half_length(contact_length);
  const WorkingDigits working(working_digits_of_slip(digits));
  auto parts = std::make_unique<PartialSlipNip::Parts>(nip, digits);
  parts->problem.length = 2 * to_float(half_length);
  parts->solve(nip, static_cast<double>(*parts->problem.length));
  return PartialSlipNip(std::move(parts));
}

PartialSlipNip partial_slip_for_load(const data::PartialSlipNip& nip, double load, int digits) {
  const NipTask task = slip_task(nip, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const WorkingDigits working(working_digits_of_slip(digits));
  auto parts = std::make_unique<PartialSlipNip::Parts>(nip, digits);
  const Float wanted = load / to_float(parts->units.force);
  // The guess is good to a few tens of per cent.
  const double guess = 2 * guessed_half_length(static_cast<double>(wanted), [](double) { return 1; });
  if (!(guess > shortest_slip && guess < 4 * longest_slip)) task.refuse_load(load);
  parts->problem.load = wanted;
  parts->solve(nip, guess);
  if (!task.allows(static_cast<double>(parts->size) * nip.half_thickness())) task.refuse_load(load);
  return PartialSlipNip(std::move(parts));
}

PartialSlipNip::PartialSlipNip(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
PartialSlipNip::PartialSlipNip(PartialSlipNip&&) noexcept = default;
PartialSlipNip::~PartialSlipNip() = default;

using Of = SlipField;

Estimate PartialSlipNip::contact_length() const { return parts_->length(&Of::length); }
Estimate PartialSlipNip::leading_length() const { return parts_->length(&Of::leading); }
Estimate PartialSlipNip::trailing_length() const { return parts_->length(&Of::trailing); }
Estimate PartialSlipNip::load() const { return parts_->force(&Of::load); }
Estimate PartialSlipNip::indentation() const { return parts_->displacement(&Of::indentation); }
Estimate PartialSlipNip::leading_displacement() const {
  return parts_->displacement(&Of::leading_displacement);
}
Estimate PartialSlipNip::trailing_displacement() const {
  return parts_->displacement(&Of::trailing_displacement);
}
Estimate PartialSlipNip::traction() const { return -1 * parts_->force(&Of::traction); }
Estimate PartialSlipNip::creep_ratio() const { return parts_->slope(&Of::creep); }
Estimate PartialSlipNip::rolling_resistance() const { return parts_->slope(&Of::rolling_resistance); }
Estimate PartialSlipNip::dissipation() const { return parts_->power(&Of::dissipation); }
Estimate PartialSlipNip::peak_pressure() const { return parts_->peak(pressure_part); }
Estimate PartialSlipNip::peak_pressure_position() const { return parts_->peak_position(pressure_part); }
Estimate PartialSlipNip::peak_shear() const { return parts_->peak(shear_part); }
Estimate PartialSlipNip::peak_shear_position() const { return parts_->peak_position(shear_part); }
Estimate PartialSlipNip::pressure(double y) const { return parts_->traction(y, &Of::pressure); }
Estimate PartialSlipNip::shear(double y) const { return -1 * parts_->traction(y, &Of::shear); }
Estimate PartialSlipNip::surface_strain(double y) const { return parts_->strain(y, &Of::strain); }
Estimate PartialSlipNip::slip(double y) const { return parts_->strain(y, &Of::slip); }
Estimate PartialSlipNip::normal_displacement(double y) const {
  return parts_->displacement(parts_->near(y, &Of::normal_displacement));
}
Estimate PartialSlipNip::tangential_displacement(double y) const {
  return -1 * parts_->displacement(parts_->near(y, &Of::tangential_displacement));
}

std::vector<Estimate> PartialSlipNip::zone_boundaries() const {
  std::vector<Estimate> boundaries;
  for (GridIndex i = 0; i <= parts_->fine().zones().count(); ++i) boundaries.push_back(parts_->boundary(i));
  return boundaries;
}

std::vector<int> PartialSlipNip::zone_signs() const {
  std::vector<int> signs;
  for (const SlipZone& zone : parts_->fine().zones()) signs.push_back(-zone.sign);
  return signs;
}

int PartialSlipNip::unknowns() const { return static_cast<int>(parts_->fine().contact().sizes().count()); }

}  // namespace nipref::ref
