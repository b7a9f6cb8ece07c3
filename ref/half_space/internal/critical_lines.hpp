#pragma once
#include <vector>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>

namespace nipref::ref {

/// A direction in degrees and the smallest speed at which its lines are critical, to some 12 digits and over
/// sqrt(C33/density).
struct CriticalLine {
  double psi, speed;
};

/// The bottoms of the valleys that may be as low as the lowest. That no line is lower by more than 1e-3, 1e-6, 1e-9 of
/// it is proven, but for rounding in double, to the last of these that 200 lines are enough for, and that their own
/// speeds are proven to. BadInput "solid" where moduli are so far apart that the fastest wave along the surface is 3000
/// times as fast, 800 lines are not enough, or no proof of a line is found.
std::vector<CriticalLine> lowest_lines(const ExactStiffness& solid, const SurfaceDirection& motion);

}  // namespace nipref::ref
