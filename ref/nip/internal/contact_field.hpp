#pragma once
#include <functional>

#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/nip/internal/inner_field.hpp>

namespace nipref::ref {

/// Farthest from the middle of a contact that stresses inside are given, half-thicknesses.
inline constexpr double farthest_inside = 900;

/// A solved contact of which the field is computed, in half-thicknesses and any unit of stress.
struct FieldSource {
  Float middle, half_length;
  InnerField::Tractions tractions;
};

/// The stresses inside the sheet of a contact that is known twice, from its tractions: nothing is proven. Values are the
/// finer's, errors twice the largest distance of both fields' stresses at the place, to which add a hundredth of the last
/// digit of `scale` and `uncertainty`.
class ContactField {
 public:
  /// scale: about the pressure in the middle. uncertainty: of the field by what both solutions lack alike.
  ContactField(const FieldSource& coarse, const FieldSource& fine, const Float& scale,
               const Float& uncertainty, int digits);

  /// A place: along the sheet, half-thicknesses, and -1 <= depth <= 1.
  struct Place {
    Float alpha, depth;
  };
  /// In units of stress. `symmetric`: the pressure is even, the shear odd about alpha = 0.
  [[nodiscard]] InnerStresses at(const Place& place, bool symmetric, const Float& unit) const;
  /// By samples as fine as the contact is short, steps around their best and Newton's steps for where the slopes, by
  /// differences, are 0. `length`: unit of length.
  [[nodiscard]] GreatestShear greatest(bool symmetric, const Float& unit, const Float& length) const;

 private:
  struct Peak;
  [[nodiscard]] Float reach(const Place& place) const;
  [[nodiscard]] Place best_sample(bool symmetric) const;
  [[nodiscard]] Peak peak(const InnerField& field, const Place& near) const;

  InnerField coarse_, fine_, rough_;
  Float middle_, half_length_, scale_, uncertainty_;
  int digits_;
};

/// BadInput unless the depth is from -1 to 1 and y is within 450 sheet thicknesses; length: half a thickness.
ContactField::Place checked_place(const InnerPoint& point, const Float& length);

}  // namespace nipref::ref
