#pragma once
#include <array>
#include <initializer_list>
#include <optional>

#include <nipref/fast/memory/internal/fading_near_load.hpp>
#include <nipref/fast/memory/internal/smooth_part.hpp>
#include <nipref/fast/memory/internal/waves.hpp>
#include <nipref/fast/number/accuracy.hpp>

namespace nipref::fast::internal {

/// A position relative to the load, in half-thicknesses, > 0 ahead of it. `waves` is filled where it is at least
/// `nearest` from the load.
struct SurfacePoint {
  Two at;
  Waves waves;
};

SurfacePoint surface_point(Two at, Accuracy accuracy);

/// A rate, and for the kernels it was made for what depends on it alone: `core` for integrals of e^(-rate (w - start)) I(w)
/// up to the distance `nearest`, `beyond` from there to infinity, and those of the smooth part's derivative, if there is one.
template <typename Rate, typename Core, typename Integral>
struct FadeOf {
  using Number = Integral;

  Rate rate;
  std::array<Core, kernel_count> core{};
  std::array<Number, kernel_count> beyond{};
  std::array<std::optional<SmoothMemory<Number>>, kernel_count> slope{};
};
/// A real rate, with the integrals over [-1, -1/2], [-1/2, 0], [0, 1/2], [1/2, 1]; and a complex one, for many places.
using Fade = FadeOf<Two, CorePieces, double>;
using OscillatingFade = FadeOf<Complex, std::optional<OscillatingCore>, Complex>;

Fade fade(Two rate, std::initializer_list<Kernel> kernels, Accuracy accuracy);
OscillatingFade fade(Complex rate, std::initializer_list<Kernel> kernels, Accuracy accuracy);

/// The kernel at a point; the odd ones are 0 under the load.
double kernel_at(Kernel kernel, const SurfacePoint& at, Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) I(w) dw. For an odd kernel at rate 0, where this diverges, limit/rate is left
/// out.
double steady_memory(Kernel kernel, const SurfacePoint& start, const Fade& fade, Accuracy accuracy);
Complex steady_memory(Kernel kernel, const SurfacePoint& start, Complex rate, Accuracy accuracy);
Complex steady_memory(Kernel kernel, const SurfacePoint& start, const OscillatingFade& fade,
                      Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) (I(w) - l) dw, l the limit of I far ahead of the load.
template <typename Kept>
typename Kept::Number steady_memory_beside_limit(Kernel kernel, const SurfacePoint& start, const Kept& fade,
                                                 Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) I'(w) dw of I3, or of I1 with start > 0. The error is a few units in the last place:
/// of its own size, which may be far below that of I, for real rates and for complex ones from polynomial_from on, of I's for
/// others.
double steady_memory_of_slope(Kernel kernel, const SurfacePoint& start, const Fade& fade, Accuracy accuracy);
Complex steady_memory_of_slope(Kernel kernel, const SurfacePoint& start, const OscillatingFade& fade,
                               Accuracy accuracy);

/// The integral of steady_memory up to end = start + length. `length` is an argument of its own because a short length is
/// lost in the rounding of end - start.
double memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, const Fade& fade,
              Accuracy accuracy);
Complex memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, Complex rate,
               Accuracy accuracy);

}  // namespace nipref::fast::internal
