#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/confirm.hpp>

namespace nipref::verify::confirm {

/// J1 to J6 and the displacements under a moving load; empty for other names.
Confirm of_memory(std::string_view quantity);

}  // namespace nipref::verify::confirm
