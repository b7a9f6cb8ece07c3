#pragma once
#include <string>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// MODEL(KEY=VALUE, ...) of the material of the scene in that file, or of its half-space for an argument "solid". Keys
/// that are arguments of their own, such as the direction of an axis, are left out. BadInput for a file that holds none.
std::string solid_of_scene(const Quantity& quantity, const Argument& material, const std::string& path);

}  // namespace nipref::verify
