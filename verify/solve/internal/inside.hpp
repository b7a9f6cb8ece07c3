#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include <nipref/data/problem/field_places.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>

namespace nipref::verify {

/// The results inside the sheet of a converged contact of fast by their names; the stresses are computed once for all.
/// A scene has one field.
template <class Contact>
class Inside {
 public:
  [[nodiscard]] std::vector<fast::Estimate> field(const Contact& contact, std::string_view name,
                                                  const data::FieldPlaces& places) const {
    if (!stresses_) {
      std::vector<fast::InnerPoint> points;
      for (const double depth : places.depths) {
        for (const double y : places.positions) points.push_back({y, depth});
      }
      stresses_ = contact.inner_stresses(points);
    }
    std::vector<fast::Estimate> numbers;
    for (const fast::InnerStresses& here : *stresses_) numbers.push_back(part_of(here, name));
    return numbers;
  }
  /// Nothing if the name is of another kind.
  [[nodiscard]] std::optional<fast::Estimate> number(const Contact& contact, std::string_view name) const {
    if (!name.starts_with("greatest_shear")) return {};
    if (!greatest_) greatest_ = contact.greatest_shear();
    if (name == "greatest_shear_position") return greatest_->y;
    return name == "greatest_shear_depth" ? greatest_->depth : greatest_->value;
  }

 private:
  static fast::Estimate part_of(const fast::InnerStresses& here, std::string_view name) {
    if (name == "stress_across") return here.across;
    if (name == "stress_along") return here.along;
    if (name == "stress_shear") return here.shear;
    if (name == "highest_stress") return here.highest();
    return name == "lowest_stress" ? here.lowest() : here.maximum_shear();
  }

  mutable std::optional<std::vector<fast::InnerStresses>> stresses_;
  mutable std::optional<fast::GreatestShear> greatest_;
};

}  // namespace nipref::verify
