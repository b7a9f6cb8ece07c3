#pragma once
#include <nipref/verify/golden/confirm/half_space_number.hpp>
#include <nipref/verify/golden/confirm/rational.hpp>

/// The surface response of anisotropic half-spaces by Stroh's formalism: eigenvectors from the roots of the sextic
/// polynomial. It is for solids whose roots are distinct and has no proven error.
namespace nipref::verify::confirm {

/// A half-space by its stiffness in Voigt's notation and its density.
struct StrohSolid {
  std::array<std::array<Float, 6>, 6> voigt;
  Float density;

  /// Y, the inverse of the impedance, for lines at psi with the phase speed `phase`, in the axes (n, across, 3).
  [[nodiscard]] std::array<std::array<Complex, 3>, 3> admittance(const Float& psi_degrees,
                                                                 const Float& phase) const;
};

inline Float cosine_between(const Float& psi_degrees, const Float& theta_degrees) {
  return cosine_of(psi_degrees - theta_degrees);
}

/// The speed at which 1/K vanishes along psi, by the secant rule from a double near it.
Float surface_wave(const StrohSolid& solid, const Float& psi, const Float& theta, double near);

Confirmation by_secant(const Float& value);

/// The minimum of this speed over all lines, by Newton's iteration for a zero of its slope, from a nearby line and
/// speed.
Confirmation lowest_surface_wave(const StrohSolid& solid, double near_psi, double theta, double near_speed);

}  // namespace nipref::verify::confirm
