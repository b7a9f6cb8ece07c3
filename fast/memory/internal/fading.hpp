#pragma once
#include <array>
#include <initializer_list>

#include <nipref/fast/memory/internal/fading_near_load.hpp>
#include <nipref/fast/memory/internal/waves.hpp>
#include <nipref/fast/number/accuracy.hpp>

namespace nipref::fast::internal {

/// A position against the load, in half-thicknesses, > 0 ahead of it, and its waves unless it is nearer than
/// nearest.
struct SurfacePoint {
  Two at;
  Waves waves;
};

SurfacePoint surface_point(Two at, Accuracy accuracy);

/// A real rate of fading, and what of the memory depends on nothing else: from one of -1, -1/2, 0, 1/2 to the
/// next, and from 1 on, int e^(-rate (w - start)) I(w) dw for the kernels it was made for.
struct Fade {
  Two rate;
  std::array<CorePieces, kernel_count> core{};
  std::array<double, kernel_count> beyond{};
};

Fade fade(Two rate, std::initializer_list<Kernel> kernels, Accuracy accuracy);

/// The kernel at a point; of the odd ones I(0) = 0.
double kernel_at(Kernel kernel, const SurfacePoint& at, Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) I(w) dw; at rate 0 of an odd kernel beside limit/rate.
double steady_memory(Kernel kernel, const SurfacePoint& start, const Fade& fade, Accuracy accuracy);
Complex steady_memory(Kernel kernel, const SurfacePoint& start, Complex rate, Accuracy accuracy);

/// The same as far as end = start + length. The length is wanted for itself: where it is short, the
/// difference of the points does not know it.
double memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, const Fade& fade,
              Accuracy accuracy);
Complex memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, Complex rate,
               Accuracy accuracy);

}  // namespace nipref::fast::internal
