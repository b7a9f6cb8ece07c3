#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// The continuous contact of a viscoelastic nip in steady frictionless rolling, pressure bounded at both ends, in
/// multiprecision. What an elastic sheet would do in the contact follows from the known displacement by the inverse
/// compliance, so that the pressure is that of an elastic contact with other right-hand sides
/// (internal/rolling_solution.hpp), polynomials and an end's root on panels (nip/internal/tractions.hpp). Inputs are
/// doubles taken exactly, those that the material was made of where it has them (data::ViscoelasticMaterial::constants);
/// units as in data::ViscoelasticNip. (thesis 2.1-2.6, 7.6, 7.15, 7.17; continuous form)
///
/// Lengths, load, displacements in the contact, resistance and pressure are proven where the page
/// ref/viscoelastic_nip/README.md, Rolling contacts, says so; what is not has Estimate::proven false and an error that is
/// estimated, see nip/internal/solved_nip.hpp: about 10^-digits at most of the largest value of the result's kind.
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading
/// (entry) side, unit of length; finite, for displacements within 300 sheet thicknesses; otherwise BadInput.
///
/// One object must not be used by two threads at once.
class ConvergedViscoelasticNip {
 public:
  ConvergedViscoelasticNip(ConvergedViscoelasticNip&&) noexcept;
  ~ConvergedViscoelasticNip();

  [[nodiscard]] Estimate contact_length() const;          ///< L = L1 + L2, unit of length
  [[nodiscard]] Estimate leading_length() const;          ///< L1, on the entry side, unit of length
  [[nodiscard]] Estimate trailing_length() const;         ///< L2, on the exit side; may be negative
  [[nodiscard]] Estimate load() const;                    ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;             ///< d0, unit of length
  [[nodiscard]] Estimate leading_displacement() const;    ///< d1 = d0 - L1^2/(2R), unit of length
  [[nodiscard]] Estimate trailing_displacement() const;   ///< d2 = d0 - L2^2/(2R), unit of length
  [[nodiscard]] Estimate rolling_resistance() const;      ///< int p Y dY/(W R), dimensionless
  [[nodiscard]] Estimate peak_pressure() const;           ///< unit of stress
  [[nodiscard]] Estimate peak_pressure_position() const;  ///< Y of its place, unit of length
  [[nodiscard]] Estimate pressure(double y) const;        ///< unit of stress; 0 outside the contact
  /// (v(L1) - v(-L2))/L: mean stretch of the surface in the contact, dimensionless. (thesis 7.17)
  [[nodiscard]] Estimate creep_ratio() const;
  [[nodiscard]] Estimate normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0
  /// Inside the sheet, see InnerStresses; Y within 450 sheet thicknesses, the contact at most 10 long.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// v', dimensionless.
  [[nodiscard]] Estimate surface_strain(double y) const;
  [[nodiscard]] int unknowns() const;          ///< of the finer discretisation
  [[nodiscard]] long normal_values() const;    ///< of I1, taken so far
  [[nodiscard]] long coupling_values() const;  ///< of I3, taken so far

 private:
  struct Implementation;
  explicit ConvergedViscoelasticNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
  friend ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip&, double, int);
  friend ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip&, double, int);
};

/// Contact of the given length: L <= R, 1e-6 <= L/B <= 1000. digits: 16 to 30. BadInput otherwise, naming
/// "nip.material" for rates whose imaginary part is more than 10 times the real one, and for relaxation
/// lengths (speed over rate) below 1e-8 contacts or above 1e8 of them, and naming "digits" where 1400 unknowns do not
/// give them.
ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length,
                                              int digits);
/// The number of unknowns that converged_for_length() solves for at first; its cost grows with their square. BadInput
/// likewise.
int rolling_unknowns(const data::ViscoelasticNip& nip, double contact_length, int digits);

/// Contact that carries `load` per unit width, > 0 and finite, whose length is as above; BadInput otherwise.
ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip& nip, double load, int digits);

}  // namespace nipref::ref
