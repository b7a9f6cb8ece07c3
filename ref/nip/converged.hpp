#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {

/// The continuous contact of a nip in multiprecision, elastic or rolling, by converged_for_length() and
/// converged_for_load() of elastic_nip/converged.hpp and viscoelastic_nip/converged.hpp. Pressure is bounded at both ends
/// and, with full friction, where the sheet sticks to the rollers, shear too: both tractions vanish at the ends, as the
/// power 1/2 -+ i ln(3 - 4 poisson)/(2 pi) of the distance, or as its root without friction. Polynomials times that power
/// on panels, see internal/tractions.hpp. Inputs are doubles taken exactly, those that a material was made of where it
/// has them; units as in data. (thesis 2.1-2.6, 5.3, 5.5, 7.6, 7.15, 7.17; continuous form)
///
/// What is proven (ref/README.md, What is proven) has Estimate::proven true and a bound of at most 10^-digits of the value
/// for lengths, load, indentation and peaks, of the largest value for profiles, of the largest pressure for shears; where a
/// length found for a load is not known to so much as the distance of Y from the ends, more. All else has an error that is
/// estimated, see internal/nip_solution.hpp: about 10^-digits at most of the largest value of the result's kind.
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading (entry) side, unit
/// of length; finite, for displacements within 450 sheet thicknesses of the contact; otherwise BadInput.
///
/// One object must not be used by two threads at once.
class ConvergedNip {
 public:
  [[nodiscard]] Estimate contact_length() const;         ///< L = L1 + L2, unit of length
  [[nodiscard]] Estimate leading_length() const;         ///< L1, on the entry side
  [[nodiscard]] Estimate trailing_length() const;        ///< L2, on the exit side; may be negative
  [[nodiscard]] Estimate load() const;                   ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;            ///< d0, unit of length
  [[nodiscard]] Estimate leading_displacement() const;   ///< d1 = d0 - L1^2/(2R), unit of length
  [[nodiscard]] Estimate trailing_displacement() const;  ///< d2 = d0 - L2^2/(2R)
  [[nodiscard]] Estimate rolling_resistance() const;  ///< int p Y dY/(W R), dimensionless; 0 without memory
  /// (v(L1) - v(-L2))/L: mean stretch of the surface in the contact, dimensionless. (thesis 5.16, 7.17)
  [[nodiscard]] Estimate creep_ratio() const;
  [[nodiscard]] Estimate peak_pressure() const;           ///< unit of stress
  [[nodiscard]] Estimate peak_pressure_position() const;  ///< Y; without memory the middle, by symmetry
  [[nodiscard]] Estimate peak_shear() const;              ///< largest |q|, unit of stress; 0 without friction
  /// Y > 0 of the largest |q|; and the places Y >= 0, rising, at which q changes its sign, the middle first, those
  /// that are nearer to the end than 1e-6 of L/2 left out. By secants on the slope, on the shear. BadInput without friction.
  [[nodiscard]] Estimate peak_shear_position() const;
  [[nodiscard]] std::vector<Estimate> shear_zeros() const;
  [[nodiscard]] Estimate pressure(double y) const;                 ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate shear(double y) const;                    ///< the same; 0 without friction
  [[nodiscard]] Estimate normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0
  [[nodiscard]] Estimate surface_strain(double y) const;           ///< v', dimensionless
  /// Inside the sheet, see InnerStresses; Y within 450 sheet thicknesses, the contact at most 80 long.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// normal_displacement and tangential_displacement at any depth, by the tractions; of a sheet without memory.
  [[nodiscard]] std::vector<InnerDisplacements> inner_displacements(std::span<const InnerPoint> points) const;
  [[nodiscard]] int unknowns() const;  ///< of the finer solution, or else the terms of the proof
  [[nodiscard]] KernelValues kernel_values() const;  ///< so far

  struct Parts;  ///< internal/converged_parts.hpp
  explicit ConvergedNip(Parts parts);

 private:
  struct Computed;
  std::shared_ptr<const Computed> parts_;
};

}  // namespace nipref::ref
