#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/field_places.hpp>
#include <nipref/verify/solve/internal/paths.hpp>

namespace nipref::verify {

/// The results inside the sheet of a converged contact. The stresses are computed once and cached, as a scene has one
/// field.
template <class Contact, class Path>
class Inside {
 public:
  using Number = typename Path::Number;

  [[nodiscard]] std::vector<Number> field(const Contact& contact, ResultId id,
                                          const data::FieldPlaces& places) const {
    if (!stresses_) {
      std::vector<typename Path::Point> points;
      for (const double depth : places.depths) {
        for (const double y : places.positions) points.push_back({y, depth});
      }
      stresses_ = contact.inner_stresses(points);
    }
    std::vector<Number> numbers;
    for (const auto& here : *stresses_) numbers.push_back(part_of(here, id));
    return numbers;
  }
  /// greatest_shear, its position or its depth.
  [[nodiscard]] Number number(const Contact& contact, ResultId id) const {
    if (!greatest_) greatest_ = contact.greatest_shear();
    if (id == ResultId::greatest_shear_position) return greatest_->y;
    return id == ResultId::greatest_shear_depth ? greatest_->depth : greatest_->value;
  }

 private:
  static auto part_of(const typename Path::Stresses& here, ResultId id) {
    if (id == ResultId::stress_across) return here.across;
    if (id == ResultId::stress_along) return here.along;
    if (id == ResultId::stress_shear) return here.shear;
    if (id == ResultId::highest_stress) return here.highest();
    return id == ResultId::lowest_stress ? here.lowest() : here.maximum_shear();
  }

  mutable std::optional<std::vector<typename Path::Stresses>> stresses_;
  mutable std::optional<typename Path::Greatest> greatest_;
};

}  // namespace nipref::verify
