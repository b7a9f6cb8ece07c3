#pragma once
#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

/// Plane bulk waves along a direction of the surface, unit sqrt(modulus/density).
enum class BulkWave {
  upright,  ///< polarised nearest to the surface's normal
  faster,   ///< of the two others
  slower
};

/// density v^2 is the eigenvalue of n_j C_ijkl n_l; the bound follows from the residual of the eigenpair and
/// holds for the eigenvalue nearest to it. BadInput "digits" unless 16 <= digits <= 1000.
Enclosure bulk_wave_speed(const ExactStiffness& solid, const SurfaceDirection& direction, BulkWave wave,
                          int digits);

}  // namespace nipref::ref
