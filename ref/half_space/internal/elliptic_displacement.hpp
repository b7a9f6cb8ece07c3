#pragma once
#include <array>
#include <vector>

#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// All lines of half a turn from some of them, by polynomials in v, where the angle of a line is centre + width sinh(v), from the
/// peak of the compliance: its singularities about the peak are at v = +-i pi/2.
class SmoothLines {
 public:
  /// Y e3 and, if asked for, the rows of G, in the axes along a line, across it and into the half-space.
  using Line = std::vector<ComplexFloat>;

  /// Y e3 and G each have an error of about 10^-digits of their size, which is estimated: the polynomials are compared with
  /// the lines half-way between those from which they are made, and panels of v are halved until both agree. BadInput
  /// "surface" where they never do.
  SmoothLines(const WorkingSurface& surface, const PeakOfCompliance& peak, bool with_decay, int digits);

  [[nodiscard]] Float angle(const Float& v) const { return centre_ + width_ * sinh(v); }  ///< radians
  [[nodiscard]] Float slope(const Float& v) const { return width_ * cosh(v); }
  /// Of the line at this angle, or turned by half turns.
  [[nodiscard]] Float v(const Float& angle) const;
  [[nodiscard]] const Float& last() const { return last_; }  ///< v is from -last to last
  [[nodiscard]] Line at(const Float& v) const;

 private:
  /// The lines at count + 1 Chebyshev points up to `right`.
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

/// A place at the distance x from the centre, in the direction psi, in radians, below the surface if the depth is not 0.
struct PlaceInside {
  Float psi, x, depth;
};

/// Along the motion, across it and into the half-space.
struct Displaced {
  std::array<Float, 3> value, error;
};

/// The displacement under the first of two nearly equal pressures. By the double exponential rule between the lines where
/// the integrand has its peaks or no derivative; the error is the sum of the differences between the last two levels of
/// the rule and that between both pressures. Derivation: ref/half_space/README.md, Displacements.
Displaced displacement_under(const std::array<EllipticPressure, 2>& pressures, const SmoothLines& lines,
                             const PlaceInside& place, const std::vector<UnitPoint>& nodes, int digits);

}  // namespace nipref::ref
