#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/confirm.hpp>

namespace nipref::verify::confirm {

/// material.*; empty for other names.
Confirm of_material(std::string_view quantity);

}  // namespace nipref::verify::confirm
