#pragma once
#include <vector>

#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// Integrals of t^m T_k(2t - 1) over 0 <= t <= 1, alone and times what is singular at x: m is 0, or 1/2 - i epsilon at an end.
/// They follow from each other: ref/nip/README.md, Tractions on panels. Those of 1/(x - t), principal values, are C_{k+1} =
/// 2 (2x - 1) C_k - C_{k-1} - 4 int t^m T_k, with more digits beyond the ends, where the other solution of that grows.
class SingularIntegrals {
 public:
  /// Of k < count. Without x only plain(); with x = 0 or 1 not inverse(), which is infinite, and with x = 1 logarithm() only if m
  /// is 0.
  SingularIntegrals(const ComplexFloat& m, int count);
  SingularIntegrals(const ComplexFloat& m, const Float& x, int count);

  [[nodiscard]] const ComplexFloat& plain(long k) const { return plain_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] const ComplexFloat& logarithm(long k) const {
    return logarithm_[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] const ComplexFloat& sign(long k) const { return sign_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] const ComplexFloat& inverse(long k) const { return inverse_[static_cast<std::size_t>(k)]; }

 private:
  std::vector<ComplexFloat> plain_, logarithm_, sign_, inverse_;
};

}  // namespace nipref::ref
