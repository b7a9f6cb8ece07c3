#pragma once
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/line_loads.hpp>

namespace nipref::fast {

/// A nip with Coulomb's friction by line loads at the centres of equal elements: no normal load is negative, |Q| <= mu P, and
/// Q = mu P against the slip where an element slips. In steady rolling an element slips by how far its surface moves against
/// the roller after that of the element ahead.
///
/// The thesis's line loads hold the sheet to the roller midway between them (2.2). Midway, a row of loads of alternating
/// sign moves nothing, whatever its size, so that there the conditions of stick and slip do not settle the loads. These
/// hold the mean displacement of each element instead. The contact's ends are borders of elements: lengths err by about
/// an element. The creep errs in most contacts like 1 over the square of their number.
struct PartialSlipLineLoads : LineLoadNip {
  /// As of a PartialSlipNip.
  std::vector<double> zone_boundaries;
  std::vector<int> zone_signs;

  [[nodiscard]] double traction() const;  ///< T, the sum of the shear loads, force per unit width
  /// What the rollers' torques put in, force per unit width: W rolling_resistance() - T creep_ratio().
  [[nodiscard]] double dissipation() const;
};

/// The contact that carries `load` per unit width, as for partial_slip_for_load. From 1 to 1000 elements a side, whose width
/// is about half the contact's length without friction over their number; BadInput otherwise, and in rare cases where no
/// loads are found that meet all conditions, which other numbers of elements may have.
PartialSlipLineLoads line_loads_for_load(const data::PartialSlipNip& nip, int elements_per_side, double load);

}  // namespace nipref::fast
