#pragma once
#include <span>

namespace nipref::fast {

/// The arguments that an audit should test first, in ascending order: every |alpha| or |eta| at which the code for the
/// sheet kernels changes its regime or its piece, and the edges of the first cells of tables that are used periodically.
/// These are the table of the logarithm in each octave, and those of the exponential and of the phase in the tail.
std::span<const double> branch_points();

}  // namespace nipref::fast
