#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/fast/partial_slip/internal/element_contact.hpp>
#include <nipref/fast/partial_slip/internal/find_zones.hpp>

namespace nipref::fast {
namespace {

using Zones = std::vector<Zone>;

/// A zone is taken out; its neighbours, or the only one, take its length.
void remove(Zones& zones, std::size_t number) {
  const double length = zones[number].length;
  const bool has_left = number > 0, has_right = number + 1 < zones.size();
  if (has_left && has_right && zones[number - 1].sign == zones[number + 1].sign) {
    zones[number - 1].length += length + zones[number + 1].length;
    zones.erase(zones.begin() + static_cast<long>(number), zones.begin() + static_cast<long>(number) + 2);
    return;
  }
  if (has_left) zones[number - 1].length += length / (has_right ? 2 : 1);
  if (has_right) zones[number + 1].length += length / (has_left ? 2 : 1);
  zones.erase(zones.begin() + static_cast<long>(number));
}

/// Between two opposite slips it sticks.
void separate_slips(Zones& zones) {
  for (std::size_t k = 1; k < zones.size(); ++k) {
    if (zones[k].sign * zones[k - 1].sign >= 0) continue;
    const double length = std::min(zones[k].length, zones[k - 1].length) / 20;
    zones[k].length -= length / 2;
    zones[k - 1].length -= length / 2;
    zones.insert(zones.begin() + static_cast<long>(k), {length, 0});
  }
}

/// At the trailing end it slips: sticking there asks for one number more than there is. But where it sticks everywhere, the
/// traction is 0.
void slip_at_end(const PartialSlipTask& task, Zones& zones, int sign) {
  if (zones.back().sign != 0 || (zones.size() == 1 && task.traction == 0.0)) return;
  constexpr double part = 0.01;
  zones.push_back({part * zones.back().length, sign});
  zones[zones.size() - 2].length *= 1 - part;
}

Zones first_zones(const PartialSlipTask& task, const ElementContact& elements) {
  Zones zones = elements.zones();
  // The first element slips in this scheme even where the sheet sticks from the end on.
  if (zones.size() > 1 && zones.front().sign != 0 && zones.front().length < 1.5 * elements.width)
    remove(zones, 0);
  if (zones.size() > 1 && zones.back().sign == 0 && zones.back().length < 2.5 * elements.width)
    remove(zones, zones.size() - 1);
  const auto last = std::find_if(elements.elements.rbegin(), elements.elements.rend(),
                                 [](const auto& element) { return element.presses; });
  slip_at_end(task, zones, last->shear < 0 ? -1 : 1);
  separate_slips(zones);
  return zones;
}

struct Part {
  double from, to;  ///< e
  int sign;         ///< that its zone should have
};

/// How far a place is from what it should be: the shear beyond friction where it sticks, over friction, and slip along the
/// shear over the largest slip.
class Excess {
 public:
  Excess(const std::vector<ZoneContact::Sample>& samples, double friction) : friction_(friction) {
    for (const auto& sample : samples)
      if (sample.sign != 0) largest_slip_ = std::max(largest_slip_, std::fabs(sample.slip));
  }
  [[nodiscard]] double operator()(const ZoneContact::Sample& sample) const {
    const double excess = sample.sign == 0
                              ? std::fabs(sample.shear) / (friction_ * std::fabs(sample.pressure)) - 1
                              : sample.slip * sample.sign / largest_slip_;
    return std::max(0.0, excess);
  }

 private:
  double friction_, largest_slip_ = 0;
};

/// The parts where a contact is not what it should be, but for what its accuracy leaves.
std::vector<Part> wrong_parts(const ZoneContact& contact, double friction, double nats) {
  const double tolerance = std::exp(-0.6 * nats);
  const std::vector<ZoneContact::Sample>& samples = contact.samples();
  const Excess excess(samples, friction);
  std::vector<Part> parts;
  bool goes_on = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    const bool begins = i == 0 || samples[i - 1].zone != sample.zone;
    const bool ends = i + 1 == samples.size() || samples[i + 1].zone != sample.zone;
    const bool is_wrong = excess(sample) > tolerance;
    const int sign = sample.sign != 0 ? 0 : sample.shear > 0 ? 1 : -1;
    if (is_wrong) {
      if (!goes_on || begins || parts.back().sign != sign)
        parts.push_back({begins ? sample.e : samples[i - 1].e, 0, sign});
      parts.back().to = ends ? sample.e : samples[i + 1].e;
    }
    goes_on = is_wrong;
  }
  // Those much shorter than others may go with them.
  double longest = 0;
  for (const Part& part : parts) longest = std::max(longest, part.to - part.from);
  std::erase_if(parts, [&](const Part& part) { return part.to - part.from < 0.01 * longest; });
  return parts;
}

/// The zones with that part as a zone of its own.
Zones with(const Zones& zones, const Part& part) {
  Zones result;
  double start = 0;
  const auto add = [&](double length, int sign) {
    if (!(length > 0)) return;
    if (!result.empty() && result.back().sign == sign)
      result.back().length += length;
    else
      result.push_back({length, sign});
  };
  for (const Zone& zone : zones) {
    const double end = start + zone.length;
    const double from = std::clamp(part.from, start, end), to = std::clamp(part.to, start, end);
    // A part that begins or ends with the zone has no midpoint there.
    const double margin = 0.05 * zone.length;
    const bool is_first = from - start < margin, is_last = end - to < margin;
    if (to > from) {
      add(is_first ? 0 : from - start, zone.sign);
      add((is_last ? end : to) - (is_first ? start : from), part.sign);
      add(is_last ? 0 : end - to, zone.sign);
    } else {
      add(zone.length, zone.sign);
    }
    start = end;
  }
  return result;
}

/// The zones with all those parts. Where the slip at the trailing end has the wrong sign up to the end, it turns around.
Zones mended(Zones zones, const std::vector<Part>& parts, const PartialSlipTask& task) {
  const double last = zones.back().length;
  const int sign = zones.back().sign;
  const double length = length_of(zones);
  const bool turns = sign != 0 && parts.back().sign == 0 && parts.back().to > length - 1e-3 * last;
  for (const Part& part : parts)
    if (!turns || part.from < length - last) zones = with(zones, part);
  if (turns) {
    const double sticks = std::min(0.2 * last, length - parts.back().from), slips = sticks / 2;
    zones.back().length -= sticks + slips;
    zones.insert(zones.end(), {{sticks, 0}, {slips, -sign}});
  }
  slip_at_end(task, zones, parts.back().sign);
  separate_slips(zones);
  return zones;
}

}  // namespace

std::optional<ZoneContact> find_zones(const PartialSlipTask& task, const std::vector<Zone>& nearly,
                                      double nats) {
  constexpr int most_changes = 12;
  Zones zones = nearly;
  for (int change = 0; change < most_changes; ++change) {
    Zones last = zones;
    auto contact = ZoneContact::solved(task, zones, nats, &last);
    if (!contact) {
      const auto smallest = std::ranges::min_element(last, {}, &Zone::length);
      if (last.size() < 2 || smallest->length > 1e-3 * length_of(last)) return std::nullopt;
      remove(last, static_cast<std::size_t>(smallest - last.begin()));
      separate_slips(last);
      zones = std::move(last);
      continue;
    }
    const std::vector<Part> parts = wrong_parts(*contact, task.friction, nats);
    if (parts.empty()) return contact;
    zones = mended(contact->zones(), parts, task);
  }
  return std::nullopt;
}

std::optional<ZoneContact> find_zones(const PartialSlipTask& task, double nats) {
  constexpr double rough_nats = 13;
  for (const int elements : {60, 120, 240}) {
    auto contact =
        find_zones(task, first_zones(task, element_contact(task, elements)), std::min(nats, rough_nats));
    if (contact && nats > rough_nats) contact = find_zones(task, contact->zones(), nats);
    if (contact) return contact;
  }
  return std::nullopt;
}

double wrongness(const ZoneContact& contact, double friction) {
  const std::vector<ZoneContact::Sample>& samples = contact.samples();
  const Excess excess(samples, friction);
  double sum = 0;
  for (const auto& sample : samples) sum += sample.weight / contact.length() * excess(sample);
  return sum;
}

}  // namespace nipref::fast
