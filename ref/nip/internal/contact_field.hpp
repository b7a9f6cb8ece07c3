#pragma once
#include <functional>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/nip/internal/inner_field.hpp>

namespace nipref::ref {

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
