#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// The continuous contact of an elastic nip: pressure bounded at both ends and, with full friction, shear
/// too, which makes the creep an unknown with one value. (thesis 2.1-2.6, 5.3, 5.5 as integral equations, not
/// as line loads)
///
/// Up to L/B = 3 the tractions are one expansion over the whole contact, beyond on panels that double from both ends, with
/// the end exponent 1/2 - i ln(3 - 4 poisson)/(2 pi) of the coupled problem (nip/internal/tractions.hpp). The number of
/// terms follows from `accuracy`. Every result is computed when it is asked for, and comes with an estimate of its error
/// that covers what the expansions leave out and what rounding does (nip/internal/solution.hpp); with a given load also
/// what that does to the length. Where rounding allows less than was asked (very thin sheets with full friction), the
/// estimate says so.
///
/// Y is the distance along the sheet from the middle of the nip, any finite value, unit of length; otherwise
/// BadInput.
class ConvergedElasticNip {
 public:
  ConvergedElasticNip(ConvergedElasticNip&&) noexcept;
  ~ConvergedElasticNip();

  [[nodiscard]] Estimate contact_length() const;  ///< L, unit of length
  [[nodiscard]] Estimate load() const;            ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;     ///< d0, approach of roller and middle plane, unit of length
  [[nodiscard]] Estimate edge_displacement() const;  ///< d1 = d0 - L^2/(8R), unit of length
  /// v'(Y) inside the contact, which is constant, with full friction; without friction (2/L) v(L/2), the only
  /// one of these numbers that costs tangential kernels then. Dimensionless. (thesis 5.5, 5.16)
  [[nodiscard]] Estimate creep_ratio() const;
  [[nodiscard]] Estimate pressure(double y) const;  ///< unit of stress, 0 outside the contact
  [[nodiscard]] Estimate shear(
      double y) const;  ///< along Y on the sheet; 0 outside the contact and without friction
  [[nodiscard]] Estimate peak_pressure() const;  ///< unit of stress
  [[nodiscard]] Estimate peak_shear() const;     ///< largest magnitude, unit of stress
  /// Y of the largest pressure: the middle, by symmetry (in all contacts tried it falls from there outwards).
  [[nodiscard]] Estimate peak_pressure_position() const { return {0, 0}; }
  /// Y > 0 of the largest magnitude of the shear, unit of length; with full friction, otherwise BadInput. Its error is
  /// that of the shear's slope there over its curvature; where two maxima are the same to their errors, their distance.
  [[nodiscard]] Estimate peak_shear_position() const;
  /// Places Y >= 0, rising, at which the shear changes its sign, of which the middle is the first; with full friction,
  /// otherwise BadInput. Each is sure: the shear is larger than its error on both sides. Next to an end there are more
  /// and more of them, in a geometric progression: those that are less than 1e-6 of L/2 from it are left out.
  [[nodiscard]] std::vector<Estimate> shear_zeros() const;
  [[nodiscard]] Estimate normal_displacement(
      double y) const;  ///< u, towards the middle plane, unit of length
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0, unit of length
  /// v'(Y), the strain of the surface along the sheet, inside the contact and outside, dimensionless: without friction
  /// (N/pi) int I3' p less theta2 p, of which with full friction the creep ratio is left in the contact and outside
  /// N/2 times the stress along the face. (thesis 2.5)
  [[nodiscard]] Estimate surface_strain(double y) const;
  /// surface_strain(y) - creep_ratio(), less uncertain than the two: what both have in common counts once. 0 in a contact
  /// with full friction.
  [[nodiscard]] Estimate slip(double y) const;
  /// Inside the sheet: see InnerStresses.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// normal_displacement and tangential_displacement at any depth.
  [[nodiscard]] std::vector<InnerDisplacements> inner_displacements(std::span<const InnerPoint> points) const;
  /// Solves with more terms, from which on all results are computed; false where more do not help.
  bool refine();
  [[nodiscard]] Work work() const;  ///< spent so far

 private:
  struct Implementation;
  explicit ConvergedElasticNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
  friend ConvergedElasticNip converged_for_length(const data::ElasticNip&, data::Friction, double, double);
  friend ConvergedElasticNip converged_for_load(const data::ElasticNip&, data::Friction, double, double);
};

/// The contact of length L = `contact_length`, unit of length: 1e-8 <= L/B <= 1e4 and L <= R, beyond which
/// the parabola is no circle. accuracy: relative, 1e-13 <= accuracy <= 0.1. BadInput otherwise.
ConvergedElasticNip converged_for_length(const data::ElasticNip& nip, data::Friction friction,
                                         double contact_length, double accuracy);

/// The contact that carries `load` per unit width, > 0 and finite, such that the contact length is as above;
/// BadInput otherwise.
ConvergedElasticNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                       double accuracy);

}  // namespace nipref::fast
