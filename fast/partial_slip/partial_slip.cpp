#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/partial_slip/internal/find_zones.hpp>
#include <nipref/fast/partial_slip/internal/solutions.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>

namespace nipref::fast {
namespace {

using data::BadInput;
using Traction = ZoneContact::Traction;
using Peak = ZoneContact::Peak;

constexpr double longest_contact = 10;  // L/B
/// ln of the first discretisation's error over the second's.
constexpr double nats_apart = 3;
/// Rounding dominates from here on: e^-36.7 is 2^-53.
constexpr double most_nats = 36;

Peak largest(const std::vector<Peak>& peaks) { return std::ranges::max(peaks, {}, &Peak::size); }

PartialSlipTask task_of(const data::PartialSlipNip& nip, const ContactUnits& units) {
  const data::ElasticMaterial& material = nip.material;
  PartialSlipTask task{.beta = material.theta2() / material.normal_compliance(),
                       .friction = nip.friction_coefficient};
  // Along the motion, that is along -Y.
  if (const auto* const traction = std::get_if<data::GivenTraction>(&nip.drive))
    task.traction = -traction->force_per_length / units.load;
  else
    task.creep = std::get<data::GivenCreep>(nip.drive).creep_ratio / units.creep;
  return task;
}

void check(const data::PartialSlipNip& nip) {
  nip.check();
  internal::check_positive("friction_coefficient", nip.friction_coefficient);
  if (const auto* const given = std::get_if<data::GivenTraction>(&nip.drive))
    internal::check_finite("force_per_length", given->force_per_length);
  else
    internal::check_finite("creep_ratio", std::get<data::GivenCreep>(nip.drive).creep_ratio);
}

[[noreturn]] void refuse_drive(const data::PartialSlipNip& nip, double load) {
  const double most = nip.friction_coefficient * load;
  const auto* const given = std::get_if<data::GivenTraction>(&nip.drive);
  if (given != nullptr && !(std::fabs(given->force_per_length) < most))
    throw BadInput(
        "force_per_length", given->force_per_length,
        fmt::format("must be less in size than the friction coefficient times the load, {}", most));
  throw BadInput("friction_coefficient", nip.friction_coefficient,
                 "was met by no zones of stick and slip that were found");
}

std::string too_long(const data::ElasticNip& nip) {
  return fmt::format(
      "must give a contact of at most {:g}, {:g} sheet thicknesses, with a coefficient of friction",
      longest_contact * nip.sheet_thickness, longest_contact);
}

}  // namespace

struct PartialSlipNip::Implementation : Solutions {
  double roller_radius;
  ContactUnits units;
  PartialSlipTask task;

  [[nodiscard]] Estimate estimate(const auto& number, double unit, double scale) const {
    const double value = std::invoke(number, second);
    return times(unit, {value, std::fabs(value - std::invoke(number, first)) + relative * scale +
                                   rounding() * std::max(scale, std::fabs(value))});
  }
  /// The rounding error of a number over its scale. The number is a sum over the n nodes, whose terms are rounded. The
  /// sum of n terms, in any order, has an error of less than n 2^-53 of their sizes (Higham 2002, 4.2).
  [[nodiscard]] double rounding() const {
    return 0x1p-53 * static_cast<double>(second.nodes()) + ZoneEquations::rounding_of_term;
  }
  [[nodiscard]] double length() const { return second.length(); }
  /// A length, with the rounding error that Newton's method leaves in it.
  [[nodiscard]] Estimate of_length(const auto& number, double of_newton) const {
    Estimate result = estimate(number, units.length, length());
    result.error += units.length * of_newton;
    return result;
  }
  [[nodiscard]] Estimate of_displacement(const auto& number) const {
    return estimate(number, units.displacement, std::pow(length(), 2));
  }
  /// The size of strains, which grow with the load and friction in long contacts.
  [[nodiscard]] double strains() const {
    double largest = length();
    for (const ZoneContact::Sample& sample : second.samples())
      largest = std::max(largest, std::fabs(sample.slip + second.creep()));
    return largest;
  }
  /// A strain. Almost full slip makes the creep sensitive to the rounding of load and traction.
  [[nodiscard]] Estimate of_strain(const auto& number) const {
    Estimate strain = estimate(number, units.creep, strains());
    strain.error += units.creep * of_rounding.creep;
    return strain;
  }
  /// A strain at Y, with the effect of the errors of the tractions about Y and of the place.
  [[nodiscard]] Estimate of_strain_at(double y, const auto& function) const {
    Estimate strain = of_strain(at(y, function));
    strain.error += units.creep * (error_by_tractions(place(y)) + by_place(place(y), function));
    return strain;
  }
  /// The effect of the error and the rounding of e on a function, which is like a root next to ends and boundaries.
  [[nodiscard]] double by_place(double e, const auto& function) const {
    const double shift = (relative + rounding()) * length() + of_rounding.leading_length,
                 here = std::invoke(function, second, e);
    double most = 0;
    for (const double place : {e - shift, e + shift})
      most = std::max(most, std::fabs(std::invoke(function, second, place) - here));
    return most;
  }
  [[nodiscard]] double place(double y) const { return second.leading_length() - y / units.length; }
  /// A function of e as a function of the contact, at Y.
  [[nodiscard]] auto at(double y, const auto& function) const {
    internal::check_finite("y", y);
    return [this, y, function](const ZoneContact& contact) {
      return std::invoke(function, contact, contact.leading_length() - y / units.length);
    };
  }
  struct LocalError {
    Traction difference{0, 0}, wrong{0, 0};
    [[nodiscard]] Traction traction() const {
      return {difference.pressure + wrong.pressure, difference.shear + wrong.shear};
    }
  };
  /// The largest errors at the samples next to e, because the error at one sample may be 0 by chance. What oscillates
  /// with the nodes of both meshes has beats of nats/nats_apart samples, of which 8 on each side hold at least one.
  [[nodiscard]] LocalError error_near(double e) const {
    constexpr long beside = 8;
    if (!(e >= 0 && e <= length())) return {};
    const auto& samples = second.samples();
    const auto next = std::ranges::lower_bound(samples, e, {}, &ZoneContact::Sample::e) - samples.begin();
    LocalError largest;
    const auto widen = [](Traction& error, const Traction& more) {
      error = {std::max(error.pressure, more.pressure), std::max(error.shear, more.shear)};
    };
    for (long i = std::max(0L, next - beside); i < std::min(std::ssize(samples), next + beside); ++i) {
      widen(largest.difference, of_tractions[static_cast<std::size_t>(i)]);
      widen(largest.wrong, wrong_tractions[static_cast<std::size_t>(i)]);
    }
    return largest;
  }
  /// The error of a number whose derivatives by the tractions about e are 1. In zones of stick only violations count.
  [[nodiscard]] double error_by_tractions(double e) const {
    const LocalError error = error_near(e);
    const bool slips = e > 0 && e < length() && second.sign(e) != 0;
    return error.wrong.pressure + error.wrong.shear +
           (slips ? error.difference.pressure + error.difference.shear : 0);
  }
  [[nodiscard]] Estimate traction(double y, double Traction::*part, double unit) const {
    const auto at_place = [part](const ZoneContact& contact, double e) { return contact.traction(e).*part; };
    const double value = std::invoke(at(y, at_place), second), before = std::invoke(at(y, at_place), first);
    const double e = place(y), moved = by_place(e, at_place);
    if (value == 0 && before == 0 && moved == 0) return {0, 0};
    return times(unit, {value, std::fabs(value - before) + error_near(e).traction().*part + moved +
                                   error_of_whole(part) + rounding_of_traction(e).*part});
  }
  /// The rounding of the tractions at e, which solve sums over the nodes and are sums themselves. Where the sheet
  /// sticks, a rounding of beta p in the equations changes the shear by as much.
  [[nodiscard]] Traction rounding_of_traction(double e) const {
    const Traction sizes = second.sizes_at(e);
    const bool sticks = e > 0 && e < length() && second.sign(e) == 0;
    return {rounding() * sizes.pressure,
            rounding() * sizes.shear +
                (sticks ? ZoneEquations::rounding_of_term * task.beta * sizes.pressure : 0)};
  }
  /// The relative error of the whole times the mean traction.
  [[nodiscard]] double error_of_whole(double Traction::*part) const {
    return second.load() / length() * (part == &Traction::shear ? task.friction : 1) * relative;
  }
  [[nodiscard]] Estimate peak_size(double Traction::*part) const {
    return peak_size(part, largest(first.peaks(part)), largest(second.peaks(part)));
  }
  [[nodiscard]] Estimate peak_size(double Traction::*part, const Peak& before, const Peak& peak) const {
    const double whole = std::max(error_of_whole(part), relative * peak.size);
    return times(units.pressure,
                 {peak.size, std::fabs(peak.size - before.size) + error_near(peak.e).traction().*part +
                                 whole + rounding() * peak.size});
  }
  /// The error covers every place where the traction is as large, to twice its error, and its slope may be 0. Nodes are
  /// a step apart in s, so that the slope of the tractions' error between nodes is at most pi/step times the error
  /// (Bernstein's inequality). The error of the whole changes as the tractions do.
  [[nodiscard]] Estimate peak_position(double Traction::*part) const {
    const std::vector<Peak> all = second.peaks(part);
    const Peak before = largest(first.peaks(part)), peak = largest(all);
    const double least = peak.size - 2 * (peak_size(part, before, peak).error / units.pressure);
    const auto may_be_largest = [&](double e) {
      if (!(e > 0 && e < length() && std::fabs(second.traction(e).*part) >= least)) return false;
      const double of_nodes =
          std::numbers::pi / second.step() * (error_near(e).traction().*part + rounding() * peak.size);
      return std::fabs(second.slope(e, part)) <= of_nodes + error_of_whole(part);
    };
    const double place = second.place_of(peak, part);
    double farthest = 0;
    for (const Peak& one : all) {
      if (one.size < least) continue;
      const double there = second.place_of(one, part);
      double beside = 0x1p-50 * length();
      while (beside < length() && (may_be_largest(there - beside) || may_be_largest(there + beside)))
        beside *= 2;
      farthest = std::max(farthest, std::fabs(there - place) + beside);
    }
    const auto there = [&](const ZoneContact& contact) {
      return contact.leading_length() - (&contact == &first ? first.place_of(before, part) : place);
    };
    Estimate position = of_length(there, of_rounding.leading_length + of_rounding.ends.maxCoeff());
    position.error += units.length * farthest;
    return position;
  }
};

PartialSlipNip::PartialSlipNip(std::unique_ptr<Implementation> implementation)
    : nip_(std::move(implementation)) {}
PartialSlipNip::PartialSlipNip(PartialSlipNip&&) noexcept = default;
PartialSlipNip::~PartialSlipNip() = default;

Estimate PartialSlipNip::contact_length() const {
  return nip_->of_length(&ZoneContact::length, nip_->of_rounding.ends.tail(1).value());
}

Estimate PartialSlipNip::leading_length() const {
  return nip_->of_length(&ZoneContact::leading_length, nip_->of_rounding.leading_length);
}

Estimate PartialSlipNip::trailing_length() const {
  return nip_->of_length(
      [](const ZoneContact& contact) { return contact.length() - contact.leading_length(); },
      nip_->of_rounding.leading_length + nip_->of_rounding.ends.tail(1).value());
}

Estimate PartialSlipNip::load() const {
  return nip_->estimate(&ZoneContact::load, nip_->units.load, nip_->second.load());
}

Estimate PartialSlipNip::traction() const {
  return nip_->estimate(&ZoneContact::tangential_load, -nip_->units.load,
                        nip_->task.friction * nip_->second.load());
}

Estimate PartialSlipNip::indentation() const { return nip_->of_displacement(&ZoneContact::approach); }

Estimate PartialSlipNip::leading_displacement() const {
  return nip_->of_displacement([](const ZoneContact& contact) { return contact.displacement(0).normal; });
}

Estimate PartialSlipNip::trailing_displacement() const {
  return nip_->of_displacement(
      [](const ZoneContact& contact) { return contact.displacement(contact.length()).normal; });
}

Estimate PartialSlipNip::creep_ratio() const { return nip_->of_strain(&ZoneContact::creep); }

Estimate PartialSlipNip::rolling_resistance() const {
  return nip_->estimate([](const ZoneContact& contact) { return contact.moment() / contact.load(); },
                        nip_->units.length / nip_->roller_radius, nip_->length());
}

Estimate PartialSlipNip::dissipation() const {
  Estimate lost = nip_->estimate(
      &ZoneContact::dissipation, nip_->units.load * nip_->units.creep,
      nip_->task.friction * nip_->second.load() * std::max(nip_->strains(), std::fabs(nip_->second.creep())));
  // The work of the rollers is equal to the dissipation and is computed in another way.
  const double put_in = nip_->second.creep() * nip_->second.tangential_load() + 2 * nip_->second.moment();
  const double of_creep = std::fabs(nip_->second.tangential_load()) * nip_->of_rounding.creep;
  lost.error +=
      nip_->units.load * nip_->units.creep * (std::fabs(nip_->second.dissipation() - put_in) + of_creep);
  return lost;
}

Estimate PartialSlipNip::peak_pressure() const { return nip_->peak_size(&Traction::pressure); }

Estimate PartialSlipNip::peak_pressure_position() const { return nip_->peak_position(&Traction::pressure); }

Estimate PartialSlipNip::peak_shear() const { return nip_->peak_size(&Traction::shear); }

Estimate PartialSlipNip::peak_shear_position() const { return nip_->peak_position(&Traction::shear); }

std::vector<Estimate> PartialSlipNip::zone_boundaries() const {
  const ZoneContact& contact = nip_->second;
  const std::vector<bool>& lacks_zones = nip_->lacks_zones;
  const std::size_t end = contact.zones().size();
  std::vector<Estimate> all;
  for (std::size_t k = 0; k <= end; ++k) {
    const ZoneEquations::Rounding& rounding = nip_->of_rounding;
    const double of_end = k > 0 ? rounding.ends(static_cast<Eigen::Index>(k) - 1) : 0;
    all.push_back(nip_->of_length([&](const ZoneContact& one) { return boundary(one, k); },
                                  rounding.leading_length + of_end));
    double& error = all.back().error;
    if (k == 0 || k == end) continue;
    if (is_smooth(contact, k)) error += nip_->units.length * nip_->of_boundaries * longer_beside(contact, k);
    // Zones that are left out beside a boundary are at most as long as the shorter zone beside it.
    if (lacks_zones[k - 1] || lacks_zones[k]) error += nip_->units.length * shorter_beside(contact, k);
  }
  return all;
}

std::vector<int> PartialSlipNip::zone_signs() const {
  std::vector<int> signs;
  for (const Zone& zone : nip_->second.zones()) signs.push_back(-zone.sign);
  return signs;
}

Estimate PartialSlipNip::pressure(double y) const {
  return nip_->traction(y, &Traction::pressure, nip_->units.pressure);
}

Estimate PartialSlipNip::shear(double y) const {
  return nip_->traction(y, &Traction::shear, -nip_->units.pressure);
}

Estimate PartialSlipNip::surface_strain(double y) const {
  return nip_->of_strain_at(y, &ZoneContact::strain);
}

Estimate PartialSlipNip::slip(double y) const {
  return nip_->of_strain_at(
      y, [](const ZoneContact& contact, double e) { return contact.strain(e) - contact.creep(); });
}

Estimate PartialSlipNip::normal_displacement(double y) const {
  return nip_->of_displacement(
      nip_->at(y, [](const ZoneContact& contact, double e) { return contact.displacement(e).normal; }));
}

Estimate PartialSlipNip::tangential_displacement(double y) const {
  if (y == 0) return {0, 0};
  const auto relative = [](const ZoneContact& contact, double e) {
    return contact.displacement(contact.leading_length()).along - contact.displacement(e).along;
  };
  const double scale = nip_->strains() * std::max(nip_->length(), std::fabs(y / nip_->units.length));
  Estimate displacement = nip_->estimate(nip_->at(y, relative), nip_->units.displacement, scale);
  displacement.error += nip_->units.displacement * nip_->length() * nip_->of_rounding.creep;
  for (const double place : {nip_->place(0), nip_->place(y)})
    displacement.error += nip_->units.displacement * nip_->length() * nip_->error_by_tractions(place);
  return displacement;
}

bool PartialSlipNip::refine() {
  const double nats = nip_->second.nats();
  if (nats > most_nats) return false;
  auto second = find_zones(nip_->task, nip_->second, nats + nats_apart);
  auto solutions = second
                       ? with_differences(nip_->task, *std::move(second), nats, {nip_->first, nip_->second})
                       : std::nullopt;
  if (!solutions) return false;
  *nip_ = {*std::move(solutions), nip_->roller_radius, nip_->units, nip_->task};
  return true;
}

Work PartialSlipNip::work() const { return *nip_->task.work; }

namespace {

/// The contact whose first discretisation has `nats` or, if zones are missing, more; nothing if zones are not found.
std::optional<Solutions> with_zones(const PartialSlipTask& task, double nats, double accuracy) {
  const double rough = rough_nats(task.friction);
  // The zones are sought with the first contact, if it is accurate enough for that, or with the second.
  const auto found = find_zones(task, nats < rough ? nats + nats_apart : nats);
  if (!found) return std::nullopt;
  std::vector<ZoneContact> known{*found};
  std::optional<Solutions> solutions;
  // While the whole misses its accuracy because zones are missing, better accuracies may show them.
  constexpr int most_accuracies = 3;
  for (int number = 0; number < most_accuracies; ++number, nats += nats_apart) {
    if (solutions && (nats > most_nats || !solutions->lack_zones() || solutions->relative < accuracy)) break;
    auto second = nats < rough ? found : find_zones(task, known.back(), nats + nats_apart);
    if (!second) continue;
    known.push_back(*second);
    if (auto compared = with_differences(task, *std::move(second), nats, known))
      solutions = std::move(compared);
  }
  return solutions;
}

PartialSlipNip partial_slip(const data::PartialSlipNip& nip, const ContactUnits& units,
                            const PartialSlipTask& task, double accuracy) {
  const double least = rough_nats(task.friction) - nats_apart;
  double nats = std::max(std::log(8 / accuracy), least);
  auto solutions = with_zones(task, nats, accuracy);
  // Where rounding hides zones at the contact's ends, fewer unknowns may show them.
  while (!solutions && nats > least) {
    nats = std::max(nats - 2 * nats_apart, least);
    solutions = with_zones(task, nats, accuracy);
  }
  if (!solutions) refuse_drive(nip, units.load * (task.load ? *task.load : load_guess(*task.length / 2)));
  return PartialSlipNip(std::make_unique<PartialSlipNip::Implementation>(
      PartialSlipNip::Implementation{*std::move(solutions), nip.roller_radius, units, task}));
}

NipShape shape_of(const data::ElasticNip& nip) { return {nip.roller_radius, nip.sheet_thickness}; }

}  // namespace

ContactUnits units_of(const data::ElasticNip& nip) {
  return {shape_of(nip), nip.material.normal_compliance()};
}

PartialSlipTask task_for_load(const data::PartialSlipNip& nip, double load) {
  check(nip);
  internal::check_positive("load", load);
  const ContactUnits units = units_of(nip);
  PartialSlipTask task = task_of(nip, units);
  task.load = load / units.load;
  // The contact without friction is about as long.
  const double length = 2 * half_length_guess(*task.load) * units.length;
  if (!(length <= longest_contact * nip.sheet_thickness)) throw BadInput("load", load, too_long(nip));
  check_length_of_load(shape_of(nip), load, length);
  if (task.traction && !(std::fabs(*task.traction) < task.friction * *task.load)) refuse_drive(nip, load);
  return task;
}

PartialSlipNip partial_slip_for_length(const data::PartialSlipNip& nip, double contact_length,
                                       double accuracy) {
  check(nip);
  check_contact_accuracy(accuracy);
  check_contact_length(shape_of(nip), contact_length);
  if (!(contact_length <= longest_contact * nip.sheet_thickness))
    throw BadInput("contact_length", contact_length, too_long(nip));
  const ContactUnits units = units_of(nip);
  PartialSlipTask task = task_of(nip, units);
  task.length = contact_length / units.length;
  return partial_slip(nip, units, task, accuracy);
}

PartialSlipNip partial_slip_for_load(const data::PartialSlipNip& nip, double load, double accuracy) {
  check_contact_accuracy(accuracy);
  return partial_slip(nip, units_of(nip), task_for_load(nip, load), accuracy);
}

}  // namespace nipref::fast
