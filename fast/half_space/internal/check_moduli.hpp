#pragma once
#include <nipref/data/material/stiffness.hpp>

namespace nipref::fast::internal {

/// Of the largest eigenvalue of Voigt's matrix over the smallest: beyond it two words do not hold what the lines need.
inline constexpr double farthest_moduli = 1e12;

/// BadInput "solid" if its moduli are farther apart than that.
void check_moduli(const data::Stiffness& solid);

}  // namespace nipref::fast::internal
