#pragma once
#include <algorithm>
#include <cmath>

#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {

/// I3'(alpha)/pi, by which pressure beside a place stretches the surface there: half of the stress sigma_y that a normal
/// load makes along the faces beside it.
inline double stretch_over_pi(double alpha) {
  constexpr double nearest = 1e-299;  // the field's own domain; I3' is even and smooth
  return sheet_stresses(std::max(std::fabs(alpha), nearest), 1, data::SheetLoad::normal).along / 2;
}

}  // namespace nipref::fast
