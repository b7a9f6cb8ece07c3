#pragma once
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// -int_0^alpha I3 up to a constant: the part of I6 that depends on alpha, without I1.
Interval stretch_interval(const Exact& alpha, double nats);

/// The functions that compute the kernels of a nip: ref's own, except in tests.
struct GrippedKernels {
  NormalKernel normal = I1_interval, coupling = I3_interval, stretch = stretch_interval;
};

/// The kernels of a nip at any distance alpha in half-thicknesses, and their analytic parts.
class SheetKernels {
 public:
  /// Errors are about 10^-digits; the working precision has to be a few digits more.
  explicit SheetKernels(int digits, GrippedKernels from = {});

  /// I1(alpha), alpha not 0, and I1(alpha) + ln|alpha|.
  [[nodiscard]] Float normal(const Float& alpha);
  [[nodiscard]] Float smooth_normal(const Float& alpha);
  /// I3(alpha), which is odd, and I3'(alpha).
  [[nodiscard]] Float coupling(const Float& alpha);
  [[nodiscard]] Float coupling_slope(const Float& alpha);
  /// I6(alpha, eta) - I1(alpha) up to a constant: -int I3.
  [[nodiscard]] Float stretch(const Float& alpha);
  /// Slope of I1(alpha) + ln|alpha|.
  [[nodiscard]] Float smooth_normal_slope(const Float& alpha);

  /// The distance from which on I1 is 0 and I3 its limit to the kernels' digits. Both converge like e^(-2.1 |alpha|).
  [[nodiscard]] const Float& far() const { return far_; }
  [[nodiscard]] double nats() const { return nats_; }
  /// The sum of the errors of the three smooth parts, so far.
  [[nodiscard]] Interval error() const {
    return interval_of(normal_.error()) + interval_of(coupling_.error()) + interval_of(stretch_.error());
  }
  [[nodiscard]] KernelValues values() const {
    return {normal_.kernel_values(), coupling_.kernel_values(), stretch_.kernel_values()};
  }

 private:
  double nats_;
  Float far_;
  SmoothKernel normal_, coupling_, stretch_;
};

}  // namespace nipref::ref
