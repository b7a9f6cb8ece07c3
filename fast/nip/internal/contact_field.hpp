#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <span>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/traction_field.hpp>

namespace nipref::fast {

/// The field of one of a ladder's solutions. `middle`: of its contact, from the origin of y, half-thicknesses.
struct FieldOfContact {
  TractionField field;
  double middle, half_length;

  [[nodiscard]] SheetStresses at(SheetPoint place) const { return field.at(moved(place)); }
  [[nodiscard]] SheetPoint moved(SheetPoint place) const { return {place.alpha - middle, place.depth}; }
};

/// Errors of the stresses inside the sheet that the differences between a ladder's solutions do not show.
struct FieldUncertainty {
  double of_ends;  ///< of the places of the contact's ends, half-thicknesses
  /// Of the tractions at a distance from an end, relative to the largest traction.
  std::function<double(double away)> of_tractions;
};

/// The field inside the sheet of a solved contact, dimensionless. `Ladder` is that of either nip; `field_of` makes the
/// field of a solution.
template <class Ladder>
class ContactField {
 public:
  using Contact = typename Ladder::Contact;

  /// peak: the largest traction, dimensionless.
  ContactField(const Ladder& ladder, std::function<FieldOfContact(const Contact&)> field_of, double peak,
               FieldUncertainty uncertainty)
      : ladder_(ladder), field_of_(std::move(field_of)), peak_(peak), uncertainty_(std::move(uncertainty)) {}

  /// The stresses at each place, all with one error: that of the ladder and those of the ends' places and of the
  /// field's rounding.
  [[nodiscard]] std::vector<InnerStresses> at(const std::vector<SheetPoint>& places) {
    std::vector<InnerStresses> result(places.size());
    const bool many = places.size() > most_assessed;
    const std::vector<double> errors = many ? errors_by_kind(places) : errors_of(places);
    std::vector<SheetPoint> moved;
    const FieldOfContact& field = of(ladder_.last());
    for (const SheetPoint& place : places) moved.push_back(field.moved(place));
    const std::vector<SheetStresses> stresses = field.field.at(moved);
    for (std::size_t i = 0; i < places.size(); ++i) {
      result[i] = {
          {stresses[i].across, errors[i]}, {stresses[i].along, errors[i]}, {stresses[i].shear, errors[i]}};
    }
    return result;
  }

  /// sigma_y on a face.
  [[nodiscard]] Estimate along_face(double alpha) { return at({SheetPoint{alpha, 1}}).front().along; }

  /// The largest shear by a grid that scales with the contact and is finer at its ends, then by ever smaller steps
  /// around the best place. `symmetric`: only y >= 0 is searched.
  [[nodiscard]] GreatestShear greatest(bool symmetric) {
    const FieldOfContact& field = of(ladder_.last());
    const auto shear_at = [&](const SheetPoint& place) {
      const SheetStresses s = field.field.at(place);
      return std::hypot((s.across - s.along) / 2, s.shear);
    };
    const double half_length = field.half_length, reach = std::min(1.0, half_length);
    SheetPoint best{0, 1};
    double largest = shear_at(best);
    const auto look = [&](const SheetPoint& place) {
      const double here = shear_at(place);
      if (!(here > largest)) return false;
      largest = here;
      best = place;
      return true;
    };
    // The grid is denser at the ends, beside which full friction may cause the largest shear.
    constexpr int steps = 24;
    for (int i = symmetric ? 0 : -steps; i <= steps; ++i) {
      const double alpha = half_length * std::sin(std::numbers::pi / 2 * i / steps);
      for (int j = 0; j <= steps; ++j) look({alpha, 1 - std::min(1.0, 2.5 * reach) * j / steps});
    }
    const auto smooth_about = [&](const SheetPoint& place) {
      return std::min(reach, std::hypot(half_length - std::fabs(place.alpha), 1 - place.depth));
    };
    double step = reach / steps;
    while (step > 1e-9 * smooth_about(best) && step > 1e-14 * reach) {
      const bool moved = look({best.alpha + step, best.depth}) ||
                         look({symmetric ? std::fabs(best.alpha - step) : best.alpha - step, best.depth}) ||
                         look({best.alpha, std::min(1.0, best.depth + step)}) ||
                         look({best.alpha, std::fabs(best.depth - step)});
      if (!moved) step /= 2;
    }
    const SheetPoint place{best.alpha + field.middle, best.depth};
    const Estimate value = at({place}).front().maximum_shear();
    // About its maximum the shear is a parabola on the scale of the contact or of the sheet.
    const double unsure = smooth_about(best) * (1e-7 + 4 * std::sqrt(value.error / value.value));
    return {value, {place.alpha, unsure}, {place.depth, unsure}};
  }

 private:
  /// Up to so many places each get their own error.
  static constexpr std::size_t most_assessed = 48;

  [[nodiscard]] const FieldOfContact& of(const Contact& contact) {
    const auto found = fields_.find(&contact);
    return found != fields_.end() ? found->second
                                  : fields_.emplace(&contact, field_of_(contact)).first->second;
  }
  /// The place that is as far from the nearer end of `other` as the given one is from that of the last solution.
  [[nodiscard]] SheetPoint seen_in(const FieldOfContact& other, const SheetPoint& place) {
    const FieldOfContact& last = of(ladder_.last());
    const double from_middle = place.alpha - last.middle;
    const double longer = other.half_length - last.half_length;
    return {from_middle + std::copysign(longer, from_middle), place.depth};
  }
  /// A bound on the size of the stresses at the place: that of the contact's whole load at its distance.
  [[nodiscard]] double size_at(const SheetPoint& place) {
    const FieldOfContact& last = of(ladder_.last());
    const double outside = std::max(0.0, std::fabs(place.alpha - last.middle) - last.half_length);
    const double away = std::hypot(outside, 1 - std::fabs(place.depth));
    return peak_ * std::min(1.0, last.half_length / away);
  }
  /// The error beside the ladder's. An end that moves changes tractions like the slope of a square root.
  [[nodiscard]] double uncertainty_at(const SheetPoint& place, bool of_many) {
    const FieldOfContact& last = of(ladder_.last());
    const double beside = std::fabs(std::fabs(place.alpha - last.middle) - last.half_length);
    const double unsure = uncertainty_.of_ends + 4e-16 * (last.half_length + std::fabs(place.alpha));
    const double away = std::max(unsure, std::hypot(beside, 1 - std::fabs(place.depth)));
    const double of_end = std::min(1.0, last.half_length / away) / std::sqrt(away * last.half_length);
    return peak_ * unsure * of_end +
           (last.field.rounding(of_many) + uncertainty_.of_tractions(away)) * size_at(place);
  }
  /// The place and, near a face, two beside it, because levels that agree at one place by chance differ beside it.
  [[nodiscard]] std::vector<SheetPoint> judged_at(const SheetPoint& place) {
    const FieldOfContact& last = of(ladder_.last());
    const double from_middle = place.alpha - last.middle,
                 before_end = last.half_length - std::fabs(from_middle);
    const double from_face = 1 - std::fabs(place.depth);
    if (!(before_end > 0) || from_face > 0.3 * before_end) return {place};
    const double step = std::copysign(0.2 * before_end, from_middle);
    return {place, {place.alpha + step, place.depth}, {place.alpha - step, place.depth}};
  }
  /// The largest error of a stress that the ladder gives there; `stresses`: of a field at a place.
  template <class Stresses>
  [[nodiscard]] double ladder_error(const SheetPoint& place, const Stresses& stresses) {
    std::map<const Contact*, SheetStresses> known;
    double largest = 0;
    for (double SheetStresses::*const part :
         {&SheetStresses::across, &SheetStresses::along, &SheetStresses::shear}) {
      const auto functional = [&](const Contact& contact) {
        auto found = known.find(&contact);
        if (found == known.end()) {
          const FieldOfContact& field = of(contact);
          found = known.emplace(&contact, stresses(field.field, seen_in(field, place))).first;
        }
        return found->second.*part;
      };
      largest = std::max(largest, ladder_.estimate_of_several(functional, size_at(place)).error);
    }
    return largest;
  }

  [[nodiscard]] std::vector<double> errors_of(const std::vector<SheetPoint>& places) {
    std::vector<double> errors;
    for (const SheetPoint& place : places) {
      const auto stresses = [](const TractionField& field, const SheetPoint& at) { return field.at(at); };
      double error = uncertainty_at(place, false);
      for (const SheetPoint& beside : judged_at(place))
        error = std::max(error, ladder_error(beside, stresses));
      errors.push_back(error);
    }
    return errors;
  }
  /// Of many places those of one kind share an error relative to the stresses' size: the larger that the ladder gives
  /// for two of them, one on either side of the contact.
  [[nodiscard]] std::vector<double> errors_by_kind(const std::vector<SheetPoint>& places) {
    std::map<std::array<int, 2>, std::vector<const SheetPoint*>> kinds;
    for (const SheetPoint& place : places) kinds[kind_of(place)].push_back(&place);
    std::map<std::array<int, 2>, double> largest;
    for (auto& [kind, members] : kinds) {
      std::ranges::sort(members, {}, &SheetPoint::alpha);
      for (const std::size_t quarter : {std::size_t{1}, std::size_t{3}}) {
        const SheetPoint& place = *members[quarter * members.size() / 4];
        const auto stresses = [](const TractionField& field, const SheetPoint& at) { return field.at(at); };
        largest[kind] = std::max(largest[kind], ladder_error(place, stresses) / size_at(place));
      }
    }
    std::vector<double> errors;
    for (const SheetPoint& place : places)
      errors.push_back(std::max(2 * largest[kind_of(place)] * size_at(place), uncertainty_at(place, true)));
    return errors;
  }
  /// Places of one kind have about the same distances from a face and from an end.
  [[nodiscard]] std::array<int, 2> kind_of(const SheetPoint& place) {
    const FieldOfContact& last = of(ladder_.last());
    const double from_middle = place.alpha - last.middle, beyond = std::fabs(from_middle) - last.half_length;
    const auto grade = [&](double way, int finest) {
      return std::clamp(static_cast<int>(std::floor(std::log2(way / last.half_length) / 2)), finest, 1);
    };
    return {grade(1 - std::fabs(place.depth), -3), beyond > 0 ? 10 + grade(beyond, -2) : grade(-beyond, -4)};
  }

  const Ladder& ladder_;
  std::function<FieldOfContact(const Contact&)> field_of_;
  double peak_;
  FieldUncertainty uncertainty_;
  std::map<const Contact*, FieldOfContact> fields_;
};

/// BadInput unless y is finite and the depth from -1 to 1.
inline SheetPoint checked_point(const InnerPoint& point, double unit) {
  check_position(point.y);
  if (!(std::fabs(point.depth) <= 1))
    throw data::BadInput("depth", point.depth, "must satisfy -1 <= depth <= 1");
  return {point.y / unit, point.depth};
}

inline InnerStresses in_unit(double unit, const InnerStresses& s) {
  return {times(unit, s.across), times(unit, s.along), times(unit, s.shear)};
}

}  // namespace nipref::fast
