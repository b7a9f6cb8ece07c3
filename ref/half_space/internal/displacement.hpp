#pragma once
#include <array>

#include <nipref/ref/half_space/internal/smooth_lines.hpp>

namespace nipref::ref {

/// The pressure peak sqrt(1 - (x/a)^2 - (y/b)^2), x along the major axis, whose angle from the motion is in radians.
struct EllipticPressure {
  Float a, b, major, peak;
};

/// A place at the distance x from the centre, in the direction psi, in radians, below the surface if the depth is not 0.
struct PlaceInside {
  Float psi, x, depth;
};

/// Along the motion, across it and into the half-space.
struct Displaced {
  std::array<Float, 3> value, error;
};

/// The displacement under the first of two nearly equal pressures. By the double exponential rule between the lines where
/// the integrand has its peaks or no derivative; the error is the sum of the differences between the last two levels of
/// the rule and that between both pressures. Derivation: ref/half_space/README.md, Displacements.
Displaced displacement_under(const std::array<EllipticPressure, 2>& pressures, const SmoothLines& lines,
                             const PlaceInside& place, int digits);

}  // namespace nipref::ref
