#pragma once
#include <span>

namespace nipref::fast {

/// The arguments that an audit should test first, in ascending order: every |alpha| or |eta| at which the code for the
/// sheet kernels changes its regime or its piece, and the first cells of the tables that are used periodically (the
/// logarithm's in each octave, the exponential's and the phase's along the tail).
std::span<const double> branch_points();

}  // namespace nipref::fast
