#pragma once
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// The pressure, and the shear traction along the sheet.
struct FaceTraction {
  Float pressure, shear;
};

/// sigma_x across the sheet, sigma_y along it, tau_xy, tension positive.
struct FloatStresses {
  Float across, along, shear;
};

/// The accuracy of a field: the error of its stresses is about 10^-digits of `scale`. Fields with a different
/// `fineness`, 1 or more, have no node in common.
struct FieldFineness {
  int digits;
  double fineness;
  Float scale;
};

/// The stresses inside the sheet -1 <= x <= 1 under the same tractions on both faces of a contact, in
/// half-thicknesses and the tractions' unit. (thesis 3.19, 4.3, 4.14 as integrals over the contact)
///
/// The part of each face is the field of a half-plane (Flamant),
///
///     sigma = -(2/pi) int (d p + u q)/r^4 (d^2, u^2, -+ d u) d alpha',    u = alpha - alpha', r^2 = u^2 + d^2
///
/// where d is the distance from the face. It is integrated by the double exponential rule in w, u = d sinh w, over
/// both sides of the point together. Up to the nearer end this integrand is analytic for every d, and for d = 0 the
/// integral is the principal value.
///
/// The rest consists of the sheet's symbols less those of both half-planes, which decrease like z^2 e^(-2z), times
/// the tractions' Fourier transforms. It is integrated by a Gauss rule in z. Neither part uses the kernels of
/// sheet/field.hpp.
class InnerField {
 public:
  /// Tractions that are 0 at the ends and analytic between them, as functions of the distances from the left and the
  /// right end, > 0.
  using Tractions = std::function<FaceTraction(const Float& from_left, const Float& from_right)>;

  InnerField(const Float& middle, const Float& half_length, Tractions tractions, FieldFineness fineness);

  /// The stresses at a point, -1 <= depth <= 1.
  [[nodiscard]] FloatStresses at(const Float& alpha, const Float& depth) const;

 private:
  /// A node of the double exponential rule on (0, 1). Each level has only the nodes that the levels before it lack.
  struct UnitNode {
    Float from_left, from_right, slope;
  };
  /// A point relative to one of the faces.
  struct FacePoint;
  /// A range of |alpha - alpha'|, with tractions on both sides of the point or on one side.
  struct Segment;
  struct Charge {
    Float from_middle;
    FaceTraction weighted;
  };
  /// One node of Gauss's rule: z, its weight over pi, 2 sinh z/D and 2 cosh z/D with D = sinh 2z + 2z, e^-z and the
  /// tractions' integrals with cos and sin.
  struct Wave {
    Float z, weight, sinh_part, cosh_part, fall;
    FaceTraction cosine, sine;
  };

  [[nodiscard]] const std::vector<UnitNode>& level(int number) const;
  void add_segment(const Segment& segment, const FacePoint& point, FloatStresses& sum) const;
  [[nodiscard]] FloatStresses half_plane(const Float& alpha, const Float& depth, int face) const;
  void add_sheet_rest(const Float& alpha, const Float& depth, FloatStresses& sum) const;
  [[nodiscard]] const std::vector<Charge>& charges() const;
  [[nodiscard]] const std::vector<Wave>& waves(const Float& alpha) const;

  Float middle_, half_length_;
  Tractions tractions_;
  FieldFineness fineness_;
  mutable std::vector<std::unique_ptr<std::vector<UnitNode>>> levels_;
  mutable std::vector<Charge> charges_;
  mutable std::map<int, std::vector<Wave>> waves_;  ///< by the distance up to which they suffice, see waves()
};

}  // namespace nipref::ref
