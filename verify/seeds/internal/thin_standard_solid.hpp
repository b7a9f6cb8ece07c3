#pragma once
#include <nipref/verify/seeds/propagated.hpp>

namespace nipref::verify {

/// A very thin frictionless sheet of the solid with one relaxation time tau that ends up twice as compliant as it
/// begins: springs with N p + (N/tau) int e^(-t/tau) p = 2 u/b, in closed form.
struct ThinStandardSolid {
  Propagated leading_share;  ///< L1/L
  Propagated resistance;     ///< mu_R R/L
};

/// memory: F0 tau/L, > 0.
ThinStandardSolid thin_standard_solid(double memory);

}  // namespace nipref::verify
