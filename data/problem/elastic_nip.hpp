#pragma once
#include <nipref/data/material/elastic.hpp>

namespace nipref::data {

/// An elastic sheet between two identical rigid cylinders, plane strain, any consistent units. (thesis
/// chapters II, V)
struct ElasticNip {
  double roller_radius;    ///< R, > 0, unit of length
  double sheet_thickness;  ///< B = 2b, > 0, unit of length
  ElasticMaterial material;

  [[nodiscard]] double half_thickness() const { return sheet_thickness / 2; }
  /// Throws BadInput unless the values are physical.
  void check() const;
};

}  // namespace nipref::data
