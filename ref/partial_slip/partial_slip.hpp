#pragma once
#include <memory>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// Steady rolling of an elastic sheet between two rigid cylinders with Coulomb friction. Where the sheet sticks to the
/// rollers, the strain of its surface is the creep ratio xi. Where it slips, the shear is the friction coefficient
/// times the pressure, against the slip: ref/partial_slip/README.md. The thesis's Cases A and B are the limits.
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading (entry) side,
/// unit of length. It must be finite, for strains and displacements within 450 thicknesses of the contact; else
/// BadInput. Shear acts on the sheet along +Y. All errors are estimates: from 10^-digits of the largest value of the
/// result's kind to a thousand times as much in contacts of several half-thicknesses.
///
/// One object must not be used by two threads at once.
class PartialSlipNip {
 public:
  PartialSlipNip(PartialSlipNip&&) noexcept;
  ~PartialSlipNip();

  [[nodiscard]] Estimate contact_length() const;          ///< L = L1 + L2, unit of length
  [[nodiscard]] Estimate leading_length() const;          ///< L1, on the entry side
  [[nodiscard]] Estimate trailing_length() const;         ///< L2, on the exit side
  [[nodiscard]] Estimate load() const;                    ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;             ///< d0, unit of length
  [[nodiscard]] Estimate leading_displacement() const;    ///< d1 = d0 - L1^2/(2R), unit of length
  [[nodiscard]] Estimate trailing_displacement() const;   ///< d2 = d0 - L2^2/(2R)
  [[nodiscard]] Estimate traction() const;                ///< T = int q dY, force per unit width
  [[nodiscard]] Estimate creep_ratio() const;             ///< xi, dimensionless
  [[nodiscard]] Estimate rolling_resistance() const;      ///< int p Y dY/(W R), dimensionless
  [[nodiscard]] Estimate dissipation() const;             ///< int |q slip| dY, power per width over the speed
  [[nodiscard]] Estimate peak_pressure() const;           ///< unit of stress
  [[nodiscard]] Estimate peak_pressure_position() const;  ///< its Y
  [[nodiscard]] Estimate peak_shear() const;              ///< largest |q|, unit of stress
  [[nodiscard]] Estimate peak_shear_position() const;     ///< its Y
  [[nodiscard]] Estimate pressure(double y) const;        ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate shear(double y) const;           ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate surface_strain(double y) const;  ///< v', dimensionless
  [[nodiscard]] Estimate slip(
      double y) const;  ///< v' - xi: the sheet's velocity along -Y relative to the roller's, over the speed
  [[nodiscard]] Estimate normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0
  /// Y of the zones' boundaries from the leading to the trailing end, both included. Zones shorter than 10^-digits of
  /// the contact are left out.
  [[nodiscard]] std::vector<Estimate> zone_boundaries() const;
  /// For each zone the sign of its shear if it slips, 0 if it sticks.
  [[nodiscard]] std::vector<int> zone_signs() const;
  [[nodiscard]] int unknowns() const;  ///< of the finer solution

  struct Parts;
  explicit PartialSlipNip(std::unique_ptr<const Parts> parts);

 private:
  std::unique_ptr<const Parts> parts_;
};

/// The contact of a given length: > 0, L <= R and 1e-8 <= L/B <= 10; digits: 16 to 30. The friction coefficient must be
/// > 0 and finite, a given traction smaller in size than it times the load. BadInput otherwise, and if the zones are
/// not found, as for many contacts with friction coefficients above 5 or with stick nearly everywhere.
PartialSlipNip partial_slip_for_length(const data::PartialSlipNip& nip, double contact_length, int digits);
/// The contact that carries `load` per unit width, > 0 and finite, with a length as above; BadInput otherwise.
PartialSlipNip partial_slip_for_load(const data::PartialSlipNip& nip, double load, int digits);

}  // namespace nipref::ref
