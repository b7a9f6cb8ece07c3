#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/half_space_number.hpp>

namespace nipref::verify::confirm {

/// Lines, dies, spheres and ellipses on isotropic half-spaces; empty for other names.
Confirm of_isotropic(std::string_view quantity);

}  // namespace nipref::verify::confirm
