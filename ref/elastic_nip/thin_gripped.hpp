#pragma once
#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// Numbers of the contact of an elastic nip with full friction that is so long that only the slowest wave between its
/// gripped faces is felt from end to end.
///
/// Lengths in half-thicknesses, A = L/B half the contact's length, displacements over b^2/(2R), tractions over
/// b/(2RN). Away from the ends pressure and displacements are those of a strip whose faces move by d0 - y^2 and are
/// stretched by the creep v', in closed form, and a wave c cosh(zeta y): 2 zeta is the zero of (3 - 4 poisson) sin x
/// = x, so that zeta is 0.88 at poisson 0.3 and 0.24 at 0.49. All other waves fade at least like e^(-3.7 x). At an
/// end the wave that comes, of size G = c e^(-zeta A)/2, makes one that goes, and with the end of the roller's
/// parabola all numbers of the end are linear in 1, A and G; where both tractions vanish, too,
///
///     G = (q0 + q1 A) z/(1 - r z),    z = e^(-2 zeta A),    creep = a0 + a1 A + G,
///
/// G counted in units of its creep. What r, q and the other coefficients are is read from six shorter contacts, by
/// the expansion of GrippedElasticNip, which are solved once for all lengths. The same holds for the shear at each
/// distance from the end, after the contribution of the other end is subtracted. Nothing is proven: each number is
/// extrapolated from the first five of these contacts and from the last five. The result is the latter, and its error
/// is twice their difference plus an allowance for rounding. (thesis 2.5, 5.5, thin sheets)
struct ThinGrippedNip {
  Estimate load;             ///< W, force per unit width
  Estimate indentation;      ///< d0, unit of length
  Estimate creep_ratio;      ///< (2/L) v(L/2)
  Estimate middle_pressure;  ///< unit of stress
  Estimate peak_shear;       ///< largest |q|, the same
};

/// The smallest L/B for which this extrapolation holds.
inline constexpr double shortest_thin_gripped_nip = 12;
/// For larger ratios the wave decays so slowly that it cannot be separated from the polynomials at these lengths.
inline constexpr double largest_thin_gripped_poisson = 0.499999;

/// Contact of the given length, L/B from 12 to 1e4 and L <= R; poisson at most 0.499999; digits 12 to 21. BadInput
/// otherwise. The first contact for a Poisson's ratio takes five seconds, or fifteen with many digits or close to the
/// limit of poisson.
ThinGrippedNip thin_gripped_nip_of_length(const data::ElasticNip& nip, double contact_length, int digits);

}  // namespace nipref::ref
