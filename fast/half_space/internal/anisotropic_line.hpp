#pragma once
#include <array>
#include <complex>
#include <optional>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/fast/half_space/internal/impedance.hpp>
#include <nipref/fast/half_space/internal/line_limits.hpp>
#include <nipref/fast/half_space/response.hpp>

namespace nipref::fast::internal {

/// Throws BadInput "solid" if the condition number of Voigt's matrix is too large for the precision of two words.
void check_moduli(const data::Stiffness& solid);

/// The response of a half-space of any anisotropy along a line: the real and imaginary parts of the third row of the
/// inverse impedance in the axes of the line, and the diagonal of the latter.
struct AnisotropicAnswers {
  LineResponse normal;
  ShearResponse shear;
};

/// Responses by Stroh's formalism, in two words throughout (impedance.hpp). A line is subcritical, that is, below its
/// limiting speed and below the speed of Rayleigh waves, exactly if its impedance is positive definite.
class AnisotropicLine final : public LineLimits {
 public:
  explicit AnisotropicLine(const data::Stiffness& solid);

  /// Returns nothing if the line is not subcritical.
  [[nodiscard]] std::optional<AnisotropicAnswers> at(Direction psi, const Motion& motion) const;
  /// The matrix G, in the axes along the line, across it and down, with which a wave e^{ikx} along the line decays with
  /// depth as e^{-Gkz}. Returns nothing if the line is not below its limiting speed.
  [[nodiscard]] std::optional<Square<std::complex<double>, 3>> decay(Direction psi,
                                                                     const Motion& motion) const;
  /// An upper bound of the speed of plane waves along the line, from the largest row sum of Christoffel's matrix.
  [[nodiscard]] double wave_bound(Direction psi) const;
  [[nodiscard]] double limit(Direction psi) const override;
  [[nodiscard]] Two limit_in_two_words(Direction psi) const override;

 private:
  using Block = Square<Two, 3>;
  [[nodiscard]] StrohBlocks blocks(Direction psi) const;
  /// A lower bound of the limit whose relative error is at most `share`.
  [[nodiscard]] Two limit_within(Direction psi, double share) const;

  double inverse_unit_;    ///< inverse of the unit of the moduli, a power of two
  double density_;         ///< density over that unit
  Block c11_, c12_, c22_;  ///< C_i1k1, C_i1k2 + C_i2k1, C_i2k2
  Block c13_, c23_;        ///< C_i1k3, C_i2k3
  Block t_inverse_;        ///< inverse of C_i3k3
};

}  // namespace nipref::fast::internal
