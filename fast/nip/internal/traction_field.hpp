#pragma once
#include <complex>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast {

/// Pressure, and shear along the sheet, dimensionless.
struct FaceTraction {
  double pressure, shear;
};

/// A place inside the sheet, in half-thicknesses: along it from the middle of the contact, and -1 <= depth <= 1.
struct InnerPlace {
  double alpha, depth;
};

/// The stresses inside the sheet under the same tractions on both faces between -half_length and half_length, in the
/// tractions' unit.
///
/// The half-planes' fields of both faces are Cauchy integrals of the tractions and their derivatives. For these the
/// tractions are Legendre series on panels that halve towards both ends, down to 2^-72 of a half-thickness or of the
/// contact, whatever their exponents there: panels beside a place by Legendre functions of the second kind, also on the
/// faces, others by Gauss's rule, what crowds at the ends and is far by moments. What the sheet adds is analytic up to a
/// distance of 2 and comes from some ten nodes a half-thickness. Good to about 1e-12 of the largest traction.
class TractionField {
 public:
  /// The traction at the distance e >= 0 from the right or the left end; continuous, 0 at the ends, analytic between
  /// but for the ends.
  using Traction = std::function<FaceTraction(bool right, double e)>;

  TractionField(double half_length, const Traction& traction);

  [[nodiscard]] SheetStresses at(const InnerPlace& place) const;
  /// The same at many places; where they crowd, what the sheet adds is interpolated.
  [[nodiscard]] std::vector<SheetStresses> at(std::span<const InnerPlace> places) const;

 private:
  static constexpr int order = 16, moment_count = 24;
  using Complex = std::complex<double>;

  /// left <= e <= left + width on one side; t from -1 to 1 along the sheet.
  struct Panel {
    double left, right, width;
    double t[order], pressure[order], shear[order];      ///< nodes, tractions times weights for t
    double pressure_series[order], shear_series[order];  ///< coefficients of Legendre polynomials
  };
  /// Of all tractions up to the right of a panel, over powers of their distance from the end in units of that end.
  struct Moments {
    double pressure[moment_count], shear[moment_count];
  };
  struct Side {
    std::vector<Panel> panels;
    std::vector<Moments> moments;
  };
  struct SmoothNode {
    double alpha, pressure, shear;
  };
  /// int p/(Z - y) dy, int p/(Z - y)^2 dy and the same of the shear.
  struct Cauchy {
    Complex pressure, pressure_slope, shear, shear_slope;
  };
  class Interpolant;

  [[nodiscard]] Side make_side(bool right, const Traction& traction) const;
  void add_smooth_nodes(bool right, const Traction& traction);
  void add_side(bool right, double alpha, double distance, Cauchy& sum) const;
  [[nodiscard]] SheetStresses half_planes(const InnerPlace& place) const;
  [[nodiscard]] SheetStresses beside(const InnerPlace& place) const;
  void beside(double alpha, const internal::StressesAtDepths& depths, std::span<SheetStresses> sums) const;

  double half_length_;
  Side sides_[2];  ///< left, right
  std::vector<SmoothNode> smooth_;
};

}  // namespace nipref::fast
