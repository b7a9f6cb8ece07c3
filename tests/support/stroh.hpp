#pragma once
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/verify/golden/confirm/stroh.hpp>

// A second route to the surface response: Stroh's eigenvectors, 80 digits.

namespace stroh {

using Eigenvectors = nipref::verify::confirm::Stroh<80>;
using Float = Eigenvectors::Float;

/// Y, the inverse of the impedance, in the axes (n, across, 3); n = (cosine, sine) need not be normalised.
inline auto admittance(const nipref::ref::ExactStiffness& solid, const Float& phase_speed,
                       const Float& cosine, const Float& sine) {
  const auto to_float = [](const mpq_class& x) { return nipref::verify::confirm::to_number<Float>(x); };
  Eigenvectors::Voigt voigt;
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < 6; ++b) voigt[a][b] = to_float(solid.voigt[a][b]);
  }
  return Eigenvectors::admittance(voigt, to_float(solid.density), phase_speed, cosine, sine);
}

}  // namespace stroh
