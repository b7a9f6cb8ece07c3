#pragma once
#include <nipref/ref/elastic_nip/internal/end_moments.hpp>
#include <nipref/ref/elastic_nip/internal/grip_kernels.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

/// Pressure and shear at one point, and displacements of one with the slope of the tangential one; in the units of
/// GripExpansion.
struct GripTraction {
  Float pressure, shear;
};
struct GripDisplacement {
  Float normal, tangential, strain;
};
/// By quadrature, with its error as its last step tells it.
struct GripOutside {
  GripDisplacement value, error;
};

/// How a contact is discretised. Both numbers even.
struct GripLayout {
  int terms;
  int nodes;      ///< of the interpolation of the kernels
  bool at_zeros;  ///< of Chebyshev's polynomial T_{terms + 2} the condition is matched, else of U_{terms + 2}
};

/// The contact of an elastic nip with full friction, A = L/B its half length in half-thicknesses, tractions
/// times 2 R N/b, displacements times 2 R/b^2, creep times 2 R/b. With f = p + i q, t = y/A, beta = theta2/N
/// and w as in EndMoments
///
///     u + i v = (A/pi) int [-ln|t - s| - i beta (pi/2) sign(t - s)] f ds + what is smooth = d1 + A^2 (1 - t^2) +
///     i creep A t,    f = w sum_k i^k r_k U_k(t), r_k real
///
/// as f(-t) is the conjugate of f(t). The derivative of the first part, by Plemelj's formulae, is -(t + 2 i
/// epsilon)/cosh(pi epsilon) for U_0 alone, and U_{k+1} = 2 s U_k - U_{k-1} under the integral makes of it
///
///     -(t + 2 i epsilon) U_k/cosh(pi epsilon) + (2/pi) sum_{j<k} (int w U_j) U_{k-1-j},
///
/// so that the first part is a polynomial in closed form (integral of U_n: T_{n+1}/(n+1)), with a constant
/// from its value at t = 1. The smooth part: the kernels interpolated in s at Chebyshev points, times f
/// integrated by the moments of w. Matched at as many points as there are unknowns. (Muskhelishvili, Singular
/// Integral Equations; Erdogan, Gupta, Cook 1973)
///
/// Nothing is proven: what two layouts differ by estimates the error.
class GripExpansion {
 public:
  /// beta as in EndMoments: tanh(pi epsilon).
  GripExpansion(Float half_length, Float beta, const GripLayout& layout, GripKernels& kernels);
  /// How many this program has solved so far: nearly all of the work.
  static long solved();

  [[nodiscard]] const Float& half_length() const { return half_length_; }
  [[nodiscard]] const Float& edge_displacement() const { return edge_displacement_; }
  [[nodiscard]] const Float& creep() const { return creep_; }
  [[nodiscard]] const Float& load() const { return load_; }
  [[nodiscard]] int terms() const { return static_cast<int>(coefficients_.size()); }
  [[nodiscard]] Float indentation() const { return edge_displacement_ + half_length_ * half_length_; }
  /// d ln W/d ln A: dW/dA goes with the square of how the tractions' derivatives grow at the ends.
  [[nodiscard]] Float growth() const;
  /// At t = 1 - before_end, 0 <= t; 0 outside.
  [[nodiscard]] GripTraction traction(const Float& before_end) const;
  /// At t = 1 - before_end > 1, by double exponential quadrature until displacements change by `enough` of A^2 at most
  /// and the strain by that of A.
  [[nodiscard]] GripOutside displacement_outside(const Float& before_end, const Float& enough,
                                                 GripKernels& kernels) const;

 private:
  Float half_length_, beta_, epsilon_;
  Vector coefficients_;
  Float edge_displacement_, creep_, load_;
};

}  // namespace nipref::ref
