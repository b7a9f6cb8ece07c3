#pragma once
#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/viscoelastic_nip/internal/pressure.hpp>

namespace nipref::fast {

/// A sheet as a contact of about a given length meets it. A memory that fades within 1e-9 of the contact, or of
/// the half-thickness if that is less, or within a hundredth of the accuracy if that is more, is replaced by its limit: the compliance that it leaves acts at once,
/// amplitude/rate, and later by the way amplitude/rate^2 over the whole compliance, for to first order
/// 1 + (amplitude/rate)/(1 + i k/rate) is a factor and a shift. What is left out beside is of the order of that
/// way over the contact. So the panels need not resolve what double cannot carry.
struct EffectiveSheet {
  double compliance;                 ///< N at once, with what the short memories leave, 1/stress
  ViscoelasticCompliances material;  ///< in units of it: the longer memories
  double softening = 1;              ///< that compliance over N at once without them
  double shift = 0;                  ///< by the short memories of N, half-thicknesses
  double way = 0;                    ///< of that shift in size, with theta2's; 0: no memory is short
  double fade = 0;  ///< the longest in which a short memory fades, 1/Re rate, half-thicknesses
  double swing =
      0;  ///< of short memories with complex rates, their part of the compliance times sqrt(1/|rate|)
  double held = 0;  ///< what theta2's short memories leave, in size, in units of the compliance

  /// The pressure trails by `shift` and no more: there is no longer memory.
  [[nodiscard]] bool is_shifted_only() const { return way > 0 && material.normal.empty(); }
  /// Relative to anything of a contact of this half length (half-thicknesses), several times what is left out.
  [[nodiscard]] double neglected(double half_length) const;
  /// Of the shift, half-thicknesses.
  [[nodiscard]] double neglected_of_shift(double half_length) const;
  /// The same of the pressure, relative to that in the middle, at a distance from the contact's end: it changes
  /// there like a square root and, within the way itself, from the compliance at once to that of the limit; a complex rate
  /// leaves a swing that fades more slowly.
  [[nodiscard]] double neglected_near_end(double half_length, double distance) const;
  /// Of the surface's strain at a distance behind the trailing end, relative to the pressure in the middle: what
  /// theta2's short memories still hold of the pressure that has passed, whose limit holds nothing.
  [[nodiscard]] double neglected_behind(double half_length, double distance) const;
};

/// `functions`: those of the nip's material.
EffectiveSheet effective_sheet(const data::ViscoelasticNip& nip, const data::MaterialFunctions& functions,
                               double half_length, double accuracy);

}  // namespace nipref::fast
