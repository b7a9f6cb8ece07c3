#pragma once
#include <nipref/data/material/stiffness.hpp>

namespace nipref::fast::internal {

/// The largest condition number of Voigt's matrix for which two words are precise enough.
inline constexpr double farthest_moduli = 1e12;

/// Throws BadInput "solid" if the condition number is larger.
void check_moduli(const data::Stiffness& solid);

}  // namespace nipref::fast::internal
