#pragma once
#include "fast/accuracy.hpp"
#include "fast/hereditary_waves.hpp"

namespace nipref::fast::internal {

/// A position against the load, in half-thicknesses, > 0 ahead of it, and its waves unless it is nearer than
/// kNearest.
struct Spot {
  Two at;
  Waves waves;
};

Spot spot(Two at, Accuracy accuracy);

/// The fading part D of a kernel at a spot; that of the odd ones is less (pi/4) sign(w), sign(0) = 0.
double faded_kernel(Kernel kernel, const Spot& at, Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) D(w) dw.
double steady_memory(Kernel kernel, const Spot& start, Two rate, Accuracy accuracy);
Complex steady_memory(Kernel kernel, const Spot& start, Complex rate, Accuracy accuracy);

/// The same as far as end = start + length. The length is wanted for itself: where it is short, the
/// difference of the spots does not know it.
double memory(Kernel kernel, const Spot& start, const Spot& end, Two length, Two rate, Accuracy accuracy);
Complex memory(Kernel kernel, const Spot& start, const Spot& end, Two length, Complex rate,
               Accuracy accuracy);

}  // namespace nipref::fast::internal
