#pragma once
#include <memory>
#include <span>
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// The continuous contact of an elastic nip with full friction: the sheet sticks to the rollers, both tractions
/// vanish at the ends, as the power 1/2 -+ i ln(3 - 4 poisson)/(2 pi) of the distance. Expanded in Chebyshev
/// polynomials times that power, see internal/grip_expansion.hpp. Inputs are doubles taken exactly; units as
/// in data::ElasticNip. (thesis 2.2, 2.5, 5.3, 5.5; continuous form)
///
/// Nothing is proven but the kernel values: each result comes by two discretisations, of different numbers of
/// terms, matching points and interpolation nodes; it is that of the finer one, the error twice their
/// distance and an allowance for rounding. They are meant to be below 10^-digits of the value for contact_length,
/// load, indentation, creep_ratio and peaks, of the largest value for profiles.
///
/// Y is the distance from the middle of the nip, finite; BadInput otherwise, and for displacements farther
/// than 450 sheet thicknesses away. One object must not be used by two threads at once.
class GrippedElasticNip {
 public:
  GrippedElasticNip(GrippedElasticNip&&) noexcept;
  ~GrippedElasticNip();

  [[nodiscard]] Estimate contact_length() const;     ///< L, unit of length
  [[nodiscard]] Estimate load() const;               ///< W, force per unit width
  [[nodiscard]] Estimate indentation() const;        ///< d0, unit of length
  [[nodiscard]] Estimate edge_displacement() const;  ///< d1 = d0 - L^2/(8R), unit of length
  [[nodiscard]] Estimate creep_ratio() const;        ///< (2/L) v(L/2)
  [[nodiscard]] Estimate peak_pressure() const;      ///< unit of stress
  [[nodiscard]] Estimate peak_shear() const;         ///< largest |q|, unit of stress
  /// Y > 0 of the largest |q|; and the places Y >= 0, rising, at which q changes its sign, the middle first, those
  /// that are nearer to the end than 1e-6 of L/2 left out. By secants on the slope, on the shear.
  [[nodiscard]] Estimate peak_shear_position() const;
  [[nodiscard]] std::vector<Estimate> shear_zeros() const;
  [[nodiscard]] Estimate pressure(double y) const;                 ///< unit of stress; 0 outside the contact
  [[nodiscard]] Estimate shear(double y) const;                    ///< the same
  [[nodiscard]] Estimate normal_displacement(double y) const;      ///< u, towards the middle plane
  [[nodiscard]] Estimate tangential_displacement(double y) const;  ///< v, relative to Y = 0
  /// Inside the sheet, see InnerStresses; Y within 450 sheet thicknesses.
  [[nodiscard]] std::vector<InnerStresses> inner_stresses(std::span<const InnerPoint> points) const;
  [[nodiscard]] GreatestShear greatest_shear() const;
  /// v', dimensionless: the creep ratio in the contact, outside the slope of the displacement's interpolation.
  [[nodiscard]] Estimate surface_strain(double y) const;
  [[nodiscard]] int terms() const;             ///< of the finer expansion
  [[nodiscard]] long normal_values() const;    ///< of I1, taken so far
  [[nodiscard]] long coupling_values() const;  ///< of I3, taken so far
  [[nodiscard]] long stretch_values() const;   ///< of what I6 has beside I1

 private:
  struct Implementation;
  explicit GrippedElasticNip(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
  friend GrippedElasticNip gripped_for_length(const data::ElasticNip&, double, int);
  friend GrippedElasticNip gripped_for_load(const data::ElasticNip&, double, int);
};

/// Contact of the given length: > 0, L <= R and 1e-8 <= L/B <= 80. digits: 16 to 50. BadInput otherwise, and
/// naming the digits where 1200 terms do not give them, beyond L/B = 20 or so.
GrippedElasticNip gripped_for_length(const data::ElasticNip& nip, double contact_length, int digits);
/// That this solves for: what it costs grows with their square. BadInput likewise.
int gripped_unknowns(const data::ElasticNip& nip, double contact_length, int digits);

/// Contact that carries `load` per unit width, > 0 and finite, with a length and digits as above; BadInput
/// otherwise.
GrippedElasticNip gripped_for_load(const data::ElasticNip& nip, double load, int digits);

}  // namespace nipref::ref
