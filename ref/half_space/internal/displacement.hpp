#pragma once
#include <array>

#include <nipref/ref/half_space/internal/contact.hpp>

namespace nipref::ref {

/// The pressure peak sqrt(1 - (x/a)^2 - (y/b)^2), x along the major axis, whose angle from the motion is in radians.
struct EllipticPressure {
  Float a, b, major, peak;
};

/// A place at the distance x from the centre, in the direction psi, in radians, below the surface if the depth is not 0.
struct PlaceInside {
  Float psi, x, depth;
};

/// The displacement under this pressure: along the motion, across it and into the half-space. By the double exponential
/// rule of unit_integral(digits) between the lines where the integrand has its peaks or no derivative.
/// Derivation: ref/half_space/README.md, Displacements.
std::array<Float, 3> displacement_under(const EllipticPressure& pressure, const WorkingSurface& half_space,
                                        const PeakOfCompliance& peak, const PlaceInside& place, int digits);

}  // namespace nipref::ref
