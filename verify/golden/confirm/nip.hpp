#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/confirm.hpp>

namespace nipref::verify::confirm {

/// nip.* and rolling_nip.*; empty for other names.
Confirm of_nip(std::string_view quantity);

}  // namespace nipref::verify::confirm
