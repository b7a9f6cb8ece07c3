#pragma once
#include <vector>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>

namespace nipref::ref {

/// A direction in degrees and the smallest speed at which its lines are critical, over sqrt(C33/density), to some 12
/// digits.
struct CriticalLine {
  double psi, speed;
};

/// The local minima that may be the lowest. Apart from rounding in double it is proven that no line is lower by more
/// than 1e-3, 1e-6 or 1e-9 of the lowest: the smallest of these for which 200 lines suffice and to which the lines'
/// own speeds are proven. BadInput "solid" where the fastest wave along the surface is 3000 times as fast, where 800
/// lines do not suffice, or where no proof for a line is found.
std::vector<CriticalLine> lowest_lines(const ExactStiffness& solid, const SurfaceDirection& motion);

}  // namespace nipref::ref
