#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

/// The continuous frictionless contact of an elastic nip, pressure bounded at both ends, with proven bounds:
/// pressure sqrt(1 - t^2) sum_k c_k U_2k(t), t = 2Y/L, the logarithm of I1 acting on it in closed form, the
/// analytic rest by Gauss-Chebyshev from ref::I1. The residual of the coefficients is enclosed in interval
/// arithmetic, for all rows of the infinite system, and divided by a lower bound of its quadratic form; see
/// internal/proven_expansion.hpp. Inputs are doubles taken exactly; units as in data::ElasticNip. (thesis
/// 2.2, 5.3; continuous form)
///
/// Bounds are at most 10^-digits of the value for contact_length, load, indentation and peak_pressure, of the
/// largest value for pressures and displacements elsewhere; where a length found for a load is not known to
/// so much as the distance of Y from the ends, more. Y is the distance from the middle of the nip, finite;
/// BadInput otherwise, and for displacements farther than 450 sheet thicknesses away.
///
/// One object must not be used by two threads at once.
class ProvenElasticNip {
 public:
  ProvenElasticNip(ProvenElasticNip&&) noexcept;
  ~ProvenElasticNip();

  [[nodiscard]] Enclosure contact_length() const;     ///< L, unit of length
  [[nodiscard]] Enclosure load() const;               ///< W, force per unit width
  [[nodiscard]] Enclosure indentation() const;        ///< d0, unit of length
  [[nodiscard]] Enclosure edge_displacement() const;  ///< d1 = d0 - L^2/(8R), unit of length
  [[nodiscard]] Enclosure creep_ratio() const;        ///< (2/L) v(L/2)
  /// Unit of stress. That the pressure is nowhere larger than in the middle is proven for each contact.
  [[nodiscard]] Enclosure peak_pressure() const;
  [[nodiscard]] Enclosure peak_pressure_position() const;           ///< the middle, proven in the same way
  [[nodiscard]] Enclosure pressure(double y) const;                 ///< unit of stress; 0 outside the contact
  [[nodiscard]] Enclosure normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Enclosure tangential_displacement(double y) const;  ///< v, relative to Y = 0
  /// Inside the sheet, see InnerStresses; not proven: what two quadratures differ by and what the coefficients' radius
  /// makes. Y within 450 sheet thicknesses.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// normal_displacement and tangential_displacement at any depth, by the tractions; estimated.
  [[nodiscard]] std::vector<InnerDisplacements> inner_displacements(std::span<const InnerPoint> points) const;
  [[nodiscard]] Enclosure surface_strain(double y) const;  ///< v', dimensionless
  [[nodiscard]] int terms() const;                         ///< of the expansion
  [[nodiscard]] long kernel_values() const;                ///< of I1, taken so far
  [[nodiscard]] long coupling_values() const;              ///< of I3, taken so far

 private:
  struct Implementation;
  explicit ProvenElasticNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
  friend ProvenElasticNip proven_for_length(const data::ElasticNip&, double, int);
  friend ProvenElasticNip proven_for_load(const data::ElasticNip&, double, int);
};

/// Contact of the given length: > 0, L <= R and 1e-8 <= L/B <= 80. digits: 16 to 100. BadInput otherwise, and
/// naming the digits where 2200 terms do not give them: beyond a few sheet thicknesses an expansion over the
/// whole contact needs about L/B (digits + 20) 0.6 of them, and the time grows with their square.
ProvenElasticNip proven_for_length(const data::ElasticNip& nip, double contact_length, int digits);

/// Of its expansion, about: what it costs grows with their square. BadInput likewise.
int proven_terms(const data::ElasticNip& nip, double contact_length, int digits);

/// Contact that carries `load` per unit width, > 0 and finite, with a length and digits as above; BadInput
/// otherwise.
///
/// Only one length does, as the load grows at least with the square of the length: ref/elastic_nip/README.md.
ProvenElasticNip proven_for_load(const data::ElasticNip& nip, double load, int digits);

}  // namespace nipref::ref
