#pragma once
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimated.hpp>

namespace nipref::ref {

// A rigid sphere that rolls without slip, in multiprecision, by the papers' rule and from what the surface
// answers along lines; errors are estimated.
//
//   digits      16 to 100, else BadInput; results are good to 10^-digits of themselves
//   degrees     angle of a line from the motion

/// P = ln((1 + q)/(1 - q))/(2 pi), q = S/sqrt(K K_nn): how the tractions of rolling without slip oscillate at
/// the ends of a line. (brock2012 43b)
Estimated rolling_index(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// L(psi)/L(0) of a rolling sphere by the papers' rule, to first order in span over radius: amplitudes, whose
/// squares go like K_nn/K/(K K_nn - S^2), are equal at the centre. (brock2012 53)
Estimated rolling_span_ratio(const SurfaceAnswer& surface, const Exact& degrees, int digits);

}  // namespace nipref::ref
