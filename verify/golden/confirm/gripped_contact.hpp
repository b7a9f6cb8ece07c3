#pragma once
#include <vector>

#include <nipref/verify/golden/confirm/rolled_contact.hpp>

namespace nipref::verify::confirm {

/// nip.load, .indentation, .creep, .peak_pressure, .peak_shear of an elastic contact with full friction by the sinc
/// rule: x = A tanh w, tractions by their values at multiples of a step in w, where they decay, the slopes of the
/// surface half a step beside, where the trapezoidal rule has no principal value to mind. Fine or coarse steps.
std::vector<Solved> gripped_numbers(double half_length, double poisson, bool fine);

}  // namespace nipref::verify::confirm
