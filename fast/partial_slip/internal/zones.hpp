#pragma once
#include <optional>
#include <vector>

namespace nipref::fast {

/// A part of the contact where the sheet sticks or slips one way. Zones are counted in the order in which the sheet
/// passes them, and e >= 0 is the distance from the leading end.
struct Zone {
  double length;  ///< half-thicknesses
  int sign;       ///< of the shear along the motion where it slips, 0 where it sticks
};

/// What determines a contact with partial slip, dimensionless as in NipEquations, shear and strain along e: one of load
/// and length, and one of traction and creep.
struct PartialSlipTask {
  double beta;      ///< theta2/N
  double friction;  ///< mu
  std::optional<double> load = {}, length = {}, traction = {}, creep = {};
};

}  // namespace nipref::fast
