#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {

/// The continuous contact of a nip in multiprecision, elastic or rolling. It is made by converged_for_length() and
/// converged_for_load() of elastic_nip/converged.hpp and viscoelastic_nip/converged.hpp. The tractions are bounded and
/// vanish at both ends: without friction as the square root of the distance, with full friction, where the sheet sticks
/// to the rollers, as its power 1/2 -+ i ln(3 - 4 poisson)/(2 pi). They are polynomials times that power on panels, see
/// internal/tractions.hpp. Inputs are doubles taken exactly; those of a material are the parameters it was made of, if
/// it keeps them. Units as in data. (thesis 2.1-2.6, 5.3, 5.5, 7.6, 7.15, 7.17; continuous form)
///
/// A proven result (ref/README.md, What is proven) has Estimate::proven true. Its bound is at most 10^-digits of the
/// value for lengths, load, indentation and peaks, of the largest value for profiles, and of the largest pressure for
/// shears. The bound is larger where Y is so near an end that the error of a length found for a load counts. All other
/// errors are estimates of about 10^-digits at most of the largest value of their kind, see internal/nip_solution.hpp.
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading (entry) side,
/// unit of length. BadInput unless it is finite, for displacements and strain within 450 thicknesses of the contact.
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
  [[nodiscard]] Estimate peak_shear_position() const;     ///< Y > 0 of largest |q|; BadInput without friction
  /// The places Y >= 0, rising, at which q changes its sign; the first is the middle. Places nearer to the end than
  /// 1e-6 of L/2 are left out. BadInput without friction.
  [[nodiscard]] std::vector<Estimate> shear_zeros() const;
  [[nodiscard]] Estimate pressure(double y) const;                 ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate shear(double y) const;                    ///< the same; 0 also without friction
  [[nodiscard]] Estimate normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0
  [[nodiscard]] Estimate surface_strain(double y) const;           ///< v', dimensionless
  /// Stresses inside the sheet. BadInput unless |Y| is at most 450 sheet thicknesses and the contact at most 80 long.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// The displacements at any depth of a sheet without memory, from the tractions on its faces.
  [[nodiscard]] std::vector<InnerDisplacements> inner_displacements(std::span<const InnerPoint> points) const;
  [[nodiscard]] int unknowns() const;  ///< of the finer solution if there is one, else terms of the proof
  [[nodiscard]] KernelValues kernel_values() const;  ///< numbers of kernel evaluations so far

  struct Parts;  ///< internal/converged_parts.hpp
  explicit ConvergedNip(Parts parts);

 private:
  struct Computed;
  std::shared_ptr<const Computed> parts_;
};

}  // namespace nipref::ref
