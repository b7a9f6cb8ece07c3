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
  std::vector<Peak> found;
  const auto search = [&](int panel, double from, double to) {
    const auto [s, negative] = boost::math::tools::brent_find_minima(
        [&](double place) {
          return -size_at({panel, place});
        },
        from, to, 30);
    found.push_back({-negative, contact.place({panel, s})});
  };
  // In s, as a peak may be very near to a boundary; beyond the first and the last sample of a panel, too.
  const double step = contact.sample_step();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& [panel, s] = std::pair(samples[i].point.panel, samples[i].point.s);
    const bool is_first = i == 0 || samples[i - 1].point.panel != panel;
    const bool is_last = i + 1 == samples.size() || samples[i + 1].point.panel != panel;
    const double here = size_at(samples[i].point);
    const bool is_largest = (is_first || here >= size_at(samples[i - 1].point)) &&
                            (is_last || here >= size_at(samples[i + 1].point));
    if (is_largest || is_first || is_last)
      search(panel, is_first ? -ZoneMesh::farthest : s - step, is_last ? ZoneMesh::farthest : s + step);
  }
  double boundary = 0;
  const std::vector<Zone>& zones = contact.zones();
  for (std::size_t z = 0; z + 1 < zones.size(); ++z) {
    boundary += zones[z].length;
    found.push_back({std::fabs(contact.traction_after(z).*part), boundary});
  }
  return found;
}

Peak largest(const std::vector<Peak>& peaks) { return std::ranges::max(peaks, {}, &Peak::size); }

}  // namespace nipref::fast
