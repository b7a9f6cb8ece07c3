#pragma once
#include <string_view>

#include <nipref/verify/golden/confirm/confirm.hpp>

namespace nipref::verify::confirm {

/// Roots, kernels and displacements of the elastic sheet; empty for other names.
Confirm of_sheet(std::string_view quantity);

}  // namespace nipref::verify::confirm
