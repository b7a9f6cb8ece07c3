#pragma once
#include <array>
#include <optional>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/fast/half_space/internal/line_limits.hpp>

namespace nipref::fast::internal {

/// What a half-space of any anisotropy answers along a line, 1/stress: real and imaginary parts of the third row of
/// the inverse impedance in the axes of the line, and the diagonal.
struct AnisotropicAnswers {
  double compliance;
  double coupling, coupling_across;
  double shear_compliance, shear_compliance_across;
  double in_line, across;
};

/// Two words throughout. Stroh's matrix N has the eigenvalues p and 1/i times its sign, the matrix with the same
/// eigenvectors and eigenvalues i where Im p > 0, is found by Newton's iteration X -> (X - 1/X)/2: degenerate
/// solids need no care, and lines that are not slower than their limiting speed, where p are real, make it wander. The
/// blocks S, H of the sign are Barnett and Lothe's, the impedance is M = H^-1 (1 + i S): slower than that and than
/// Rayleigh waves are the lines for which M is positive definite, which is so until its determinant vanishes.
class AnisotropicLine final : public LineLimits {
 public:
  explicit AnisotropicLine(const data::Stiffness& solid);

  /// Nothing if the line is not subcritical.
  [[nodiscard]] std::optional<AnisotropicAnswers> at(Direction psi, const Motion& motion) const;
  [[nodiscard]] double limit(Direction psi) const override;
  [[nodiscard]] Two limit_in_two_words(Direction psi) const override;

  using Block = std::array<std::array<Two, 3>, 3>;

 private:
  /// Q at rest and R of the unit vector along psi.
  struct Blocks {
    Block q, r;
  };
  [[nodiscard]] Blocks blocks(Direction psi) const;
  /// The limit less no more than a share of it.
  [[nodiscard]] Two limit_within(Direction psi, double share) const;

  double inverse_unit_;    ///< of the moduli, a power of two
  double density_;         ///< over that unit
  Block c11_, c12_, c22_;  ///< C_i1k1, C_i1k2 + C_i2k1, C_i2k2
  Block c13_, c23_;        ///< C_i1k3, C_i2k3
  Block t_inverse_;        ///< of C_i3k3
};

}  // namespace nipref::fast::internal
