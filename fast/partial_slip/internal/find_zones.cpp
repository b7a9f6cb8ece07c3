#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <nipref/fast/partial_slip/internal/find_zones.hpp>
#include <nipref/fast/partial_slip/internal/plain_zones.hpp>

namespace nipref::fast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The initial length of a new zone over the length from which it is cut.
constexpr double usual_part = 0.2;
/// A contact with a larger mean_excess() lacks more than short zones.
constexpr double too_much_excess = 1e-3;

/// Removes a zone; its neighbours, or its only neighbour, take its length.
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

/// Removes the shortest zone of slip, and a zone of stick that this leaves at the trailing end. Later changes bring
/// back the zones that are needed. Returns false if no zone of slip would be left.
bool leave_out_shortest_slip(Zones& zones) {
  const auto length = [](const Zone& zone) { return zone.sign == 0 ? infinity : zone.length; };
  if (std::ranges::count(zones, 0, &Zone::sign) + 1 >= std::ssize(zones)) return false;
  remove(zones, static_cast<std::size_t>(std::ranges::min_element(zones, {}, length) - zones.begin()));
  if (zones.back().sign == 0) remove(zones, zones.size() - 1);
  return true;
}

/// Inserts a zone of stick between opposite zones of slip; its length is `part` times that of the shorter one.
void separate_slips(Zones& zones, double part) {
  for (std::size_t k = 1; k < zones.size(); ++k) {
    if (zones[k].sign * zones[k - 1].sign >= 0) continue;
    const double length = part * std::min(zones[k].length, zones[k - 1].length);
    zones[k].length -= length / 2;
    zones[k - 1].length -= length / 2;
    zones.insert(zones.begin() + static_cast<long>(k), {length, 0});
  }
}

struct WrongPart {
  double from, to;  ///< e
  int right_sign;   ///< the sign that its zone should have
};

/// The parts where a contact violates its conditions by more than its accuracy explains.
std::vector<WrongPart> wrong_parts(const ZoneContact& contact, double friction) {
  const double tolerance = left_by_accuracy(contact.nats());
  const std::vector<ZoneContact::Sample>& samples = contact.samples();
  const std::vector<double> excess = excesses(contact, friction);
  std::vector<WrongPart> parts;
  bool goes_on = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    const bool begins = i == 0 || samples[i - 1].zone != sample.zone;
    const bool ends = i + 1 == samples.size() || samples[i + 1].zone != sample.zone;
    const bool is_wrong = excess[i] > tolerance;
    const int sign = sample.sign != 0 ? 0 : sample.shear > 0 ? 1 : -1;
    if (is_wrong) {
      if (!goes_on || begins || parts.back().right_sign != sign)
        parts.push_back({begins ? sample.e : samples[i - 1].e, 0, sign});
      parts.back().to = ends ? sample.e : samples[i + 1].e;
    }
    goes_on = is_wrong;
  }
  // Parts that are much shorter than others may disappear with those.
  double longest = 0;
  for (const WrongPart& part : parts) longest = std::max(longest, part.to - part.from);
  std::erase_if(parts, [&](const WrongPart& part) { return part.to - part.from < 0.01 * longest; });
  return parts;
}

/// The zones with the part as a zone of its own.
Zones with_zone_of(const Zones& zones, const WrongPart& part) {
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
    // There is no midpoint at the end of a zone itself, where a part may begin or end.
    const double margin = 0.05 * zone.length;
    const bool is_first = from - start < margin, is_last = end - to < margin;
    if (to > from) {
      add(is_first ? 0 : from - start, zone.sign);
      add((is_last ? end : to) - (is_first ? start : from), part.right_sign);
      add(is_last ? 0 : end - to, zone.sign);
    } else {
      add(zone.length, zone.sign);
    }
    start = end;
  }
  return result;
}

/// Whether the slip in the last zone has the wrong sign up to the trailing end, so that it has to turn around there.
bool turns_at_end(const Zones& zones, const std::vector<WrongPart>& parts) {
  return zones.back().sign != 0 && parts.back().right_sign == 0 &&
         parts.back().to > length_of(zones) - 1e-3 * zones.back().length;
}

/// The length of new zones over the length from which they are cut. If slip turns around at the trailing end, they are
/// cut from the wrong part or from the whole zone.
struct NewZoneSize {
  double part;
  bool in_wrong_part;
};

/// The zones with all these parts as zones of their own.
Zones with_missing_zones(Zones zones, const std::vector<WrongPart>& parts, const PartialSlipTask& task,
                         const NewZoneSize& size) {
  const double last_length = zones.back().length;
  const int sign = zones.back().sign;
  const double length = length_of(zones);
  const bool turns = turns_at_end(zones, parts);
  for (const WrongPart& part : parts)
    if (!turns || part.from < length - last_length) zones = with_zone_of(zones, part);
  if (turns) {
    const double wrong_length = std::min(length - parts.back().from, last_length / 3);
    const double stick_length =
        size.in_wrong_part ? usual_part * wrong_length : std::min(usual_part * last_length, wrong_length);
    const double slip_length =
        size.in_wrong_part ? size.part / usual_part * wrong_length : size.part / 2 * last_length;
    zones.back().length -= stick_length + slip_length;
    zones.insert(zones.end(), {{stick_length, 0}, {slip_length, -sign}});
  }
  if (zones.back().sign == 0 && !sticks_everywhere(task, zones)) slip_at_end(zones, parts.back().right_sign);
  separate_slips(zones, size.part);
  return zones;
}

/// How a contact is solved from zones that are far from right. Few unknowns make Newton's steps fast, but do not
/// resolve zones that only a better accuracy shows; all unknowns take fifty times as long.
enum class Start { few_unknowns, all_unknowns };

double nats_at(Start start, const PartialSlipTask& task, double nats) {
  // With few unknowns the errors of pressures, e^(-0.9 nats), are at most a tenth of the shears.
  return start == Start::few_unknowns ? std::max(11.0, std::log(10 / task.friction) / 0.9) : nats;
}

/// The contact of `nats` with the zones of one that may have fewer.
std::optional<ZoneContact> with_nats(const PartialSlipTask& task, std::optional<ZoneContact> contact,
                                     double nats) {
  if (!contact || contact->nats() == nats) return contact;
  return ZoneContact::solved(task, *contact, nats);
}

/// The contact of least mean_excess() with these parts as zones of their own. Several lengths of new zones are tried,
/// because Newton's method may shrink them to nothing. Nothing if none is found or the zones stay as they are.
std::optional<ZoneContact> best_with_missing_zones(const PartialSlipTask& task, const ZoneContact& contact,
                                                   const std::vector<WrongPart>& parts, Start start) {
  constexpr NewZoneSize sizes[] = {{usual_part, true},      {usual_part, false},    {usual_part / 4, true},
                                   {usual_part / 4, false}, {2 * usual_part, true}, {2 * usual_part, false}};
  const double excess = mean_excess(contact, task.friction);
  std::optional<ZoneContact> best;
  double least_excess = infinity;
  Zones zones;
  for (const NewZoneSize& size : sizes) {
    if (size.in_wrong_part && !turns_at_end(contact.zones(), parts)) continue;
    // Some parts are cut out as they are, whatever the size.
    if (std::exchange(zones, with_missing_zones(contact.zones(), parts, task, size)) == zones) continue;
    if (in_same_order(zones, contact.zones())) return std::nullopt;
    auto found = ZoneContact::solved(task, zones, nats_at(start, task, contact.nats()));
    // If two sizes lead to the same contact, the others do, too.
    if (found && best && found->is_like(*best)) break;
    const double excess_of_found = found ? mean_excess(*found, task.friction) : infinity;
    if (excess_of_found < least_excess) {
      least_excess = excess_of_found;
      best = std::move(found);
    }
    if (least_excess < excess / 10) break;
  }
  return with_nats(task, std::move(best), contact.nats());
}

/// The contact with the shortest zones of slip left out, as many as Newton's method needs to converge.
std::optional<ZoneContact> solved_without_shortest(const PartialSlipTask& task, Zones zones, double nats) {
  while (leave_out_shortest_slip(zones))
    if (auto contact = ZoneContact::solved(task, zones, nats)) return contact;
  return std::nullopt;
}

/// Changes the zones until they meet all conditions as far as the accuracy shows, or until missing zones are not found.
/// mean_excess() measures the violations that are left.
ZoneContact corrected(const PartialSlipTask& task, ZoneContact contact, Start start) {
  constexpr int most_changes = 8;
  for (int change = 0; change < most_changes; ++change) {
    const std::vector<WrongPart> parts = wrong_parts(contact, task.friction);
    if (parts.empty()) break;
    auto next = best_with_missing_zones(task, contact, parts, start);
    if (!next) break;
    contact = *std::move(next);
  }
  return contact;
}

/// The contact of `nats` from zones that elements show, in which short zones may be missing.
std::optional<ZoneContact> found_by_elements(const PartialSlipTask& task, double nats) {
  std::optional<ZoneContact> best;
  double least_excess = infinity;
  // Corrects a contact, keeps it if it is the best so far, and tells whether the best is right.
  const auto is_right = [&](std::optional<ZoneContact> contact, Start start) {
    if (!contact) return false;
    contact = corrected(task, *std::move(contact), start);
    if (const double excess = mean_excess(*contact, task.friction); excess < least_excess) {
      least_excess = excess;
      best = std::move(contact);
    }
    // The mean excess of a contact with the right zones is at most its accuracy.
    return least_excess < std::exp(-nats);
  };
  std::vector<Zones> tried;
  const auto is_found_from = [&](const Zones& zones) {
    if (std::ranges::find(tried, zones) != tried.end()) return false;
    tried.push_back(zones);
    auto contact = ZoneContact::solved(task, zones, nats_at(Start::few_unknowns, task, nats));
    return is_right(with_nats(task, std::move(contact), nats), Start::few_unknowns);
  };
  for (const int elements : {60, 120}) {
    const auto zones = slipping_zones(task, elements);
    if (!zones) break;
    if (is_found_from(*zones)) return best;
  }
  for (const int elements : {60, 120, 240}) {
    auto zones = plain_zones(task, elements);
    if (!zones) continue;
    separate_slips(*zones, usual_part);
    if (is_found_from(*zones)) return best;
  }
  // Elements do not show zones next to the trailing end that are much shorter than they are.
  const Zones sticking{{length_guess(task), 0}};
  if (sticks_everywhere(task, sticking) && is_found_from(sticking)) return best;
  for (const int sign : {-1, 1}) {
    Zones zones = sticking;
    slip_at_end(zones, sign);
    if (is_found_from(zones)) return best;
  }
  std::vector<Zones> not_solved;
  for (const Zones& zones : tried) {
    auto contact = ZoneContact::solved(task, zones, nats);
    if (!contact) not_solved.push_back(zones);
    if (is_right(std::move(contact), Start::all_unknowns)) return best;
  }
  // Some zones with which Newton's method does not converge may have to be left out.
  for (const Zones& zones : not_solved)
    if (is_right(solved_without_shortest(task, zones, nats), Start::all_unknowns)) return best;
  return least_excess <= too_much_excess ? best : std::nullopt;
}

}  // namespace

double rough_nats(double friction) { return std::max(20.0, -1.4 * std::log(friction)); }

std::optional<ZoneContact> find_zones(const PartialSlipTask& task, const ZoneContact& near, double nats) {
  auto contact = ZoneContact::solved(task, near, nats);
  if (!contact || !contact->is_like(near)) contact = solved_without_shortest(task, near.zones(), nats);
  if (!contact) return std::nullopt;
  return corrected(task, corrected(task, *std::move(contact), Start::few_unknowns), Start::all_unknowns);
}

std::optional<ZoneContact> find_zones(const PartialSlipTask& task, double nats) {
  // A better accuracy shows shorter zones. They are found more easily if only few unknowns are added at a time.
  constexpr double stride = 5;
  const double strides = std::floor((nats - rough_nats(task.friction)) / stride);
  auto best = found_by_elements(task, nats - strides * stride);
  if (!best) return std::nullopt;
  for (double left = strides - 1; left > 0; --left) {
    if (mean_excess(*best, task.friction) <= left_by_accuracy(nats)) break;
    if (auto contact = find_zones(task, *best, nats - left * stride)) best = std::move(contact);
  }
  return strides > 0 ? find_zones(task, *best, nats) : best;
}

std::vector<double> excesses(const ZoneContact& contact, double friction) {
  double largest_slip = 0;
  for (const auto& sample : contact.samples())
    if (sample.sign != 0) largest_slip = std::max(largest_slip, std::fabs(sample.slip));
  std::vector<double> all;
  for (const auto& sample : contact.samples()) {
    const double excess =
        sample.sign == 0 ? sample.ratio / friction - 1 : sample.slip * sample.sign / largest_slip;
    all.push_back(std::max(0.0, excess));
  }
  return all;
}

double mean_excess(const ZoneContact& contact, double friction) {
  const std::vector<double> excess = excesses(contact, friction);
  double sum = 0;
  for (std::size_t i = 0; i < excess.size(); ++i)
    sum += contact.samples()[i].weight / contact.length() * excess[i];
  return sum;
}

}  // namespace nipref::fast
