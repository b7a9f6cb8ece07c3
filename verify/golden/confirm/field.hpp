#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/confirm.hpp>

namespace nipref::verify::confirm {

/// The field inside the sheet: up to |alpha| = 3 the half-planes' fields under the loads and the integrals along the real
/// axis of what they leave of the thesis's integrands, beyond by integrals around the poles. Empty for other names.
Confirm of_field(std::string_view quantity);

}  // namespace nipref::verify::confirm
