#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include <nipref/fast/partial_slip/internal/peak.hpp>

namespace nipref::fast {

std::vector<Peak> peaks(const ZoneContact& contact, double ZoneContact::Traction::*part) {
  const std::vector<ZoneContact::Sample>& samples = contact.samples();
  const auto size_at = [&](double e) { return std::fabs(contact.traction(e).*part); };
  // The ends of the contact, where tractions are 0, and all samples.
  std::vector<Peak> places{{0, 0}};
  for (const ZoneContact::Sample& sample : samples) places.push_back({size_at(sample.e), sample.e});
  places.push_back({0, contact.length()});
  std::vector<Peak> found;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    if (places[i].size < places[i - 1].size || places[i].size < places[i + 1].size) continue;
    const auto [e, negative] = boost::math::tools::brent_find_minima(
        [&](double place) { return -size_at(place); }, places[i - 1].e, places[i + 1].e, 30);
    found.push_back({-negative, e});
  }
  double boundary = 0;
  const std::vector<Zone>& zones = contact.zones();
  for (std::size_t z = 0; z + 1 < zones.size(); ++z) {
    boundary += zones[z].length;
    found.push_back({std::fabs(contact.traction_after(z).*part), boundary});
  }
  return found;
}

Peak peak(const ZoneContact& contact, double ZoneContact::Traction::*part) {
  return std::ranges::max(peaks(contact, part), {}, &Peak::size);
}

}  // namespace nipref::fast
