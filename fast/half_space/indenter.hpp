#pragma once
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/response.hpp>

namespace nipref::fast {

/// A smooth rigid body at the point where it touches the plane: x3 = (curvature_1 x1^2 + curvature_2 x2^2)/2,
/// both > 0 and finite, 1/length.
struct Indenter {
  double curvature_1, curvature_2;

  /// Unit of length: that of the radius.
  static Indenter sphere(double radius) { return {1 / radius, 1 / radius}; }

  /// The ellipsoid C1 x1^2 + C2 x2^2 + C3 (x3 + 1/sqrt(C3))^2 = 1. (brock2012 19, 20)
  static Indenter ellipsoid(double c1, double c2, double c3) {
    return {c1 / std::sqrt(c3), c2 / std::sqrt(c3)};
  }

  [[nodiscard]] double curvature(Direction along) const {
    return curvature_1 * along.cosine * along.cosine + curvature_2 * along.sine * along.sine;
  }

  /// Throws BadInput naming the curvature outside its domain.
  void check() const {
    for (const double value : {curvature_1, curvature_2})
      if (!(value > 0) || !std::isfinite(value))
        throw data::BadInput("curvature", value, "must be positive and finite");
  }
};

}  // namespace nipref::fast
