#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/partial_slip/internal/element_contact.hpp>
#include <nipref/fast/partial_slip/internal/find_zones.hpp>
#include <nipref/fast/partial_slip/internal/peak.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>

namespace nipref::fast {
namespace {

using data::BadInput;
using Traction = ZoneContact::Traction;

constexpr double longest_contact = 10;  // L/B
/// The natural logarithm of how much smaller the second discretisation's error is.
constexpr double nats_apart = 3;

/// What two contacts differ by as a whole: relative, with what is wrong in the second one, and of tractions at most, at
/// corresponding places of their zones.
struct Differences {
  double relative = 0, pressure = 0, shear = 0;
};

Differences differences(const ZoneContact& first, const ZoneContact& second, const PartialSlipTask& task) {
  const double length = second.length(), load = second.load();
  Differences found{wrongness(second, task.friction)};
  const auto add = [&](double difference, double scale) {
    found.relative = std::max(found.relative, std::fabs(difference) / scale);
  };
  add(second.length() - first.length(), length);
  add(second.leading_length() - first.leading_length(), length);
  add(load - first.load(), load);
  add(second.tangential_load() - first.tangential_load(), task.friction * load);
  add(second.creep() - first.creep(), std::max(length, std::fabs(second.creep())));
  for (const ZoneContact::Sample& sample : second.samples()) {
    double e = sample.e, start = 0;
    for (int z = 0; z < sample.zone; ++z) {
      e -= second.zones()[static_cast<std::size_t>(z)].length;
      start += first.zones()[static_cast<std::size_t>(z)].length;
    }
    const auto zone = static_cast<std::size_t>(sample.zone);
    const Traction before =
        first.traction(start + e * first.zones()[zone].length / second.zones()[zone].length);
    found.pressure = std::max(found.pressure, std::fabs(sample.pressure - before.pressure));
    found.shear = std::max(found.shear, std::fabs(sample.shear - before.shear));
  }
  return found;
}

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
  if (!(nip.friction_coefficient > 0 && std::isfinite(nip.friction_coefficient)))
    throw BadInput("friction_coefficient", nip.friction_coefficient, "must be finite and > 0");
  if (const auto* const given = std::get_if<data::GivenTraction>(&nip.drive); given != nullptr) {
    if (!std::isfinite(given->force_per_length))
      throw BadInput("force_per_length", given->force_per_length, "must be finite");
  } else if (const double creep = std::get<data::GivenCreep>(nip.drive).creep_ratio; !std::isfinite(creep)) {
    throw BadInput("creep_ratio", creep, "must be finite");
  }
}

[[noreturn]] void refuse_drive(const data::PartialSlipNip& nip, double load) {
  const double most = nip.friction_coefficient * load;
  const auto* const given = std::get_if<data::GivenTraction>(&nip.drive);
  if (given != nullptr && !(std::fabs(given->force_per_length) < most))
    throw BadInput(
        "force_per_length", given->force_per_length,
        fmt::format("must be less in size than the friction coefficient times the load, {:g}", most));
  throw BadInput("friction_coefficient", nip.friction_coefficient,
                 "was met by no zones of stick and slip that were found");
}

std::string too_long(const data::ElasticNip& nip) {
  return fmt::format(
      "must give a contact of at most {:g}, {:g} sheet thicknesses, with a coefficient of friction",
      longest_contact * nip.sheet_thickness, longest_contact);
}

}  // namespace

struct PartialSlipNip::Implementation {
  double roller_radius;
  ContactUnits units;
  PartialSlipTask task;
  double nats;  ///< of the first
  ZoneContact first, second;
  Differences apart;

  [[nodiscard]] Estimate estimate(const auto& number, double unit, double scale) const {
    const double value = std::invoke(number, second);
    // A number is a sum over the nodes, each of which rounds.
    const double rounding = 0x1p-53 * static_cast<double>(second.unknowns());
    return times(
        unit, {value, std::fabs(value - std::invoke(number, first)) + (apart.relative + rounding) * scale});
  }
  [[nodiscard]] double length() const { return second.length(); }
  /// Its value at Y, of a function of e.
  [[nodiscard]] auto at(double y, const auto& function) const {
    check_position(y);
    return [this, y, function](const ZoneContact& contact) {
      return function(contact, contact.leading_length() - y / units.length);
    };
  }
  [[nodiscard]] Estimate traction(double y, double Traction::*part, double unit, double largest) const {
    const auto number =
        at(y, [part](const ZoneContact& contact, double e) { return contact.traction(e).*part; });
    const double value = std::invoke(number, second), before = std::invoke(number, first);
    if (value == 0 && before == 0) return {0, 0};
    // What rounding of the place does: next to ends and boundaries tractions are like roots.
    const double e = second.leading_length() - y / units.length, shift = 0x1p-51 * length();
    double rounding = 0;
    for (const double place : {e - shift, e + shift})
      rounding = std::max(rounding, std::fabs(second.traction(place).*part - value));
    return times(unit, {value, std::fabs(value - before) + largest + rounding});
  }
  /// Its error reaches to any place whose traction is as large but for twice its error and rounding. Where a traction is
  /// flat it is known to rounding, and its place to the root of that.
  [[nodiscard]] Estimate peak_position(double Traction::*part, double error) const {
    Estimate position = estimate(
        [part](const ZoneContact& contact) { return contact.leading_length() - peak(contact, part).e; },
        units.length, length());
    const Peak largest = peak(second, part);
    double farthest = 0x1p-26 * length();
    const auto count = [&](const Peak& one) {
      if (one.size >= (1 - 0x1p-40) * largest.size - 2 * error)
        farthest = std::max(farthest, std::fabs(one.e - largest.e));
    };
    std::ranges::for_each(peaks(second, part), count);
    for (const ZoneContact::Sample& sample : second.samples())
      count({std::fabs(second.traction(sample.e).*part), sample.e});
    position.error += units.length * farthest;
    return position;
  }
};

PartialSlipNip::PartialSlipNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
PartialSlipNip::PartialSlipNip(PartialSlipNip&&) noexcept = default;
PartialSlipNip::~PartialSlipNip() = default;

Estimate PartialSlipNip::contact_length() const {
  const Implementation& my = *implementation_;
  return my.estimate(&ZoneContact::length, my.units.length, my.length());
}

Estimate PartialSlipNip::leading_length() const {
  const Implementation& my = *implementation_;
  return my.estimate(&ZoneContact::leading_length, my.units.length, my.length());
}

Estimate PartialSlipNip::trailing_length() const {
  const Implementation& my = *implementation_;
  return my.estimate([](const ZoneContact& contact) { return contact.length() - contact.leading_length(); },
                     my.units.length, my.length());
}

Estimate PartialSlipNip::load() const {
  const Implementation& my = *implementation_;
  return my.estimate(&ZoneContact::load, my.units.load, my.second.load());
}

Estimate PartialSlipNip::traction() const {
  const Implementation& my = *implementation_;
  return my.estimate(&ZoneContact::tangential_load, -my.units.load, my.task.friction * my.second.load());
}

Estimate PartialSlipNip::indentation() const {
  const Implementation& my = *implementation_;
  return my.estimate(&ZoneContact::approach, my.units.displacement, std::pow(my.length(), 2));
}

Estimate PartialSlipNip::leading_displacement() const {
  const Implementation& my = *implementation_;
  return my.estimate([](const ZoneContact& contact) { return contact.displacement(0).normal; },
                     my.units.displacement, std::pow(my.length(), 2));
}

Estimate PartialSlipNip::trailing_displacement() const {
  const Implementation& my = *implementation_;
  return my.estimate([](const ZoneContact& contact) { return contact.displacement(contact.length()).normal; },
                     my.units.displacement, std::pow(my.length(), 2));
}

Estimate PartialSlipNip::creep_ratio() const {
  const Implementation& my = *implementation_;
  return my.estimate(&ZoneContact::creep, my.units.creep, my.length());
}

Estimate PartialSlipNip::rolling_resistance() const {
  const Implementation& my = *implementation_;
  return my.estimate([](const ZoneContact& contact) { return contact.moment() / contact.load(); },
                     my.units.length / my.roller_radius, my.length());
}

Estimate PartialSlipNip::dissipation() const {
  const Implementation& my = *implementation_;
  Estimate lost = my.estimate(&ZoneContact::dissipation, my.units.load * my.units.creep,
                              my.task.friction * my.second.load() * my.length());
  // What the rollers put in, which is the same, is computed otherwise.
  const double put_in = my.second.creep() * my.second.tangential_load() + 2 * my.second.moment();
  lost.error += my.units.load * my.units.creep * std::fabs(my.second.dissipation() - put_in);
  return lost;
}

Estimate PartialSlipNip::peak_pressure() const {
  const Implementation& my = *implementation_;
  Estimate size =
      my.estimate([](const ZoneContact& contact) { return peak(contact, &Traction::pressure).size; },
                  my.units.pressure, 0);
  size.error += my.units.pressure * my.apart.pressure;
  return size;
}

Estimate PartialSlipNip::peak_pressure_position() const {
  return implementation_->peak_position(&Traction::pressure, implementation_->apart.pressure);
}

Estimate PartialSlipNip::peak_shear() const {
  const Implementation& my = *implementation_;
  Estimate size = my.estimate([](const ZoneContact& contact) { return peak(contact, &Traction::shear).size; },
                              my.units.pressure, 0);
  size.error += my.units.pressure * my.apart.shear;
  return size;
}

Estimate PartialSlipNip::peak_shear_position() const {
  return implementation_->peak_position(&Traction::shear, implementation_->apart.shear);
}

std::vector<Estimate> PartialSlipNip::zone_boundaries() const {
  const Implementation& my = *implementation_;
  const std::vector<Zone>& zones = my.second.zones();
  // See ZoneMesh::smooth_reach.
  const double reach = ZoneMesh::smooth_reach(my.nats + nats_apart);
  const double of_smooth = std::exp(-reach) + 0x1p-50 * std::exp(reach);
  std::vector<Estimate> all;
  for (std::size_t k = 0; k <= zones.size(); ++k) {
    const auto boundary = [k](const ZoneContact& contact) {
      double e = 0;
      for (std::size_t z = 0; z < k; ++z) e += contact.zones()[z].length;
      return contact.leading_length() - e;
    };
    all.push_back(my.estimate(boundary, my.units.length, my.length()));
    const bool is_inside = k > 0 && k < zones.size();
    if (is_inside && zones[k - 1].sign != 0)
      all.back().error += my.units.length * of_smooth * std::max(zones[k - 1].length, zones[k].length);
  }
  return all;
}

std::vector<int> PartialSlipNip::zone_signs() const {
  std::vector<int> signs;
  for (const Zone& zone : implementation_->second.zones()) signs.push_back(-zone.sign);
  return signs;
}

Estimate PartialSlipNip::pressure(double y) const {
  const Implementation& my = *implementation_;
  return my.traction(y, &Traction::pressure, my.units.pressure, my.apart.pressure);
}

Estimate PartialSlipNip::shear(double y) const {
  const Implementation& my = *implementation_;
  return my.traction(y, &Traction::shear, -my.units.pressure, my.apart.shear);
}

Estimate PartialSlipNip::surface_strain(double y) const {
  const Implementation& my = *implementation_;
  return my.estimate(my.at(y, [](const ZoneContact& contact, double e) { return contact.strain(e); }),
                     my.units.creep, my.length());
}

Estimate PartialSlipNip::slip(double y) const {
  const Implementation& my = *implementation_;
  return my.estimate(
      my.at(y, [](const ZoneContact& contact, double e) { return contact.strain(e) - contact.creep(); }),
      my.units.creep, my.length());
}

Estimate PartialSlipNip::normal_displacement(double y) const {
  const Implementation& my = *implementation_;
  return my.estimate(
      my.at(y, [](const ZoneContact& contact, double e) { return contact.displacement(e).normal; }),
      my.units.displacement, std::pow(my.length(), 2));
}

Estimate PartialSlipNip::tangential_displacement(double y) const {
  const Implementation& my = *implementation_;
  const auto relative = [](const ZoneContact& contact, double e) {
    return contact.displacement(contact.leading_length()).along - contact.displacement(e).along;
  };
  const double scale = my.length() * std::max(my.length(), std::fabs(y / my.units.length));
  return my.estimate(my.at(y, relative), my.units.displacement, scale);
}

bool PartialSlipNip::refine() {
  Implementation& my = *implementation_;
  // Rounding rules from here on.
  constexpr double most_nats = 27;
  if (my.nats + nats_apart > most_nats) return false;
  auto second = find_zones(my.task, my.second.zones(), my.nats + 2 * nats_apart);
  if (!second) return false;
  auto first = ZoneContact::solved(my.task, second->zones(), my.nats + nats_apart);
  if (!first) return false;
  my.nats += nats_apart;
  my.first = *std::move(first);
  my.second = *std::move(second);
  my.apart = differences(my.first, my.second, my.task);
  return true;
}

Work PartialSlipNip::work() const { return *implementation_->task.work; }

namespace {

PartialSlipNip partial_slip(const data::PartialSlipNip& nip, const ContactUnits& units,
                            const PartialSlipTask& task, double accuracy) {
  const double nats = 0.85 * std::log(1 / accuracy);
  // Zones are looked for with the better accuracy.
  auto second = find_zones(task, nats + nats_apart);
  if (!second) refuse_drive(nip, units.load * (task.load ? *task.load : load_guess(*task.length)));
  auto first = ZoneContact::solved(task, second->zones(), nats);
  if (!first) refuse_drive(nip, units.load * second->load());
  const Differences apart = differences(*first, *second, task);
  return PartialSlipNip(std::make_unique<PartialSlipNip::Implementation>(PartialSlipNip::Implementation{
      nip.roller_radius, units, task, nats, *std::move(first), *std::move(second), apart}));
}

NipShape shape_of(const data::ElasticNip& nip) { return {nip.roller_radius, nip.sheet_thickness}; }

}  // namespace

ContactUnits units_of(const data::ElasticNip& nip) {
  return {shape_of(nip), nip.material.normal_compliance()};
}

PartialSlipTask task_for_load(const data::PartialSlipNip& nip, double load) {
  check(nip);
  check_contact_load(load);
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
