#pragma once
#include <vector>

#include <nipref/verify/golden/confirm/rolled_contact.hpp>

namespace nipref::verify::confirm {

/// nip.load, .indentation, .creep, .peak_pressure, .peak_shear of an elastic contact with full friction by sinc
/// collocation: x = A tanh w, so that the tractions decay in w. The tractions are values at multiples of a step in w.
/// The slopes of the surface are required half a step away from them, where the trapezoidal rule converges although
/// the integrals are principal values. The step is fine or coarse.
std::vector<Solved> gripped_numbers(double half_length, double poisson, bool fine);

}  // namespace nipref::verify::confirm
