#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include <nipref/data/problem/field_places.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>

namespace nipref::verify {

/// What fast and ref have inside the sheet.
struct FastInside {
  using Number = fast::Estimate;
  using Point = fast::InnerPoint;
  using Stresses = fast::InnerStresses;
  using Greatest = fast::GreatestShear;
  static Number number(const Number& x) { return x; }
};
struct RefInside {
  using Number = LongEstimate;
  using Point = ref::InnerPoint;
  using Stresses = ref::InnerStresses;
  using Greatest = ref::GreatestShear;
  static Number number(const ref::Estimated& x) { return long_estimate(x); }
};

/// The results inside the sheet of a converged contact by their names; the stresses are computed once for all. A scene
/// has one field.
template <class Contact, class Path>
class Inside {
 public:
  using Number = typename Path::Number;

  [[nodiscard]] std::vector<Number> field(const Contact& contact, std::string_view name,
                                          const data::FieldPlaces& places) const {
    if (!stresses_) {
      std::vector<typename Path::Point> points;
      for (const double depth : places.depths) {
        for (const double y : places.positions) points.push_back({y, depth});
      }
      stresses_ = contact.inner_stresses(points);
    }
    std::vector<Number> numbers;
    for (const auto& here : *stresses_) numbers.push_back(Path::number(part_of(here, name)));
    return numbers;
  }
  /// Nothing if the name is of another kind.
  [[nodiscard]] std::optional<Number> number(const Contact& contact, std::string_view name) const {
    if (!name.starts_with("greatest_shear")) return {};
    if (!greatest_) greatest_ = contact.greatest_shear();
    if (name == "greatest_shear_position") return Path::number(greatest_->y);
    return Path::number(name == "greatest_shear_depth" ? greatest_->depth : greatest_->value);
  }

 private:
  static auto part_of(const typename Path::Stresses& here, std::string_view name) {
    if (name == "stress_across") return here.across;
    if (name == "stress_along") return here.along;
    if (name == "stress_shear") return here.shear;
    if (name == "highest_stress") return here.highest();
    return name == "lowest_stress" ? here.lowest() : here.maximum_shear();
  }

  mutable std::optional<std::vector<typename Path::Stresses>> stresses_;
  mutable std::optional<typename Path::Greatest> greatest_;
};

}  // namespace nipref::verify
