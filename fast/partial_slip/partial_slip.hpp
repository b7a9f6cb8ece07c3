#pragma once
#include <memory>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// Steady rolling of an elastic sheet with Coulomb's friction: |q| <= mu p; the surface's strain is the creep ratio where
/// it sticks, q = mu p sign(v' - creep ratio) where it slips. Pressure and shear are bounded at the ends and at all
/// boundaries of stick and slip. The contact is not symmetric. (no seed; between thesis 2.2's two cases)
///
/// Y as for ConvergedNip: from the line through the rollers' centres, positive on the leading (entry) side, any finite
/// value, unit of length; otherwise BadInput. Shears act on the sheet along Y.
///
/// Errors: the contact is solved by three discretisations (internal/zone_mesh.hpp), the last with an error some twenty times
/// smaller, the first two unlike in the sign of what is left at boundaries where slip turns into stick. A number J is that of
/// the last. Its error is |J_3 - J_1| and, as these may agree by chance, the largest difference of numbers of its kind from
/// either: relative, of the contact's length, place, load, traction and creep, times the size of numbers like J; for
/// tractions, the largest at the 16 samples next to Y, and what so large an error of Y makes; for boundaries where slip turns
/// into stick, over the longer of their zones. To these come what is of the second order in the differences of boundaries, and
/// the rounding of sums and of places. Zones that are too short to be found are left out. By how much conditions of stick and
/// slip are not met, relative, adds in the mean to the error of the whole. Where a zone is known to be missing the contact may
/// be any other: twice that part of the contact, times mu if that is above 1, adds to the error of the whole; pressures there
/// may be off by the mean pressure, shears by friction's both ways, what is at a distance d by the part's length over d, and
/// boundaries beside by the shorter zone.
class PartialSlipNip {
 public:
  PartialSlipNip(PartialSlipNip&&) noexcept;
  ~PartialSlipNip();

  [[nodiscard]] Estimate contact_length() const;   ///< L = L1 + L2, unit of length
  [[nodiscard]] Estimate leading_length() const;   ///< L1, on the entry side, unit of length
  [[nodiscard]] Estimate trailing_length() const;  ///< L2, on the exit side, unit of length
  [[nodiscard]] Estimate load() const;             ///< W, force per unit width
  [[nodiscard]] Estimate traction() const;         ///< T = int q dY, force per unit width, |T| < mu W
  [[nodiscard]] Estimate indentation() const;  ///< d0, approach of roller and middle plane, unit of length
  [[nodiscard]] Estimate leading_displacement() const;   ///< d1 = d0 - L1^2/(2R), unit of length
  [[nodiscard]] Estimate trailing_displacement() const;  ///< d2 = d0 - L2^2/(2R), unit of length
  [[nodiscard]] Estimate creep_ratio() const;            ///< v' where it sticks, dimensionless
  [[nodiscard]] Estimate rolling_resistance() const;     ///< int p Y dY/(W R), dimensionless
  /// int |q (v' - creep ratio)| dY: heat per width over the speed, force per unit width. It is creep_ratio() traction() times
  /// -1 and load() rolling_resistance(): what the rollers' torques put in.
  [[nodiscard]] Estimate dissipation() const;
  [[nodiscard]] Estimate peak_pressure() const;           ///< unit of stress
  [[nodiscard]] Estimate peak_pressure_position() const;  ///< Y of it
  [[nodiscard]] Estimate peak_shear() const;              ///< largest |q|, unit of stress
  [[nodiscard]] Estimate peak_shear_position() const;     ///< Y of it, likewise
  /// The contact's ends and the boundaries of its zones, from the leading end on: one number more than zone_signs(). Unit
  /// of length.
  [[nodiscard]] std::vector<Estimate> zone_boundaries() const;
  /// Of the shear along Y in zones of slip; 0 where it sticks.
  [[nodiscard]] std::vector<int> zone_signs() const;
  [[nodiscard]] Estimate pressure(double y) const;  ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate shear(double y) const;     ///< unit of stress; 0 outside the contact
  /// v'(Y) of the surface, in the contact and outside, dimensionless, and the same less the creep ratio.
  [[nodiscard]] Estimate surface_strain(double y) const;
  [[nodiscard]] Estimate slip(double y) const;
  [[nodiscard]] Estimate normal_displacement(
      double y) const;  ///< u, towards the middle plane, unit of length
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0, unit of length
  /// Solves with more unknowns, from which on all results are computed; false where the most are reached.
  bool refine();
  [[nodiscard]] Work work() const;  ///< systems and unknowns, with those of the search for the zones

  struct Implementation;
  explicit PartialSlipNip(std::unique_ptr<Implementation> implementation);

 private:
  std::unique_ptr<Implementation> nip_;
};

/// The contact of length L, 1e-8 <= L/B <= 10 and L <= R; accuracy: relative, 1e-13 <= accuracy <= 0.1, of the length, the
/// load and the creep: boundaries of zones are less sure. BadInput otherwise, for a friction coefficient that is not positive
/// and finite, for a traction that friction cannot pass on, and where no zones of stick and slip are found that meet all
/// conditions, as of friction below 1e-7 and of many contacts in which theta2/N times friction is above 2. With a traction
/// several loads may have contacts of one length; this is one of them.
PartialSlipNip partial_slip_for_length(const data::PartialSlipNip& nip, double contact_length,
                                       double accuracy);

/// The contact that carries `load` per unit width, > 0 and finite, with a length as above; BadInput otherwise.
PartialSlipNip partial_slip_for_load(const data::PartialSlipNip& nip, double load, double accuracy);

}  // namespace nipref::fast
