#pragma once
#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/viscoelastic_nip/internal/pressure.hpp>

namespace nipref::fast {

/// The sheet in which a contact of about a given length is solved: memories too short for double to resolve are replaced by
/// their limit. A memory is short if its relaxation length is below 1e-9, or below a hundredth of the accuracy if that is
/// more, of the contact or of the half-thickness, whichever is less. Its transform 1 + (amplitude/rate)/(1 + i k/rate) is to
/// first order in k a factor and a shift: the compliance amplitude/rate acts at once, and the pressure trails by the
/// length amplitude/rate^2 over the whole compliance. The relative error of this limit is of the order of that length over
/// the contact.
struct EffectiveSheet {
  double compliance;                 ///< N at once, that of the short memories included, 1/stress
  ViscoelasticCompliances material;  ///< the longer memories, in units of `compliance`
  double softening = 1;              ///< `compliance` over N at once without the short memories
  double shift = 0;                  ///< of the pressure, by the short memories of N, half-thicknesses
  double shift_size = 0;    ///< sum of the sizes of all shifts, theta2's included; 0: no memory is short
  double decay_length = 0;  ///< the largest 1/Re rate of a short memory, half-thicknesses
  double oscillation =
      0;  ///< sum over short memories with complex rates: part of the compliance/sqrt(|rate|)
  double residual_strain =
      0;  ///< sum of the sizes of amplitude/rate of theta2's short memories over `compliance`

  /// The pressure trails by `shift` and no more: there is no longer memory.
  [[nodiscard]] bool is_shifted_only() const { return shift_size > 0 && material.normal.empty(); }
  /// Several times the relative error of the limit, of anything of a contact of this half length (half-thicknesses).
  [[nodiscard]] double neglected(double half_length) const;
  /// The error of the shift, half-thicknesses.
  [[nodiscard]] double neglected_of_shift(double half_length) const;
  /// The error of the pressure at a distance from the contact's end, relative to the pressure in the middle. It grows
  /// towards the end, where the pressure changes like a square root; within the shift's length the compliance changes from
  /// the instantaneous one to that of the limit. Complex rates add an oscillation that decays more slowly.
  [[nodiscard]] double neglected_near_end(double half_length, double distance) const;
  /// The error of the surface's strain at a distance behind the trailing end, relative to the pressure in the middle:
  /// theta2's short memories still remember the pressure that has passed, their limit does not.
  [[nodiscard]] double neglected_behind(double half_length, double distance) const;
};

/// `functions`: those of the nip's material.
EffectiveSheet effective_sheet(const data::ViscoelasticNip& nip, const data::MaterialFunctions& functions,
                               double half_length, double accuracy);

}  // namespace nipref::fast
