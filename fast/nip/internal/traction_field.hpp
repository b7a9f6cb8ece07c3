#pragma once
#include <complex>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <nipref/fast/nip/internal/sheet_part.hpp>
#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {

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
/// faces, others by Gauss's rule, what crowds at the ends and is far by moments. What the sheet adds, and what is far as a
/// whole, is SheetPart's; of many places, by cells.
class TractionField {
 public:
  /// `symmetric`: the pressure is even about the middle and the shear odd.
  TractionField(double half_length, bool symmetric, const FaceTractions& traction);

  [[nodiscard]] SheetStresses at(const InnerPlace& place) const;
  /// The same at many places.
  [[nodiscard]] std::vector<SheetStresses> at(std::span<const InnerPlace> places) const;
  /// Of one place or of many, over the largest traction: an estimate, larger than what was found at random places of
  /// contacts of all lengths. Sums of values of both signs round most, and what shears pull in sum along the contact.
  [[nodiscard]] double rounding(bool of_many) const {
    return 2e-15 + (of_many ? 1.2e-14 : 1e-15) * blocks_.graded() + 5e-16 * blocks_.half_length();
  }

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
  /// int p/(Z - y) dy, int p/(Z - y)^2 dy and the same of the shear.
  struct Cauchy {
    Complex pressure, pressure_slope, shear, shear_slope;
  };
  [[nodiscard]] Side make_side(bool right, const FaceTractions& traction) const;
  void mirror();  ///< the right side to the left
  void add_side(bool right, const ContactBlocks::Range& near, double alpha, double distance,
                Cauchy& sum) const;
  /// Of one side, counted from its end: begin and end.
  [[nodiscard]] std::pair<std::size_t, std::size_t> panels_of(bool right,
                                                              const ContactBlocks::Range& blocks) const;
  [[nodiscard]] SheetStresses half_planes(const ContactBlocks::Range& near, const InnerPlace& place) const;

  /// The same stresses, at alpha >= 0 if the tractions are symmetric; whether shear changes its sign.
  [[nodiscard]] std::pair<InnerPlace, bool> folded(const InnerPlace& place) const {
    if (!symmetric_ || place.alpha >= 0) return {place, false};
    return {{-place.alpha, place.depth}, true};
  }

  ContactBlocks blocks_;
  bool symmetric_;
  SheetPart sheet_part_;
  Side sides_[2];  ///< left, right
};

}  // namespace nipref::fast
