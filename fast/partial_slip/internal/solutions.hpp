#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include <nipref/fast/partial_slip/internal/zone_contact.hpp>

namespace nipref::fast {

/// The contact by two discretisations, of which the second is the result, and their differences.
struct Solutions {
  ZoneContact first, second;
  double relative;       ///< relative error of the whole, with violated conditions and missing zones
  double of_boundaries;  ///< error of smooth boundaries of zones, over the longer zone beside
  ZoneEquations::Rounding of_rounding;  ///< of the second
  /// At each sample: the differences of the tractions, and their possible errors by zones that are left out.
  std::vector<ZoneContact::Traction> of_tractions, wrong_tractions;
  std::vector<bool> lacks_zones;  ///< for each zone, whether others are left out in it
  [[nodiscard]] bool lack_zones() const { return std::ranges::find(lacks_zones, true) != lacks_zones.end(); }
};

/// Solves the first discretisation, of `nats`, and a rougher one with the zones of the second, and compares. Nothing
/// if the first does not exist. `known`: contacts that are used again if they are the same.
std::optional<Solutions> with_differences(const PartialSlipTask& task, ZoneContact second, double nats,
                                          const std::vector<ZoneContact>& known);

/// Y of the boundary before the zone number k.
double boundary(const ZoneContact& contact, std::size_t k);
/// Whether slip turns into stick there, where tractions are smooth, so that this boundary is the least accurate one.
bool is_smooth(const ZoneContact& contact, std::size_t k);
/// The length of the longer and of the shorter zone beside this boundary.
double longer_beside(const ZoneContact& contact, std::size_t k);
double shorter_beside(const ZoneContact& contact, std::size_t k);

}  // namespace nipref::fast
