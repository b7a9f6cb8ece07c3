#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include <nipref/fast/partial_slip/internal/zone_contact.hpp>

namespace nipref::fast {

/// The contact of two discretisations, of which the second is the result, and what it differs by from coarser ones.
struct Solutions {
  ZoneContact first, second;
  double relative;       ///< as a whole, with what is wrong in it
  double of_boundaries;  ///< where slip turns into stick, over the longer zone beside
  /// At each sample: the differences of the tractions, and by how much these may be wrong as zones are left out.
  std::vector<ZoneContact::Traction> of_tractions, wrong_tractions;
  std::vector<bool> lacks_zones;  ///< of each zone, whether others are left out in it
  [[nodiscard]] bool lack_zones() const { return std::ranges::find(lacks_zones, true) != lacks_zones.end(); }
};

/// With the second solution known, which has the zones: the first, and how they differ. The error of a boundary where slip
/// turns into stick alternates in sign with the number of nodes beside it. It is in the difference from the first solution,
/// in that from one with a node less there, or in that from a rougher one. Nothing where the first two do not exist. `lesser`, if
/// any: those of a lesser accuracy, whose contacts are used where they are the same.
std::optional<Solutions> with_differences(const PartialSlipTask& task, ZoneContact second, double nats,
                                          const Solutions* lesser = nullptr);

/// Y of the boundary before the zone number k.
double boundary(const ZoneContact& contact, std::size_t k);
/// Where slip turns into stick. See ZoneMesh::smooth_reach.
bool is_smooth(const ZoneContact& contact, std::size_t k);
/// Of the zones before and behind it.
double longer_beside(const ZoneContact& contact, std::size_t k);
double shorter_beside(const ZoneContact& contact, std::size_t k);

}  // namespace nipref::fast
