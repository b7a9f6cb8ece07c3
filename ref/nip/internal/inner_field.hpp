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

/// theta1 and theta2 over their sum N.
struct FloatShares {
  Float theta1, theta2;
};

/// u across the sheet along +x, v along it, over N and in the tractions' unit.
struct FloatDisplacements {
  Float across, along;
};

/// The accuracy of a field: the error of its stresses is about 10^-digits of `scale`. Fields with a different
/// `fineness`, 1 or more, have no node in common.
struct FieldFineness {
  int digits;
  double fineness;
  Float scale;
};

/// The stresses inside the sheet -1 <= x <= 1 under the same tractions on both faces of a contact, in
/// half-thicknesses and the tractions' unit. (thesis 3.19, 3.26, 4.3, 4.14 as integrals over the contact)
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
///
/// Displacements likewise. A half-plane's are
///
///     pi u = +- int p (ln r - theta1 d^2/r^2) - q (theta2 arctan(u/d) + theta1 d u/r^2) d alpha'
///     pi v = int p (theta1 d u/r^2 - theta2 arctan(u/d)) - q (ln r + theta1 d^2/r^2) d alpha'
///
/// and the rests of their symbols are finite at z = 0 but for that of v under shear, whose pole a shear without resultant
/// cancels.
class InnerField {
 public:
  /// Tractions that are 0 at the ends and analytic between them, as functions of the distances from the left and the
  /// right end, > 0.
  using Tractions = std::function<FaceTraction(const Float& from_left, const Float& from_right)>;

  InnerField(const Float& middle, const Float& half_length, Tractions tractions, FieldFineness fineness);

  /// The stresses at a point, -1 <= depth <= 1.
  [[nodiscard]] FloatStresses at(const Float& alpha, const Float& depth) const;
  /// The displacements there, which vanish at alpha = 0 on the middle plane if the pressure is even and the shear odd. The shear
  /// must have no resultant.
  [[nodiscard]] FloatDisplacements displacements(const Float& alpha, const Float& depth,
                                                 const FloatShares& share) const;

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
  struct Transforms;
  struct Across;

  [[nodiscard]] const std::vector<UnitNode>& level(int number) const;
  /// Of stresses or displacements.
  template <class Field>
  void add_segment(const Segment& segment, const FacePoint& point, Field& sum) const;
  template <class Field>
  void add_half_plane(FacePoint point, Field& sum) const;
  [[nodiscard]] FacePoint face_point(const Float& alpha, const Float& depth, int face,
                                     const FloatShares& share) const;
  void add_sheet_rest(const Float& alpha, const Float& depth, FloatStresses& sum) const;
  void add_sheet_rest(const Float& alpha, const Float& depth, const FloatShares& share,
                      FloatDisplacements& sum) const;
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
