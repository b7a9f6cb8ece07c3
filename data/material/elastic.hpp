#pragma once

namespace nipref::data {

/// Isotropic linear elastic material in plane strain.
struct ElasticMaterial {
  double young;    ///< Young's modulus E, > 0, unit of stress
  double poisson;  ///< Poisson's ratio, dimensionless, -1 < poisson <= 1/2

  /// Throws BadInput unless the values are physical.
  void check() const;

  /// Thesis (4.23): theta1 = 1/(2G) = (1 + poisson)/young, unit of 1/stress.
  [[nodiscard]] double theta1() const { return (1 + poisson) / young; }
  /// Thesis (4.23): theta2 = 3/(6K + 2G) = (1 + poisson)(1 - 2 poisson)/young, unit of 1/stress.
  [[nodiscard]] double theta2() const { return (1 + poisson) * (1 - 2 * poisson) / young; }
  /// theta1 + theta2 = 2 (1 - poisson^2)/young: the compliance that multiplies I1/pi in the normal
  /// displacement.
  [[nodiscard]] double normal_compliance() const { return 2 * (1 - poisson) * (1 + poisson) / young; }
};

}  // namespace nipref::data
