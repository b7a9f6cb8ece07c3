#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <nipref/fast/partial_slip/internal/find_zones.hpp>
#include <nipref/fast/partial_slip/internal/solutions.hpp>

namespace nipref::fast {
namespace {

/// The largest difference of smooth boundaries, over the longer zone beside.
double boundary_difference(const ZoneContact& coarser, const ZoneContact& contact) {
  double largest = 0;
  for (std::size_t k = 1; k < contact.zones().size(); ++k) {
    if (!is_smooth(contact, k)) continue;
    const double difference = std::fabs(boundary(contact, k) - boundary(coarser, k));
    largest = std::max(largest, difference / longer_beside(contact, k));
  }
  return largest;
}

/// The relative error of other results that the boundaries' errors x cause but differences of these results may not
/// show. A result is f(x) = f + f' x + f'' x^2/2. Its difference shows the first order, because x is at most the
/// difference of the boundaries. But the second order is equal for x and -x. Results change over the length of the
/// shorter zone beside a boundary, by its share of the contact: f'' x^2 is x^2 over the product of these two lengths.
double second_order(const ZoneContact& coarser, const ZoneContact& contact) {
  double largest = 0;
  for (std::size_t k = 1; k < contact.zones().size(); ++k) {
    const double x = boundary(contact, k) - boundary(coarser, k);
    largest = std::max(largest, x * x / (shorter_beside(contact, k) * contact.length()));
  }
  return largest;
}

double relative_difference(const ZoneContact& coarser, const ZoneContact& contact, double friction) {
  const double length = contact.length(), load = contact.load();
  double largest = 0;
  const auto add = [&](const auto& number, double scale) {
    const double difference = std::invoke(number, contact) - std::invoke(number, coarser);
    largest = std::max(largest, std::fabs(difference) / scale);
  };
  add(&ZoneContact::length, length);
  add(&ZoneContact::leading_length, length);
  add(&ZoneContact::load, load);
  add(&ZoneContact::tangential_load, friction * load);
  add(&ZoneContact::creep, std::max(length, std::fabs(contact.creep())));
  return largest;
}

/// Whether other zones belong at each sample: its excess is larger than the accuracy explains, or slip goes along the
/// shear up to an end of the contact, which a small displacement of a boundary cannot explain.
std::vector<bool> left_out(const ZoneContact& contact, const std::vector<double>& excess, double nats) {
  const double tolerance = left_by_accuracy(nats);
  std::vector<bool> result;
  for (const double one : excess) result.push_back(one > tolerance);
  const auto from_end = [&](auto sample, auto wrong, const auto& end, auto marked) {
    for (; sample != end && sample->sign != 0 && *wrong > 0; ++sample, ++wrong, ++marked) *marked = true;
  };
  const auto& samples = contact.samples();
  from_end(samples.begin(), excess.begin(), samples.end(), result.begin());
  from_end(samples.rbegin(), excess.rbegin(), samples.rend(), result.rbegin());
  return result;
}

/// The possible errors of the tractions at the samples. Where zones are left out the contact may be any other: the
/// error of the pressure may be the mean pressure, and the shear may be friction in the other direction. At a distance
/// d from such a part of length l the strains caused by its error are l/d of those in it, by Cauchy's kernel. This is
/// also the relative error of the tractions there.
std::vector<ZoneContact::Traction> wrong_by(const ZoneContact& contact, const std::vector<double>& excess,
                                            const std::vector<bool>& is_left_out, double friction) {
  const auto& samples = contact.samples();
  const double mean = contact.load() / contact.length();
  std::vector<ZoneContact::Traction> wrong;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double share = is_left_out[i] ? 1 : 0;
    for (std::size_t k = 0; k < samples.size() && share < 1; ++k)
      if (is_left_out[k]) share += samples[k].weight / std::fabs(samples[k].e - samples[i].e);
    const double own = std::fabs(samples[i].pressure);
    const double pressure = std::min(share, 1.0) * (is_left_out[i] ? std::max(mean, own) : own);
    wrong.push_back({pressure, friction * (2 * pressure + own * excess[i])});
  }
  return wrong;
}

}  // namespace

double boundary(const ZoneContact& contact, std::size_t k) {
  double e = 0;
  for (std::size_t z = 0; z < k; ++z) e += contact.zones()[z].length;
  return contact.leading_length() - e;
}

bool is_smooth(const ZoneContact& contact, std::size_t k) { return contact.zones()[k].sign == 0; }

double longer_beside(const ZoneContact& contact, std::size_t k) {
  return std::max(contact.zones()[k - 1].length, contact.zones()[k].length);
}

double shorter_beside(const ZoneContact& contact, std::size_t k) {
  return std::min(contact.zones()[k - 1].length, contact.zones()[k].length);
}

std::optional<Solutions> with_differences(const PartialSlipTask& task, ZoneContact second, double nats,
                                          const std::vector<ZoneContact>& known) {
  const auto solved = [&](double nats_of_it) {
    for (const ZoneContact& contact : known)
      if (std::fabs(contact.nats() - nats_of_it) < 1e-9 && second.is_like(contact))
        return std::optional(contact);
    auto contact = ZoneContact::solved(task, second, nats_of_it);
    return contact && second.is_like(*contact) ? std::move(contact) : std::nullopt;
  };
  auto first = solved(nats);
  if (!first) return std::nullopt;
  const double mu = task.friction;
  double of_whole = relative_difference(*first, second, mu),
         of_boundaries = boundary_difference(*first, second);
  // By chance the first may agree with the second. A rougher contact shows the error of the first, too, because errors
  // fall like e^(-2 nats/3) or faster, those of smooth boundaries up to most_smooth_nats; see ZoneMesh::boundary().
  constexpr double rougher_by = 3;
  const double smooth_nats = std::min(nats, ZoneMesh::most_smooth_nats),
               rougher_nats = smooth_nats - rougher_by;
  if (const auto rougher = solved(rougher_nats)) {
    const auto fall_to = [&](double finer) { return std::exp(-2.0 / 3 * (finer - rougher_nats)); };
    of_whole = std::max(of_whole, fall_to(nats) * relative_difference(*rougher, second, mu));
    of_boundaries = std::max(of_boundaries, fall_to(smooth_nats) * boundary_difference(*rougher, second));
  }
  std::vector<ZoneContact::Traction> of_tractions;
  for (const ZoneContact::Sample& sample : second.samples()) {
    const ZoneContact::Traction before = first->traction(first->corresponding_place(second, sample.e));
    of_tractions.push_back(
        {std::fabs(sample.pressure - before.pressure), std::fabs(sample.shear - before.shear)});
  }
  const std::vector<double> excess = excesses(second, mu);
  const std::vector<bool> is_left_out = left_out(second, excess, nats);
  std::vector<bool> lacks_zones(second.zones().size());
  // In such a part the load may be wrong by all of it, the traction by friction both ways, which is twice as much over
  // friction, and the creep over the length by about the coefficient of friction times the load's share.
  double part_left_out = 0;
  for (std::size_t i = 0; i < excess.size(); ++i) {
    if (!is_left_out[i]) continue;
    lacks_zones[static_cast<std::size_t>(second.samples()[i].zone)] = true;
    part_left_out += second.samples()[i].weight / second.length();
  }
  const double relative = mean_excess(second, mu) + 2 * std::max(1.0, mu) * part_left_out + of_whole +
                          second_order(*first, second);
  std::vector<ZoneContact::Traction> wrong = wrong_by(second, excess, is_left_out, mu);
  ZoneEquations::Rounding of_rounding = second.rounding();
  return Solutions{.first = *std::move(first),
                   .second = std::move(second),
                   .relative = relative,
                   .of_boundaries = of_boundaries,
                   .of_rounding = std::move(of_rounding),
                   .of_tractions = std::move(of_tractions),
                   .wrong_tractions = std::move(wrong),
                   .lacks_zones = std::move(lacks_zones)};
}

}  // namespace nipref::fast
