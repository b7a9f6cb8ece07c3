#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/half_space_number.hpp>

namespace nipref::verify::confirm {

/// Lines and critical speeds of half-spaces of any anisotropy; empty for other names.
Confirm of_anisotropic(std::string_view quantity);

}  // namespace nipref::verify::confirm
