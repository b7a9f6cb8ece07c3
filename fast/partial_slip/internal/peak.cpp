#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include <nipref/fast/partial_slip/internal/peak.hpp>

namespace nipref::fast {

Peak peak(const ZoneContact& contact, double ZoneContact::Traction::*part) {
  const std::vector<ZoneContact::Sample>& samples = contact.samples();
  const auto size_at = [&](double e) { return std::fabs(contact.traction(e).*part); };
  const auto largest =
      std::ranges::max_element(samples, {}, [&](const auto& sample) { return size_at(sample.e); });
  const double left = largest == samples.begin() ? 0 : std::prev(largest)->e;
  const double right = std::next(largest) == samples.end() ? contact.length() : std::next(largest)->e;
  const auto [e, negative] =
      boost::math::tools::brent_find_minima([&](double place) { return -size_at(place); }, left, right, 30);
  Peak peak{-negative, e};
  // At a boundary of zones it may have a cusp.
  double boundary = 0;
  for (const Zone& zone : contact.zones()) {
    boundary += zone.length;
    if (size_at(boundary) >= peak.size) peak = {size_at(boundary), boundary};
  }
  return peak;
}

}  // namespace nipref::fast
