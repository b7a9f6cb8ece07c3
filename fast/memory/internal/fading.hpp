#pragma once
#include <array>
#include <initializer_list>
#include <optional>

#include <nipref/fast/memory/internal/fading_near_load.hpp>
#include <nipref/fast/memory/internal/smooth_part.hpp>
#include <nipref/fast/memory/internal/waves.hpp>
#include <nipref/fast/number/accuracy.hpp>

namespace nipref::fast::internal {

/// A position relative to the load, in half-thicknesses, > 0 ahead of the load. `waves` is filled if the distance from
/// the load is at least `nearest`.
struct SurfacePoint {
  Two at;
  Waves waves;
};

SurfacePoint surface_point(Two at, Accuracy accuracy);

/// A rate, and integrals of e^(-rate (w - start)) I(w) that depend on the rate alone, for the kernels of its
/// construction. `core` serves for w < `nearest`, `beyond` is the integral from `nearest` to infinity, and `slope`,
/// where present, serves for the derivative of the kernel's smooth part.
template <typename Rate, typename Core, typename Integral>
struct FadeOf {
  using Number = Integral;

  Rate rate;
  std::array<Core, kernel_count> core{};
  std::array<Number, kernel_count> beyond{};
  std::array<std::optional<SmoothMemory<Number>>, kernel_count> slope{};
};
/// Fade is for a real rate; its core has the integrals over [-1, -1/2], [-1/2, 0], [0, 1/2], [1/2, 1]. OscillatingFade
/// is for a complex rate and many starts.
using Fade = FadeOf<Two, CorePieces, double>;
using OscillatingFade = FadeOf<Complex, std::optional<OscillatingCore>, Complex>;

Fade fade(Two rate, std::initializer_list<Kernel> kernels, Accuracy accuracy);
OscillatingFade fade(Complex rate, std::initializer_list<Kernel> kernels, Accuracy accuracy);

/// The kernel at a point. Odd kernels are 0 under the load.
double kernel_at(Kernel kernel, const SurfacePoint& at, Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) I(w) dw. For an odd kernel at rate 0, where it diverges, limit/rate is left out.
double steady_memory(Kernel kernel, const SurfacePoint& start, const Fade& fade, Accuracy accuracy);
Complex steady_memory(Kernel kernel, const SurfacePoint& start, Complex rate, Accuracy accuracy);
Complex steady_memory(Kernel kernel, const SurfacePoint& start, const OscillatingFade& fade,
                      Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) (I(w) - l) dw, l the limit of I far ahead of the load.
template <typename Kept>
typename Kept::Number steady_memory_beside_limit(Kernel kernel, const SurfacePoint& start, const Kept& fade,
                                                 Accuracy accuracy);

/// int_start^inf e^(-rate (w - start)) I'(w) dw of I3, or of I1 with start > 0. For real rates, and complex rates of
/// modulus polynomial_from or more, the error is a few units in the last place of the result, which may be far smaller
/// than I. For other complex rates it is a few units in the last place of I.
double steady_memory_of_slope(Kernel kernel, const SurfacePoint& start, const Fade& fade, Accuracy accuracy);
Complex steady_memory_of_slope(Kernel kernel, const SurfacePoint& start, const OscillatingFade& fade,
                               Accuracy accuracy);

/// int_start^end e^(-rate (w - start)) I(w) dw with end = start + length. `length` is a separate argument because
/// end - start loses the digits of a short length.
double memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, const Fade& fade,
              Accuracy accuracy);
Complex memory(Kernel kernel, const SurfacePoint& start, const SurfacePoint& end, Two length, Complex rate,
               Accuracy accuracy);

}  // namespace nipref::fast::internal
