#pragma once
#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// Plane bulk waves along a direction of the surface, unit sqrt(modulus/density).
enum class BulkWave {
  upright,  ///< polarised nearest to the surface's normal
  faster,   ///< of the two others
  slower
};

/// density v^2 is an eigenvalue of n_j C_ijkl n_l. The error follows from the residual of the eigenpair, with an
/// allowance for rounding. It is not proven, as it is the distance from the nearest eigenvalue, whichever that is.
/// BadInput "digits" unless 16 <= digits <= 1000.
Estimate bulk_wave_speed(const ExactStiffness& solid, const SurfaceDirection& direction, BulkWave wave,
                         int digits);

}  // namespace nipref::ref
