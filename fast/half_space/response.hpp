#pragma once
#include <functional>

#include <nipref/fast/half_space/line_response.hpp>

namespace nipref::fast {

/// What a contact needs to know of its two bodies: their answer along the lines of each direction, already
/// joined by in_contact. Opposite directions have the same compliance and the same couplings.
using SurfaceResponse = std::function<LineResponse(Direction)>;

}  // namespace nipref::fast
