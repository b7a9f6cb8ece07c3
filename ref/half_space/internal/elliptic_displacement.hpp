#pragma once
#include <array>
#include <vector>

#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// The response along all lines of half a turn, interpolated between some lines by polynomials in v. The angle of a
/// line is centre + width sinh(v), from the peak of the compliance, whose singularities are at v = +-i pi/2.
class SmoothLines {
 public:
  /// Y e3 and, if asked for, the rows of G, in the axes along a line, across it and into the half-space.
  using Line = std::vector<ComplexFloat>;

  /// The errors of Y e3 and G are estimated to be about 10^-digits of their sizes: the polynomials are compared with
  /// lines half-way between nodes, and panels of v are halved until both agree. BadInput "surface" if they never do.
  SmoothLines(const WorkingSurface& surface, const PeakOfCompliance& peak, bool with_decay, int digits);

  [[nodiscard]] Float angle(const Float& v) const { return centre_ + width_ * sinh(v); }  ///< radians
  [[nodiscard]] Float slope(const Float& v) const { return width_ * cosh(v); }
  /// v of the line at this angle; angles that differ by half turns are the same line.
  [[nodiscard]] Float v(const Float& angle) const;
  [[nodiscard]] const Float& last() const { return last_; }  ///< v is from -last to last
  [[nodiscard]] Line at(const Float& v) const;

 private:
  /// A panel of v that ends at `right`, with the lines at the Chebyshev points of its polynomial.
  struct Panel {
    Float right;
    std::vector<Float> places;
    std::vector<Line> lines;

    [[nodiscard]] Line at(const Float& v) const;
  };
  template <class Of>
  void add_panels(const Float& left, const Float& right, int digits, const Of& line);

  Float centre_, width_, last_;
  std::vector<Panel> panels_;
};

/// The pressure peak sqrt(1 - (x/a)^2 - (y/b)^2), x along the major axis, whose angle from the motion is in radians.
struct EllipticPressure {
  Float a, b, major, peak;
};

/// A place at the distance x from the centre in the direction psi, in radians, and at a depth below the surface.
struct PlaceInside {
  Float psi, x, depth;
};

/// A displacement along the motion, across it and into the half-space.
struct Displaced {
  std::array<Float, 3> value, error;
};

/// The displacement under the first of two nearly equal pressures, by the double exponential rule between the lines
/// where the integrand has a peak or no derivative. The error is the sum of the differences between the last two levels
/// of the rule and of the difference between both pressures. Derivation: ref/half_space/README.md, Displacements.
Displaced displacement_under(const std::array<EllipticPressure, 2>& pressures, const SmoothLines& lines,
                             const PlaceInside& place, const std::vector<UnitPoint>& nodes, int digits);

}  // namespace nipref::ref
