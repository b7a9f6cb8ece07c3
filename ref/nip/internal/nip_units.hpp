#pragma once
#include <gmpxx.h>

namespace nipref::ref {

/// Units of the dimensionless contact, exactly.
struct NipUnits {
  mpq_class length;        ///< b
  mpq_class slope;         ///< b/(2R)
  mpq_class displacement;  ///< b^2/(2R)
  mpq_class pressure;      ///< b/(2 R N), N at once
  mpq_class force;         ///< b^2/(2 R N)

  NipUnits(double roller_radius, double sheet_thickness, const mpq_class& compliance)
      : length(mpq_class(sheet_thickness) / 2),
        slope(length / (2 * mpq_class(roller_radius))),
        displacement(slope * length),
        pressure(slope / compliance),
        force(pressure * length) {}
};

}  // namespace nipref::ref
