#pragma once
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/line_loads.hpp>

namespace nipref::fast {

/// A nip with Coulomb's friction by line loads at the centres of equal elements. No normal load is negative,
/// |Q| <= mu P, and Q = mu P against the slip if an element slips. In steady rolling the slip of an element is the
/// change of the displacement against the roller from the element ahead to this one.
///
/// The thesis's line loads hold the sheet to the roller midway between the loads (2.2). A row of loads of alternating
/// sign does not move these points, whatever its size, so that conditions of stick and slip there do not determine the
/// loads. These line loads hold the mean displacement of each element instead. The contact's ends are borders of
/// elements: the error of lengths is about an element, that of the creep mostly falls like 1/(number of elements)^2.
struct PartialSlipLineLoads : LineLoadNip {
  /// As of PartialSlipNip.
  std::vector<double> zone_boundaries;
  std::vector<int> zone_signs;

  [[nodiscard]] double traction() const;  ///< T, the sum of the shear loads, force per unit width
  /// The work of the rollers' torques per distance, force per unit width: W rolling_resistance() - T creep_ratio().
  [[nodiscard]] double dissipation() const;
};

/// The contact that carries `load` per unit width, as for partial_slip_for_load, with 1 to 1000 elements a side, whose
/// width is about half the contact length without friction over their number. BadInput otherwise, if friction moves
/// an end of the contact to more than 1.3 times half that length from the line through the rollers' centres, and in the
/// rare cases in which no loads are found that meet all conditions; another number of elements may help.
PartialSlipLineLoads line_loads_for_load(const data::PartialSlipNip& nip, int elements_per_side, double load);

}  // namespace nipref::fast
