#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// The continuous contact of a viscoelastic nip in steady frictionless rolling: pressure bounded at both
/// ends, which makes the place of the contact (its leading and trailing lengths) part of the solution.
/// (thesis 2.1-2.6, 7.6, 7.15, 7.17 as an integral equation with the load started infinitely long ago, not as
/// line loads)
///
/// It is the contact of an elastic sheet with other right-hand sides (viscoelastic_nip/internal/rolling_equations.hpp), so
/// that only the elastic kernel is integrated; short memories are layers in closed form. The number of terms follows from
/// `accuracy`. Every result comes with an estimate of its error (nip/internal/solution.hpp).
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading
/// (entry) side, any finite value, unit of length; otherwise BadInput.
class ConvergedViscoelasticNip {
 public:
  ConvergedViscoelasticNip(ConvergedViscoelasticNip&&) noexcept;
  ~ConvergedViscoelasticNip();

  [[nodiscard]] Estimate contact_length() const;   ///< L = L1 + L2, unit of length
  [[nodiscard]] Estimate leading_length() const;   ///< L1, contact on the entry side, unit of length
  [[nodiscard]] Estimate trailing_length() const;  ///< L2, on the exit side; may be negative, unit of length
  [[nodiscard]] Estimate load() const;             ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;  ///< d0, approach of roller and middle plane, unit of length
  [[nodiscard]] Estimate leading_displacement() const;   ///< d1 = d0 - L1^2/(2R), unit of length
  [[nodiscard]] Estimate trailing_displacement() const;  ///< d2 = d0 - L2^2/(2R), unit of length
  [[nodiscard]] Estimate pressure(double y) const;       ///< unit of stress, 0 outside the contact
  [[nodiscard]] Estimate peak_pressure() const;          ///< unit of stress
  /// Y of its place, unit of length. Its error is that of the pressure's slope there over its curvature; where another
  /// maximum may be the larger one, or an end's, as far as there.
  [[nodiscard]] Estimate peak_pressure_position() const;
  /// int p Y dY/(W R): the coefficient of rolling resistance, dimensionless; error relative to its size, down
  /// to rounding of L/R. (thesis 7.15)
  [[nodiscard]] Estimate rolling_resistance() const;
  /// (v(L1) - v(-L2))/L: mean stretch of the surface in the contact, dimensionless. (thesis 7.17)
  [[nodiscard]] Estimate creep_ratio() const;
  [[nodiscard]] Estimate normal_displacement(
      double y) const;  ///< u, towards the middle plane, unit of length
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0, unit of length
  /// v'(Y), the strain of the surface along the sheet, in the contact and outside, dimensionless. (thesis 2.5)
  [[nodiscard]] Estimate surface_strain(double y) const;
  /// surface_strain(y) - creep_ratio(), less uncertain than the two: what both have in common counts once.
  [[nodiscard]] Estimate slip(double y) const;
  /// Inside the sheet: see InnerStresses.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// Solves with more terms, from which on all results are computed; false where more do not help.
  bool refine();
  [[nodiscard]] Work work() const;  ///< spent so far

 private:
  struct Implementation;
  explicit ConvergedViscoelasticNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
  friend ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip&, double, double);
  friend ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip&, double, double);
};

/// The contact of length L = `contact_length`, unit of length: 1e-8 <= L/B <= 1e4 and L <= R, beyond which
/// the parabola is no circle. accuracy: relative, 1e-13 <= accuracy <= 0.1. BadInput otherwise, naming "nip.material"
/// where the sheet gives way over the contact more than 3e4 times what it does at once.
ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length,
                                              double accuracy);

/// The contact that carries `load` per unit width, > 0 and finite, such that the contact length is as above;
/// BadInput otherwise.
ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip& nip, double load, double accuracy);

}  // namespace nipref::fast
