#pragma once
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// What is analytic of the kernels of a contact with friction, lengths in half-thicknesses.
struct GripKernels {
  SmoothKernel normal;    ///< I1(alpha) + ln|alpha|
  SmoothKernel coupling;  ///< I3 for alpha > 0
  SmoothKernel stretch;   ///< I6(alpha, eta) - I1(alpha) up to a constant: -int I3

  explicit GripKernels(int digits);

  /// I3 with its sign.
  [[nodiscard]] Float odd_coupling(const Float& alpha) {
    return alpha < 0 ? -coupling(alpha) : coupling(alpha);
  }
  /// I6 + ln|alpha| up to a constant.
  [[nodiscard]] Float tangential(const Float& alpha) { return normal(alpha) + stretch(alpha); }
};

}  // namespace nipref::ref
