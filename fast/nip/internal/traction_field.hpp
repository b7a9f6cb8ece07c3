#pragma once
#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include <nipref/fast/nip/internal/sheet_part.hpp>
#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {

/// A point inside the sheet, in half-thicknesses: along it from the middle of the contact, and -1 <= depth <= 1.
struct SheetPoint {
  double alpha, depth;
};

/// The stresses inside the sheet under the same tractions on both faces between -half_length and half_length, in the
/// tractions' unit.
///
/// The fields of the half-planes behind both faces are Cauchy integrals of the tractions and the derivatives of these
/// integrals. The tractions are Legendre series on panels that halve towards both ends, down to 2^-72 of a
/// half-thickness or of the contact, which resolves any exponent at the ends, and that are halved further until the last
/// coefficients are as small as rounding. A panel beside the place is integrated by
/// Legendre functions of the second kind, which hold on the faces too; other panels by Gauss's rule; distant panels at
/// an end together, by moments. SheetPart adds what the sheet adds to the half-planes and the whole field of distant
/// tractions.
class TractionField {
 public:
  /// `symmetric`: the pressure is even about the middle and the shear odd.
  TractionField(double half_length, bool symmetric, const FaceTractions& traction);

  [[nodiscard]] SheetStresses at(const SheetPoint& place) const;
  /// What the displacements have at a place beyond those of the face there, see internal::FromFace, in the tractions' unit
  /// times theta1 + theta2; u towards the middle plane.
  [[nodiscard]] internal::FromFace from_face(const SheetPoint& place, const internal::Shares& share) const;
  /// Rounding over the largest traction: the fields of both half-planes and the sheet's are at most 4 times that, and their
  /// terms have some three roundings each, in all 36 u; and of the sums over the 18 nodes of each half-thickness of the
  /// contact, to which the force of the shears adds a traction at most, each addition rounds by half a unit.
  [[nodiscard]] double rounding() const { return 0x1p-53 * (36 + 9 * blocks_.half_length()); }
  /// The largest of the last coefficients of the series, in the tractions' unit.
  [[nodiscard]] double unresolved() const { return std::max(sides_[0].unresolved, sides_[1].unresolved); }

 private:
  static constexpr int order = 20, moment_count = 24;
  using Complex = std::complex<double>;

  /// left <= e <= left + width on one side; t runs from -1 to 1 along the sheet.
  struct SampledPanel {
    double left, right, width;
    double t[order];             ///< nodes
    FaceTraction loads[order];   ///< tractions times weights for t
    FaceTraction series[order];  ///< coefficients of Legendre polynomials
  };
  /// Moments of all tractions from the contact's end to the right end of a panel, with powers of the distance from the
  /// contact's end over that of the panel's right end.
  using Moments = std::array<FaceTraction, moment_count>;
  struct Side {
    std::vector<SampledPanel> panels;
    std::vector<Moments> moments;
    std::vector<std::size_t> first_of_block;  ///< from the contact's end on, and the number of panels
    double unresolved = 0;
  };
  /// int p/(Z - y) dy, int p/(Z - y)^2 dy, int p ln(Z - y) dy and the same of the shear; logarithms or slopes where they are
  /// asked for.
  struct Cauchy {
    PressureAndShear<Complex> whole, slope, log;
  };
  enum class Wanted { slopes, logarithms };
  [[nodiscard]] std::vector<Side> make_sides(const FaceTractions& traction) const;  ///< left, right
  [[nodiscard]] Side make_side(bool right, const FaceTractions& traction) const;
  static void add_resolved(bool right, const SampledPanel& panel, const FaceTractions& traction,
                           double negligible, int halvings, Side& side);
  static void add(const SampledPanel& panel, Side& side);
  [[nodiscard]] static SampledPanel sampled(bool right, double left, double end,
                                            const FaceTractions& traction);
  [[nodiscard]] static Side mirrored(const Side& right);
  [[nodiscard]] std::vector<LoadOnFace> loads_of(bool right, std::size_t block) const;
  void add_side(bool right, const ContactBlocks::Range& near, double alpha, double distance, Wanted wanted,
                Cauchy& total) const;
  [[nodiscard]] Cauchy cauchy(const ContactBlocks::Range& near, double alpha, double distance,
                              Wanted wanted) const;
  /// The range of one side's panels, counted from its end, in the blocks.
  [[nodiscard]] std::pair<std::size_t, std::size_t> panels_of(bool right,
                                                              const ContactBlocks::Range& blocks) const;
  [[nodiscard]] SheetStresses half_planes(const ContactBlocks::Range& near, const SheetPoint& place) const;

  [[nodiscard]] internal::FromFace half_planes_displaced(const ContactBlocks::Range& near, double alpha,
                                                         double depth, const internal::Shares& share) const;

  /// The place itself or, if the tractions are symmetric, its mirror image at alpha >= 0; and whether the shear stress
  /// there has the opposite sign.
  [[nodiscard]] std::pair<SheetPoint, bool> folded(const SheetPoint& place) const {
    if (!symmetric_ || place.alpha >= 0) return {place, false};
    return {{-place.alpha, place.depth}, true};
  }

  ContactBlocks blocks_;
  bool symmetric_;
  std::vector<Side> sides_;
  SheetPart sheet_part_;
};

}  // namespace nipref::fast
