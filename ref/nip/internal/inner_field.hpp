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

/// u in the direction +x across the sheet and v along the sheet, divided by N, in the tractions' unit.
struct FloatDisplacements {
  Float across, along;
};

/// A solved contact whose field is computed, in half-thicknesses and any unit of stress.
struct FieldSource {
  Float middle, half_length;
  /// The tractions from the distances > 0 of a place from both ends. They are 0 at the ends and analytic between them.
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
/// The field of each face's half-plane is integrated by the double exponential rule, the rest by a Gauss rule over the
/// wave numbers: ref/nip/README.md, Stresses inside, Displacements inside. Neither uses the kernels of sheet/field.hpp.
class InnerField {
 public:
  InnerField(FieldSource source, FieldFineness fineness)
      : source_(std::move(source)), fineness_(std::move(fineness)) {}

  [[nodiscard]] FloatStresses at(const SheetPoint& point) const;
  /// The displacements at a point under a shear without resultant. With an even pressure and an odd shear they are 0 at
  /// alpha = 0 on the middle plane.
  [[nodiscard]] FloatDisplacements displacements(const SheetPoint& point, const FloatShares& shares) const;

 private:
  /// A point relative to one of the faces.
  struct FacePoint;
  /// A node of the double exponential rule over the contact, with the tractions there times its weight.
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
  enum Part : std::size_t { across, along, shear };
  using Stresses = std::array<Float, 3>;
  using Displacements = std::array<Float, 2>;  ///< across and along
  template <class Parts>
  static constexpr bool are_stresses = std::is_same_v<Parts, Stresses>;
  /// The symbols of a stress or a displacement.
  struct Form;
  template <class Parts>
  using FormsOf = std::array<Form, std::tuple_size_v<Parts>>;

  /// The nodes of the double exponential rule that this level adds to the levels before it.
  [[nodiscard]] const std::vector<UnitPoint>& level(int number) const;
  /// The stresses or the displacements at a point.
  template <class Parts>
  [[nodiscard]] Parts sums(const SheetPoint& point, const FloatShares& shares,
                           const FormsOf<Parts>& forms) const;
  template <class Parts>
  void add_segment(const Float& start, const Float& end, const FacePoint& point, Parts& sum) const;
  template <class Parts>
  void add_half_plane(const SheetPoint& at, int face, const FloatShares& shares, Parts& sum) const;
  template <class Parts>
  void add_sheet_rest(const SheetPoint& point, const FormsOf<Parts>& forms, Parts& sum) const;
  [[nodiscard]] const std::vector<Charge>& charges() const;
  [[nodiscard]] const std::vector<Wave>& waves(const Float& alpha) const;

  FieldSource source_;
  FieldFineness fineness_;
  mutable std::deque<std::vector<UnitPoint>> levels_;
  mutable std::vector<Charge> charges_;
  mutable std::map<int, std::vector<Wave>> waves_;  ///< by doublings of the distance they suffice for
};

/// The largest distance, in half-thicknesses, of surface displacements from the contact and of inner points from Y = 0.
inline constexpr double farthest_inside = 900;

/// The stresses inside the sheet from two solutions of a contact: the values of the fine one. The error estimate is the
/// sum of twice the largest difference at the point, a hundredth of the last digit of `scale`, and `uncertainty`.
class ContactField {
 public:
  /// `scale` is about the pressure in the middle, `uncertainty` the error that both solutions have in common.
  ContactField(const FieldSource& coarse, const FieldSource& fine, const Float& scale,
               const Float& uncertainty, int digits);

  /// The stresses at a point, times the unit of stress. If `symmetric`, p is even and q is odd about alpha = 0.
  [[nodiscard]] InnerStresses at(const SheetPoint& point, bool symmetric, const Float& unit) const;
  /// The displacements, times their unit, of an elastic contact, whose pressure is even and whose shear is odd about
  /// alpha = 0. The error estimate is twice the difference plus `uncertain`.
  [[nodiscard]] InnerDisplacements displacements_at(const SheetPoint& point, const FloatShares& share,
                                                    const Float& uncertain, const Float& unit) const;
  /// The maximum is located by samples whose spacing scales with the contact, by a search around each sample that is
  /// larger than those beside it, and by Newton's method for the zero of the gradient, which is computed by differences.
  /// Errors cover all maxima that may be the largest. `length` is the unit.
  [[nodiscard]] GreatestShear greatest(bool symmetric, const Float& unit, const Float& length) const;

 private:
  struct Peak;
  [[nodiscard]] Float smooth_radius(const SheetPoint& point) const;
  struct Top {
    SheetPoint point;
    Float shear;
  };
  using Samples = std::map<std::pair<int, int>, Top>;  ///< by their numbers along and into the sheet
  /// Samples at even numbers, and at all numbers beside the largest ones.
  [[nodiscard]] Samples samples(bool symmetric) const;
  static Float largest_of(const Samples& samples);
  /// The place of most shear near `start` in the rough field, to half a thousandth of the radius of smoothness.
  [[nodiscard]] Top top_near(const SheetPoint& start, bool symmetric) const;
  /// The places of maxima that may be the largest: the search leaves at most 5e-7 of the shear to them, see peak().
  [[nodiscard]] std::vector<SheetPoint> tops(bool symmetric) const;
  [[nodiscard]] Peak peak(const InnerField& field, const SheetPoint& near) const;
  struct Candidate {
    Estimate shear;
    SheetPoint point, error;
  };
  [[nodiscard]] Candidate candidate(const SheetPoint& near, bool symmetric, const Float& unit) const;

  InnerField coarse_, fine_, rough_;
  Float middle_, half_length_, scale_, uncertainty_;
  int digits_;
};

/// The point in half-thicknesses, which are `length`. BadInput unless |depth| <= 1 and |y| <= 450 sheet thicknesses.
SheetPoint checked_point(const InnerPoint& point, const Float& length);

}  // namespace nipref::ref
