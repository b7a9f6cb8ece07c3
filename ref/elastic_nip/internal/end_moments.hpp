#pragma once
#include <vector>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// Moments of w(t) = (1 - t)^a (1 + t)^b, a = 1/2 - i epsilon, b = 1/2 + i epsilon, |t| < 1: how both
/// tractions of a contact with full friction end, epsilon = ln(3 - 4 poisson)/(2 pi).
///
/// Partial integration gives M_k = int w T_k = i^k m_k with real m_k,
///
///     (k + 3) m_{k+1} = 4 epsilon m_k - (k - 3) m_{k-1},    m_0 = 2 (1/4 + epsilon^2) pi/cosh(pi epsilon),
///
/// 3 m_1 = 2 epsilon m_0; derived with respect to a it gives int ln(1 - t) w T_k, of i^{-k} times which the
/// real part e_k follows
///
///     (k + 3) e_{k+1} = 4 epsilon e_k - (k - 3) e_{k-1} + m_{k-1} - m_{k+1},    3 e_1 = 2 epsilon e_0 - m_1,
///
/// e_0 = m_0 [ln 2 + Re psi(3/2 + i epsilon) - psi(3)]. Both solutions fall alike, so that rounding does not
/// grow. U_k = U_{k-2} + 2 T_k takes both to Chebyshev's second kind, as they are kept here.
class EndMoments {
 public:
  /// Of U_0 .. U_{count-1}; 0 <= epsilon < 0.32.
  EndMoments(const Float& epsilon, int count);

  /// i^{-k} int w U_k, k >= -count: U_{-k} = -U_{k-2}.
  [[nodiscard]] const Float& plain(long k) const;
  /// Re i^{-k} int ln(1 - t) w U_k, k >= 0.
  [[nodiscard]] const Float& logarithmic(long k) const { return logarithmic_[static_cast<std::size_t>(k)]; }

 private:
  std::vector<Float> plain_, logarithmic_;
  std::vector<Float> negative_;  ///< k = -1, -2, ...
};

}  // namespace nipref::ref
