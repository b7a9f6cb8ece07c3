#pragma once
#include <algorithm>
#include <cmath>

#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {

/// I3'(alpha)/pi: the strain of the surface at the distance alpha from a unit of pressure. It is half the stress
/// sigma_y that a normal load causes along the faces.
inline double stretch_over_pi(double alpha) {
  constexpr double nearest = 1e-299;  // the field's own domain; I3' is even and smooth
  return sheet_stresses(std::max(std::fabs(alpha), nearest), 1, data::SheetLoad::normal).along / 2;
}

}  // namespace nipref::fast
