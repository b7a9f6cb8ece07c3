#pragma once
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>

namespace nipref::ref {

/// A term of a compliance over the instantaneous part of N, dimensionless. In steady rolling the distance that a
/// material point has travelled, in half-thicknesses, takes the place of the time.
using RollingMemory = ComplianceTerm;

/// The compliances of a steadily rolling sheet.
struct RollingMaterial {
  Float compliance;                   ///< N at once, 1/stress
  std::vector<RollingMemory> normal;  ///< terms of N beside its instantaneous part; none is 0
  Float theta2_at_once;               ///< theta2 at once over N at once
  std::vector<RollingMemory> theta2;
};

/// The errors are those of material_compliances().
RollingMaterial rolling_material(const data::ViscoelasticNip& nip);

/// A steadily rolling sheet. `material.normal` are the a_i, r_i of N and `inverse` the b_j, s_j of its inverse:
/// ref/viscoelastic_nip/README.md, Rolling contacts.
struct RollingSheet : NipSheet {
  RollingMaterial material;
  std::vector<RollingMemory> inverse;

  explicit RollingSheet(RollingMaterial the_material);
  /// The panels at an end are so narrow that e^(-r_i x) and e^(-s_j x) change little on them.
  [[nodiscard]] Resolution resolution() const override;
  [[nodiscard]] int unknowns(int terms) const override;
  /// Digits lost if memories make the sheet far softer than it is at once; a fluid's flow counts over a half-thickness.
  [[nodiscard]] int lost_digits() const override;
  /// BadInput unless relaxation lengths are from 1e-8 to 1e8 contacts.
  void check(double half_length) const override;
  [[nodiscard]] std::unique_ptr<NipSolution> solved(const Float& half_length,
                                                    std::vector<TractionPanel> panels, double nats,
                                                    SheetKernels& kernels) const override;
  [[nodiscard]] bool sticks() const override { return false; }
  [[nodiscard]] bool is_symmetric() const override { return false; }
  [[nodiscard]] const Float& beta() const override { return material.theta2_at_once; }
};

}  // namespace nipref::ref
