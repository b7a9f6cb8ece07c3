#pragma once
#include <span>

#include <nipref/fast/number/accuracy.hpp>

// Memory of the sheet under a load that has always been moving: what a relaxation term e^(-Lambda w) keeps of
// the kernels ahead of a point, w the position in half-thicknesses.

namespace nipref::fast {

/// int_alpha^inf e^(-Lambda (w - alpha)) I1(w) dw, dimensionless: what a point at alpha remembers of the load
/// while it was farther ahead. Residue sums and the kernel's transform at an imaginary frequency where
/// |alpha| >= 1, exponential integrals and Gauss rules nearer to the load. 0.3 to 1 us.
///
///   alpha      either sign, 0 included, finite
///   Lambda     lambda b/F0: rate of relaxation in the time that the load takes for a half-thickness;
///              0 <= Lambda < inf
///   accuracy   max(8 units in the last place, rtol) of the same integral over max(|I1|, its envelope)
///   bad input  nan or infinite arguments, Lambda < 0, spans of different sizes: data::BadInput
double steady_I1(double alpha, double Lambda, Accuracy accuracy = {});

/// value[i] = steady_I1(alpha[i], Lambda); the two spans may be the same.
void steady_I1(std::span<const double> alpha, double Lambda, std::span<double> value, Accuracy accuracy = {});

}  // namespace nipref::fast
