#pragma once
#include <gmpxx.h>

#include <cmath>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

inline mpq_class exactly(double x) { return Exact(x).value(); }

/// Units of the dimensionless contact, and what else the nip is, as rational numbers.
struct NipUnits {
  mpq_class length;        ///< b
  mpq_class slope;         ///< b/(2R)
  mpq_class displacement;  ///< b^2/(2R)
  mpq_class pressure;      ///< b/(2 R N)
  mpq_class beta;          ///< theta2/N

  explicit NipUnits(const data::ElasticNip& nip)
      : length(exactly(nip.sheet_thickness) / 2),
        slope(length / (2 * exactly(nip.roller_radius))),
        displacement(slope * length) {
    const mpq_class poisson = exactly(nip.material.poisson);
    pressure = slope * exactly(nip.material.young) / (2 * (1 - poisson) * (1 + poisson));
    beta = (1 - 2 * poisson) / (2 * (1 - poisson));
  }
};

/// A guess at the half length that carries a load without friction, good to a tenth, between that of a
/// half-space and that of springs; dimensionless.
inline double guessed_half_length(double load) {
  double length = std::sqrt(load / 3.14159);
  for (int i = 0; i < 5; ++i) length = std::sqrt(load / (3.14159 + 8 * length / 3));
  return length;
}

}  // namespace nipref::ref
