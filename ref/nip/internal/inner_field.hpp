#pragma once
#include <array>
#include <deque>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/nip/internal/tractions.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {

/// A point inside the sheet, in half-thicknesses: alpha along the sheet, and -1 <= depth <= 1.
struct SheetPoint {
  Float alpha, depth;
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

/// A solved contact of which the field is computed, in half-thicknesses and any unit of stress.
struct FieldSource {
  Float middle, half_length;
  /// 0 at the ends and analytic between them, as functions of the distances from the left and the right end, > 0.
  std::function<PressureAndShear(const Float& from_left, const Float& from_right)> tractions;
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
/// The field of each face's half-plane by the double exponential rule, the rest by a Gauss rule over the wave numbers:
/// ref/nip/README.md, Stresses inside, Displacements inside. Neither part uses the kernels of sheet/field.hpp.
class InnerField {
 public:
  InnerField(FieldSource source, FieldFineness fineness)
      : source_(std::move(source)), fineness_(std::move(fineness)) {}

  [[nodiscard]] FloatStresses at(const SheetPoint& point) const;
  /// The displacements there, which vanish at alpha = 0 on the middle plane if the pressure is even and the shear odd. The shear
  /// must have no resultant.
  [[nodiscard]] FloatDisplacements displacements(const SheetPoint& point, const FloatShares& shares) const;

 private:
  /// A point relative to one of the faces.
  struct FacePoint;
  struct Charge {
    Float from_middle;
    PressureAndShear weighted;
  };
  /// One node of Gauss's rule: z, its weight over pi, 2 sinh z/D and 2 cosh z/D with D = sinh 2z + 2z, e^-z and the
  /// tractions' integrals with cos and sin.
  struct Wave {
    Float z, weight, sinh_part, cosh_part, fall;
    PressureAndShear cosine, sine;
  };
  /// The form of a stress or a displacement.
  struct Form;
  /// across, along and shear; across and along.
  using Stresses = std::array<Float, 3>;
  using Displacements = std::array<Float, 2>;

  /// Nodes of the double exponential rule that the levels before this one lack.
  [[nodiscard]] const std::vector<UnitPoint>& level(int number) const;
  /// Of stresses or displacements.
  template <std::size_t Parts>
  [[nodiscard]] std::array<Float, Parts> sums(const SheetPoint& point, const FloatShares& shares,
                                              const std::array<Form, Parts>& forms) const;
  template <std::size_t Parts>
  void add_segment(const Float& start, const Float& end, const FacePoint& point,
                   std::array<Float, Parts>& sum) const;
  template <std::size_t Parts>
  void add_half_plane(const SheetPoint& at, int face, const FloatShares& shares,
                      std::array<Float, Parts>& sum) const;
  template <std::size_t Parts>
  void add_sheet_rest(const SheetPoint& point, const std::array<Form, Parts>& forms,
                      std::array<Float, Parts>& sum) const;
  [[nodiscard]] const std::vector<Charge>& charges() const;
  [[nodiscard]] const std::vector<Wave>& waves(const Float& alpha) const;

  FieldSource source_;
  FieldFineness fineness_;
  mutable std::deque<std::vector<UnitPoint>> levels_;
  mutable std::vector<Charge> charges_;
  mutable std::map<int, std::vector<Wave>> waves_;  ///< by the distance up to which they suffice, see waves()
};

/// The largest distance at which displacements are computed from a contact, and stresses inside from its middle, half-thicknesses.
inline constexpr double farthest_inside = 900;

/// The stresses inside the sheet from the tractions of two solutions of a contact. The values are those of the fine one; the
/// error is estimated: twice the largest difference at the point, a hundredth of the last digit of `scale`, and `uncertainty`.
class ContactField {
 public:
  /// `scale` is about the pressure in the middle, `uncertainty` the error that both solutions have in common.
  ContactField(const FieldSource& coarse, const FieldSource& fine, const Float& scale,
               const Float& uncertainty, int digits);

  /// The stresses at a point, times the unit of stress. `symmetric`: the pressure is even and the shear odd about
  /// alpha = 0.
  [[nodiscard]] InnerStresses at(const SheetPoint& point, bool symmetric, const Float& unit) const;
  /// The displacements of an elastic contact, whose pressure is even and whose shear odd about alpha = 0, times their unit.
  /// The error is twice the difference, plus `uncertain`.
  [[nodiscard]] InnerDisplacements displacements_at(const SheetPoint& point, const FloatShares& share,
                                                    const Float& uncertain, const Float& unit) const;
  /// The maximum is located by samples whose spacing scales with the contact, by a search around the best sample, and
  /// by Newton's method for the zero of the gradient, which is computed by differences. `length` is the unit of
  /// length.
  [[nodiscard]] GreatestShear greatest(bool symmetric, const Float& unit, const Float& length) const;

 private:
  struct Peak;
  [[nodiscard]] Float smooth_radius(const SheetPoint& point) const;
  [[nodiscard]] SheetPoint best_sample(bool symmetric) const;
  [[nodiscard]] Peak peak(const InnerField& field, const SheetPoint& near) const;

  InnerField coarse_, fine_, rough_;
  Float middle_, half_length_, scale_, uncertainty_;
  int digits_;
};

/// The point in half-thicknesses, where `length` is half a thickness. BadInput unless the depth is from -1 to 1 and y
/// is within 450 sheet thicknesses.
SheetPoint checked_point(const InnerPoint& point, const Float& length);

}  // namespace nipref::ref
