#pragma once
#include <array>

#include <nipref/ref/half_space/internal/contact.hpp>

namespace nipref::ref {

/// The pressure peak sqrt(1 - (x/a)^2 - (y/b)^2), x along the major axis, whose angle from the motion is in radians.
struct EllipticPressure {
  Float a, b, major, peak;
};

/// The displacement of the surface under this pressure at the distance x from the centre, in the direction psi, in radians:
/// along the motion, across it and into the half-space. By the double exponential rule of unit_integral(digits) between the
/// lines where the integrand has its peaks or no derivative.
/// Derivation: ref/half_space/README.md, Displacements of the surface.
std::array<Float, 3> displacement_under(const EllipticPressure& pressure, const WorkingSurface& half_space,
                                        const PeakOfCompliance& peak, const Float& psi, const Float& x,
                                        int digits);

}  // namespace nipref::ref
