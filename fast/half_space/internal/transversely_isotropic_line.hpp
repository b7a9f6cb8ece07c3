#pragma once
#include <optional>
#include <variant>

#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/internal/line_limits.hpp>
#include <nipref/fast/half_space/response.hpp>

namespace nipref::fast::internal {

// The response of a transversely isotropic half-space along one line, with moduli and reciprocal responses in one unit.
// Numbers have two words, so that cancellation near a branch point or near the Rayleigh speed does not affect the
// results in double. X is density c_X^2 for the speed c_X along the line, times the square of the length of psi, since
// after rounding the length of a Direction is only nearly 1.

/// The responses times `rayleigh`, which vanishes at the Rayleigh speed. They are valid only if `rayleigh` is positive:
/// then the load is slower along the line than all bulk and Rayleigh waves.
struct LineFunctions {
  Two rayleigh;
  Two compliance;
  Two coupling;                ///< to shear along the line
  double coupling_across = 0;  ///< to shear across the line

  [[nodiscard]] bool subcritical() const { return rayleigh.high > 0; }
};

/// The axis of symmetry is normal to the surface: all lines are alike. (brock2013 19, 25b)
class NormalAxisLine {
 public:
  explicit NormalAxisLine(const data::TransverselyIsotropicSolid& solid);
  [[nodiscard]] LineFunctions at(Direction psi, Two X) const;
  /// X of the shear wave: a bound for subcritical lines.
  [[nodiscard]] double bound(Direction psi) const;

 private:
  double d1_, d3_, d5_, d13_;
  Two determinant_;  ///< d1 d3 - d13^2
  Two sum_;          ///< |d5 + d13|
  Two root3_, root5_;
};

/// The axis of symmetry is the direction x2 of the surface. (brock2013 43, 44, corrected)
class InPlaneAxisLine {
 public:
  explicit InPlaneAxisLine(const data::TransverselyIsotropicSolid& solid);
  [[nodiscard]] LineFunctions at(Direction psi, Two X) const;
  /// X of the wave polarised across the axis: a bound for subcritical lines.
  [[nodiscard]] double bound(Direction psi) const;

 private:
  double d2_, d5_, d6_;
  Two inverse1_, inverse5_, inverse6_;
  Two sum_over_d1_;  ///< (d6 + d12)/d1
  Two coupling_;     ///< (d6 + d12)^2/(d1 d6)
};

/// A line for either axis, in the units of the solid.
class TransverselyIsotropicLine final : public LineLimits {
 public:
  TransverselyIsotropicLine(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis);

  /// Returns nothing if the line is not subcritical.
  [[nodiscard]] std::optional<LineResponse> at(Direction psi, const Motion& motion) const;

  /// d ln K/d ln speed on a subcritical line.
  [[nodiscard]] double condition(Direction psi, const Motion& motion) const;

  [[nodiscard]] double limit(Direction psi) const override;
  [[nodiscard]] Two limit_in_two_words(Direction psi) const override;

 private:
  [[nodiscard]] LineFunctions functions(Direction psi, Two X) const;
  [[nodiscard]] bool is_subcritical(Direction psi, Two speed) const;

  double inverse_unit_;  ///< of the moduli, a power of two: no modulus is rounded, no product overflows
  double density_;       ///< density of the solid over that unit
  std::variant<NormalAxisLine, InPlaneAxisLine> line_;
};

}  // namespace nipref::fast::internal
