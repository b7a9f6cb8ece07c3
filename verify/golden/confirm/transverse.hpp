#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/half_space_number.hpp>

namespace nipref::verify::confirm {

/// Lines, critical speeds and spheres on transversely isotropic half-spaces; empty for other names.
Confirm of_transverse(std::string_view quantity);

}  // namespace nipref::verify::confirm
