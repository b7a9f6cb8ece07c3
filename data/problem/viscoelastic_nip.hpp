#pragma once
#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::data {

/// A viscoelastic sheet rolled between two identical rigid cylinders, plane strain, any consistent units.
/// (thesis chapters II, VI, VII)
struct ViscoelasticNip {
  double roller_radius;    ///< R, > 0, unit of length
  double sheet_thickness;  ///< B = 2b, > 0, unit of length
  ViscoelasticMaterial material;
  double speed;  ///< F0 of the sheet, > 0, length/time

  [[nodiscard]] double half_thickness() const { return sheet_thickness / 2; }
  /// Throws BadInput unless the values are physical and theta1 gives way at once.
  void check() const;
};

}  // namespace nipref::data
