#pragma once
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>

namespace nipref::ref {

/// A term of a compliance over the instantaneous part of N, as the steadily rolling sheet sees it: with the way
/// (half-thicknesses) that a material point has gone for the time. Dimensionless.
using RollingMemory = ComplianceTerm;

/// The compliances of a steadily rolling sheet.
struct RollingMaterial {
  Float compliance;                   ///< N at once, 1/stress
  std::vector<RollingMemory> normal;  ///< of N, beside 1; none is 0
  Float theta2_at_once;               ///< over that of N
  std::vector<RollingMemory> theta2;
};

/// Errors as of material_compliances().
RollingMaterial rolling_material(const data::ViscoelasticNip& nip);

/// A steadily rolling sheet, whose N has the memory a_i, r_i, and that of its inverse compliance, b_j, s_j, as in
/// ref/viscoelastic_nip/README.md, Rolling contacts.
struct RollingSheet : NipSheet {
  RollingMaterial material;
  std::vector<RollingMemory> inverse;

  explicit RollingSheet(RollingMaterial the_material);
  /// On panels on which all r_i and s_j change little at an end.
  [[nodiscard]] Resolution resolution() const override;
  [[nodiscard]] int unknowns(int terms) const override;
  /// Where memories make the sheet far softer than it is at once, a fluid over a half-thickness.
  [[nodiscard]] int lost_digits() const override;
  /// Relaxation lengths must be from 1e-8 to 1e8 contacts.
  void check(double half_length) const override;
  [[nodiscard]] std::unique_ptr<NipSolution> solved(const Float& half_length,
                                                    std::vector<TractionPanel> panels, double nats,
                                                    SheetKernels& kernels) const override;
  [[nodiscard]] bool grips() const override { return false; }
  [[nodiscard]] bool is_symmetric() const override { return false; }
  [[nodiscard]] const Float& beta() const override { return material.theta2_at_once; }
};

}  // namespace nipref::ref
