#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/traction_field.hpp>

namespace nipref::fast {

/// The field of one of a ladder's solutions; `middle` of its contact, where y is counted from, half-thicknesses.
struct FieldOfContact {
  TractionField field;
  double middle;

  [[nodiscard]] SheetStresses at(InnerPlace place) const { return field.at(moved(place)); }
  [[nodiscard]] InnerPlace moved(InnerPlace place) const { return {place.alpha - middle, place.depth}; }
};

/// The field inside the sheet of a solved contact. `Ladder` is that of either nip, `field_of` makes a solution's field,
/// all dimensionless.
template <class Ladder>
class ContactField {
 public:
  using Contact = typename Ladder::Contact;

  /// peak: the largest traction, dimensionless. traction_error(alpha): of pressure and shear at the surface together, 0
  /// outside the contact.
  ContactField(const Ladder& ladder, std::function<FieldOfContact(const Contact&)> field_of, double peak,
               double half_length, std::function<double(double alpha)> traction_error)
      : ladder_(ladder),
        field_of_(std::move(field_of)),
        peak_(peak),
        half_length_(half_length),
        traction_error_(std::move(traction_error)) {}

  /// Each result's error is the largest that the ladder gives at some of the places, with what the field itself
  /// rounds and, near a face, what the tractions there lack.
  [[nodiscard]] std::vector<InnerStresses> at(const std::vector<InnerPlace>& places) {
    std::vector<InnerStresses> result(places.size());
    const std::vector<double> common = common_errors(places);
    std::vector<InnerPlace> moved;
    const FieldOfContact& field = of(ladder_.last());
    for (const InnerPlace& place : places) moved.push_back(field.moved(place));
    const std::vector<SheetStresses> stresses = field.field.at(moved);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double local = local_error(places[i]);
      result[i] = {{stresses[i].across, common[0] + local},
                   {stresses[i].along, common[1] + local},
                   {stresses[i].shear, common[2] + local}};
    }
    return result;
  }

  /// By a grid that is as fine as the contact is short, then by smaller and smaller steps around its best place; y is
  /// counted as in the places, `symmetric` contacts are looked at for y >= 0 only.
  [[nodiscard]] GreatestShear greatest(bool symmetric) {
    const FieldOfContact& field = of(ladder_.last());
    const auto shear_at = [&](const InnerPlace& place) {
      const SheetStresses s = field.field.at(place);
      return std::hypot((s.across - s.along) / 2, s.shear);
    };
    const double reach = std::min(1.0, half_length_);
    InnerPlace best{0, 1};
    double largest = shear_at(best);
    const auto look = [&](const InnerPlace& place) {
      const double here = shear_at(place);
      if (!(here > largest)) return false;
      largest = here;
      best = place;
      return true;
    };
    constexpr int steps = 24;
    for (int i = symmetric ? 0 : -steps; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        const double from_face = std::min(1.0, 2.5 * reach) * j / steps;
        look({half_length_ * 1.1 * i / steps, 1 - from_face});
      }
    }
    double step = reach / steps;
    while (step > 1e-9 * reach) {
      const bool moved = look({best.alpha + step, best.depth}) ||
                         look({symmetric ? std::fabs(best.alpha - step) : best.alpha - step, best.depth}) ||
                         look({best.alpha, std::min(1.0, best.depth + step)}) ||
                         look({best.alpha, std::fabs(best.depth - step)});
      if (!moved) step /= 2;
    }
    const InnerPlace place{best.alpha + field.middle, best.depth};
    const Estimate value = at({place}).front().maximum_shear();
    // Flat as a parabola about the maximum, over the contact's or the sheet's length.
    const double unsure = reach * (1e-7 + 4 * std::sqrt(value.error / value.value));
    return {value, {place.alpha, unsure}, {place.depth, unsure}};
  }

 private:
  static constexpr int samples = 12;
  static constexpr double rounding = 5e-13;

  [[nodiscard]] const FieldOfContact& of(const Contact& contact) {
    const auto found = fields_.find(&contact);
    return found != fields_.end() ? found->second
                                  : fields_.emplace(&contact, field_of_(contact)).first->second;
  }

  [[nodiscard]] std::vector<double> common_errors(const std::vector<InnerPlace>& places) {
    std::vector<double> errors;
    const std::size_t count = std::min<std::size_t>(samples, places.size());
    for (double SheetStresses::*const part :
         {&SheetStresses::across, &SheetStresses::along, &SheetStresses::shear}) {
      double largest = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const InnerPlace& place = places[k * places.size() / count];
        const auto functional = [&](const Contact& contact) { return of(contact).at(place).*part; };
        largest = std::max(largest, ladder_.estimate_of_integral(functional, peak_).error);
      }
      errors.push_back(largest + rounding * peak_);
    }
    return errors;
  }

  [[nodiscard]] double local_error(const InnerPlace& place) {
    if (1 - std::fabs(place.depth) > 0.3 * half_length_) return 0;
    const auto found = traction_errors_.find(place.alpha);
    if (found != traction_errors_.end()) return found->second;
    return traction_errors_[place.alpha] = traction_error_(place.alpha);
  }

  const Ladder& ladder_;
  std::function<FieldOfContact(const Contact&)> field_of_;
  double peak_, half_length_;
  std::function<double(double)> traction_error_;
  std::map<const Contact*, FieldOfContact> fields_;
  std::map<double, double> traction_errors_;
};

/// BadInput unless y is finite and the depth from -1 to 1.
inline InnerPlace checked_place(const InnerPoint& point, double unit) {
  check_position(point.y);
  if (!(std::fabs(point.depth) <= 1))
    throw data::BadInput("depth", point.depth, "must satisfy -1 <= depth <= 1");
  return {point.y / unit, point.depth};
}

inline InnerStresses in_unit(double unit, const InnerStresses& s) {
  return {times(unit, s.across), times(unit, s.along), times(unit, s.shear)};
}

}  // namespace nipref::fast
