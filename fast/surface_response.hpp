#pragma once
#include <functional>

#include "fast/surface_line.hpp"

namespace nipref::fast {

/// What a contact needs to know of its two bodies: their answer along the lines of each direction, already
/// summed (compliances add, couplings subtract: the shear on one is the reaction on the other, brock2013
/// 25b-c). Opposite directions have the same compliance and the same coupling.
using SurfaceResponse = std::function<LineResponse(Direction)>;

}  // namespace nipref::fast
