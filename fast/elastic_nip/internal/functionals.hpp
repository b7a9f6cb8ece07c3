#pragma once
#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/elastic_nip/internal/half_contact.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>

namespace nipref::fast {

// What follows from a solved half contact, in its dimensionless units. `y` is the distance from the middle,
// in half-thicknesses, >= 0; results for -y follow by symmetry.

/// Material and quadrature behind the displacements.
struct SurfaceDisplacements {
  data::Friction friction;
  double beta;       ///< theta2/N, dimensionless
  double tolerance;  ///< of the quadrature
};

/// Normal displacement; inside the contact that of the roller, so that only points outside cost kernel
/// values.
double normal_displacement(const HalfContact& contact, double y, const SurfaceDisplacements& how,
                           CountedKernels& kernels);

/// Tangential displacement relative to the middle.
double tangential_displacement(const HalfContact& contact, double y, const SurfaceDisplacements& how,
                               CountedKernels& kernels);

/// The nonlocal part of the surface's strain without friction, int I3'(y - s) p(s) ds/pi. The pressure at y adds
/// -beta p(y).
double smooth_strain(const HalfContact& contact, double y, const SurfaceDisplacements& how,
                     CountedKernels& kernels);

/// Largest pressure, and largest magnitude of the shear.
double peak_pressure(const HalfContact& contact);
double peak_shear(const HalfContact& contact);

}  // namespace nipref::fast
