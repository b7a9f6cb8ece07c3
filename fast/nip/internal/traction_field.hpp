#pragma once
#include <complex>
#include <functional>
#include <map>
#include <span>
#include <utility>
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
/// distance of 2 and comes from some ten nodes a half-thickness. Loads far off come as a whole, half-planes included, from those of all together; where places crowd, that and what the sheet adds are
/// interpolated in cells. Good to about 1e-14 of the largest traction.
class TractionField {
 public:
  /// The traction at the distance e >= 0 from the right or the left end; continuous, 0 at the ends, analytic between
  /// but for the ends.
  using Traction = std::function<FaceTraction(bool right, double e)>;

  /// `symmetric`: the pressure is even about the middle and the shear odd.
  TractionField(double half_length, bool symmetric, const Traction& traction);

  [[nodiscard]] SheetStresses at(const InnerPlace& place) const;
  /// The same at many places.
  [[nodiscard]] std::vector<SheetStresses> at(std::span<const InnerPlace> places) const;

 private:
  static constexpr int order = 20, moment_count = 24;
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
  /// Parts of both sides that a place sees as half-planes' loads: the graded one at the end, then the panels of one
  /// length.
  struct Blocks {
    std::vector<bool> of_side[2];
  };
  class Cell;
  class Interpolant;

  [[nodiscard]] Side make_side(bool right, const Traction& traction) const;
  void mirror();  ///< the right side to the left
  void add_smooth_nodes(bool right, const Traction& traction);
  void add_side(bool right, const std::vector<bool>& blocks, double alpha, double distance,
                Cauchy& sum) const;
  [[nodiscard]] Blocks all_blocks() const;
  /// Those that are near to what is between two alphas.
  [[nodiscard]] Blocks blocks_near(double left, double right) const;
  [[nodiscard]] SheetStresses half_planes(const Blocks& blocks, const InnerPlace& place) const;
  [[nodiscard]] std::span<const SmoothNode> nodes_of(bool right, std::size_t block) const;

  /// The same stresses, at alpha >= 0 if the tractions are symmetric; whether shear changes its sign.
  [[nodiscard]] std::pair<InnerPlace, bool> folded(const InnerPlace& place) const {
    if (!symmetric_ || place.alpha >= 0) return {place, false};
    return {{-place.alpha, place.depth}, true};
  }

  double half_length_;
  bool symmetric_;
  Side sides_[2];  ///< left, right
  std::vector<SmoothNode> smooth_[2];
};

}  // namespace nipref::fast
