#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include <nipref/fast/partial_slip/internal/peak.hpp>

namespace nipref::fast {

std::vector<Peak> peaks(const ZoneContact& contact, double ZoneContact::Traction::*part) {
  const std::vector<ZoneContact::Sample>& samples = contact.samples();
  const auto size_at = [&](const ZoneMesh::Point& point) {
    return std::fabs(contact.traction_at(point).*part);
  };
  // At the ends of the contact tractions are 0.
  std::vector<double> sizes{0};
  for (const ZoneContact::Sample& sample : samples) sizes.push_back(size_at(sample.point));
  sizes.push_back(0);
  std::vector<Peak> found;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (sizes[i + 1] < sizes[i] || sizes[i + 1] < sizes[i + 2]) continue;
    // In s, as a peak may be very near to a boundary.
    const auto& [panel, middle] = std::pair(samples[i].point.panel, samples[i].point.s);
    const auto [s, negative] = boost::math::tools::brent_find_minima(
        [&](double place) {
          return -size_at({panel, place});
        },
        middle - contact.sample_step(), middle + contact.sample_step(), 30);
    found.push_back({-negative, contact.place({panel, s})});
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
