#pragma once
#include <vector>

#include <nipref/ref/number/internal/cosines.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// The frictionless contact of an elastic nip at n Chebyshev points, A = L/B its half length in
/// half-thicknesses. Differentiated and divided by 2A the condition u = d1 + A^2 (1 - t^2) is
///
///     (1/pi) int_{-1}^{1} I1(A (t - s)) q(s) ds = -t,    |t| <= 1,    q = p'/(2A) odd,
///
/// With p/(2A) = sum_m c_m sin(mu theta), t = cos(theta), mu = 2m + 1, the logarithm of I1 acts in closed form and the
/// odd part of the rest has coefficients g_mn,
///
///     c_m + (1/2) sum_n g_mn nu c_n = delta_m0,    [J(A(t - s)) - J(A(t + s))]/2 = sum g_mn T_mu(t) T_nu(s).
///
/// Gauss-Chebyshev at theta_i = (2i + 1) pi/(4n) has (2/n)^2 cos(mu theta_i) cos(nu theta_j) summed over the
/// values at the nodes for g_mn. See ref/elastic_nip/README.md, Contacts without friction.
class ChebyshevSystem {
 public:
  ChebyshevSystem(Float half_length, int size, SmoothKernel& kernel);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const Float& half_length() const { return half_length_; }
  /// cos(k pi/(4n)).
  [[nodiscard]] const Cosines& cosines() const { return cosines_; }
  /// [J(A (t_i - t_j)) - J(A (t_i + t_j))]/2, to kernel_error() and what rounding the arguments does.
  [[nodiscard]] const Float& odd_part(int i, int j) const { return odd_part_[place(i, j)]; }
  [[nodiscard]] const Float& kernel_error() const { return kernel_error_; }

  /// c_0 .. c_{n-1} to about the working precision.
  [[nodiscard]] Vector solution() const;

 private:
  [[nodiscard]] static std::size_t place(int i, int j) {
    const auto [low, high] = std::minmax(i, j);
    return static_cast<std::size_t>(high) * static_cast<std::size_t>(high + 1) / 2 +
           static_cast<std::size_t>(low);
  }

  Float half_length_;
  int size_;
  Cosines cosines_;
  std::vector<Float> odd_part_;
  Float kernel_error_;
};

}  // namespace nipref::ref
