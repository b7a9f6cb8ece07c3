#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/problem/friction.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// The continuous contact of an elastic nip, pressure bounded at both ends and, with full friction, where the sheet sticks
/// to the rollers, shear too: both tractions vanish at the ends, as the power 1/2 -+ i ln(3 - 4 poisson)/(2 pi) of the
/// distance, or as its root without friction. Polynomials times that power on panels, see nip/internal/tractions.hpp.
/// Inputs are doubles taken exactly; units as in data::ElasticNip. (thesis 2.2, 2.5, 5.3, 5.5; continuous form)
///
/// Errors are estimated, see nip/internal/solved_nip.hpp: below 10^-digits of the value for contact_length, load,
/// indentation, creep_ratio and peaks, of the largest value for profiles. Without friction ProvenElasticNip proves them.
///
/// Y is the distance from the middle of the nip, finite; BadInput otherwise, and for displacements farther
/// than 450 sheet thicknesses from the contact. One object must not be used by two threads at once.
class ConvergedElasticNip {
 public:
  ConvergedElasticNip(ConvergedElasticNip&&) noexcept;
  ~ConvergedElasticNip();

  [[nodiscard]] Estimate contact_length() const;          ///< L, unit of length
  [[nodiscard]] Estimate load() const;                    ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;             ///< d0, unit of length
  [[nodiscard]] Estimate edge_displacement() const;       ///< d1 = d0 - L^2/(8R), unit of length
  [[nodiscard]] Estimate creep_ratio() const;             ///< (2/L) v(L/2)
  [[nodiscard]] Estimate peak_pressure() const;           ///< unit of stress
  [[nodiscard]] Estimate peak_pressure_position() const;  ///< the middle, by symmetry
  [[nodiscard]] Estimate peak_shear() const;              ///< largest |q|, unit of stress
  /// Y > 0 of the largest |q|; and the places Y >= 0, rising, at which q changes its sign, the middle first, those
  /// that are nearer to the end than 1e-6 of L/2 left out. By secants on the slope, on the shear. BadInput without friction.
  [[nodiscard]] Estimate peak_shear_position() const;
  [[nodiscard]] std::vector<Estimate> shear_zeros() const;
  [[nodiscard]] Estimate pressure(double y) const;                 ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate shear(double y) const;                    ///< the same; 0 without friction
  [[nodiscard]] Estimate normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0
  /// Inside the sheet, see InnerStresses; Y within 450 sheet thicknesses, the contact at most 80 long.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// normal_displacement and tangential_displacement at any depth, by the tractions; estimated.
  [[nodiscard]] std::vector<InnerDisplacements> inner_displacements(std::span<const InnerPoint> points) const;
  [[nodiscard]] Estimate surface_strain(double y) const;  ///< v', dimensionless
  [[nodiscard]] int unknowns() const;                     ///< of the finer solution
  [[nodiscard]] long normal_values() const;               ///< of I1, taken so far
  [[nodiscard]] long coupling_values() const;             ///< of I3, taken so far
  [[nodiscard]] long stretch_values() const;              ///< of what I6 has beside I1

 private:
  struct Implementation;
  explicit ConvergedElasticNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
  friend ConvergedElasticNip converged_for_length(const data::ElasticNip&, data::Friction, double, int);
  friend ConvergedElasticNip converged_for_load(const data::ElasticNip&, data::Friction, double, int);
};

/// Contact of the given length: > 0, L <= R and 1e-8 <= L/B <= 1000. digits: 16 to 100. BadInput otherwise, and
/// naming the digits where 1400 unknowns do not give them.
ConvergedElasticNip converged_for_length(const data::ElasticNip& nip, data::Friction friction,
                                         double contact_length, int digits);
/// The number of unknowns that converged_for_length() solves for at first; its cost grows with their square. BadInput
/// likewise.
int elastic_unknowns(const data::ElasticNip& nip, data::Friction friction, double contact_length, int digits);

/// Contact that carries `load` per unit width, > 0 and finite, with a length and digits as above; BadInput
/// otherwise.
ConvergedElasticNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                       int digits);

}  // namespace nipref::ref
