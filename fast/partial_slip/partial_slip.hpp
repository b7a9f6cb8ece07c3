#pragma once
#include <memory>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// Steady rolling of an elastic sheet with Coulomb's friction, |q| <= mu p. Where the sheet sticks, the strain of the
/// surface is the creep ratio; where it slips, q = mu p sign(v' - creep ratio). Pressure and shear are bounded at ends
/// and boundaries of stick and slip. The contact is not symmetric. (no seed; between thesis 2.2's two cases)
///
/// Y as for ConvergedNip: from the line through the rollers' centres, positive on the leading (entry) side, any finite
/// value, unit of length; otherwise BadInput. Shears act on the sheet along Y.
///
/// Error estimates. The contact is solved by three discretisations (internal/zone_mesh.hpp), each with an error that
/// is at most e^-2 of that of the one before. A number J is that of the last. Its error is |J_3 - J_2| and, because
/// these may agree by chance, the error of the whole, times the size of numbers like J. This is the relative difference
/// of the contact's length, place, load, traction or creep: the largest between the last and the second, or between the
/// last and the first as much smaller as the second's error is. For tractions the difference of both at the 16 samples
/// next to Y is added, and the effect of such an error of Y; for boundaries where slip turns into stick, which are the
/// least accurate ones, such a difference over the longer of their zones. Terms of second order in the differences of
/// boundaries and the rounding of sums and places are added. Zones that are too short to be found are left out. The
/// mean violation of the conditions of stick and slip, relative, adds to the error of the whole. Where a zone is known
/// to be missing, the contact may be any other: twice the share of this part, times mu if mu > 1, adds to the error of
/// the whole. There pressures may be wrong by the mean pressure and shears by friction in both directions; at a
/// distance d the relative error is the part's length over d; boundaries beside may be wrong by the length of the
/// shorter zone.
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
  /// int |q (v' - creep ratio)| dY: heat per width over the speed, force per unit width. It equals the work of the
  /// rollers' torques per distance, load() rolling_resistance() - creep_ratio() traction().
  [[nodiscard]] Estimate dissipation() const;
  [[nodiscard]] Estimate peak_pressure() const;           ///< unit of stress
  [[nodiscard]] Estimate peak_pressure_position() const;  ///< Y of the largest pressure, unit of length
  [[nodiscard]] Estimate peak_shear() const;              ///< largest |q|, unit of stress
  [[nodiscard]] Estimate peak_shear_position() const;     ///< Y of the largest |q|, unit of length
  /// Y of the ends and of the boundaries of zones, from the leading end on, unit of length: one more than zone_signs().
  [[nodiscard]] std::vector<Estimate> zone_boundaries() const;
  /// The signs of the shear along Y in zones of slip; 0 in zones of stick.
  [[nodiscard]] std::vector<int> zone_signs() const;
  [[nodiscard]] Estimate pressure(double y) const;  ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate shear(double y) const;     ///< unit of stress; 0 outside the contact
  /// v'(Y) of the surface, in the contact and outside, and v'(Y) less the creep ratio; dimensionless.
  [[nodiscard]] Estimate surface_strain(double y) const;
  [[nodiscard]] Estimate slip(double y) const;
  [[nodiscard]] Estimate normal_displacement(
      double y) const;  ///< u, towards the middle plane, unit of length
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0, unit of length
  /// Solves with more unknowns, on which all later results rest. Returns false if rounding dominates or this fails.
  bool refine();
  [[nodiscard]] Work work() const;  ///< systems and unknowns, with those of the search for the zones

  struct Implementation;
  explicit PartialSlipNip(std::unique_ptr<Implementation> implementation);

 private:
  std::unique_ptr<Implementation> nip_;
};

/// The contact of length L = `contact_length`, unit of length, 1e-8 <= L/B <= 10 and L <= R; accuracy: relative, from
/// 1e-13 to 0.1, of the length, the load and the creep; boundaries of zones are less accurate. BadInput otherwise, for
/// a friction coefficient that is not positive and finite, for a traction that friction cannot transmit, and if no
/// zones of stick and slip are found that meet all conditions, as with friction below 1e-7 and in many contacts with
/// theta2/N times friction above 2. With a traction several loads may give this length; the result is one of them.
PartialSlipNip partial_slip_for_length(const data::PartialSlipNip& nip, double contact_length,
                                       double accuracy);

/// The contact that carries `load` per unit width, > 0 and finite, with a length as above; BadInput otherwise.
PartialSlipNip partial_slip_for_load(const data::PartialSlipNip& nip, double load, double accuracy);

}  // namespace nipref::fast
