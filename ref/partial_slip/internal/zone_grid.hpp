#pragma once
#include <Eigen/Core>
#include <vector>

#include <nipref/ref/number/internal/complex_float.hpp>

namespace nipref::ref {

using GridIndex = Eigen::Index;

/// A vector whose elements are counted like Eigen's.
template <class Element>
struct Row : std::vector<Element> {
  using Base = std::vector<Element>;
  using Base::Base;
  explicit Row(GridIndex count) { grow(count); }
  Row() = default;
  void grow(GridIndex count) { Base::resize(static_cast<typename Base::size_type>(count)); }
  [[nodiscard]] GridIndex count() const { return static_cast<GridIndex>(Base::size()); }
  Element& operator[](GridIndex i) { return Base::operator[](static_cast<typename Base::size_type>(i)); }
  const Element& operator[](GridIndex i) const {
    return Base::operator[](static_cast<typename Base::size_type>(i));
  }
};

/// A place in a panel: its distances from both ends over the panel's length, each exact where it is small.
struct PanelPoint {
  ComplexFloat from_left, from_right;
};

/// The trapezoidal rule on a panel 0 < x < 1 by x = 1/(1 + e^(-steepness sinh s)). Places are counted in steps, c = 0, 1, ..
/// at the nodes, whose number is even; x = 1/2 is halfway between two. ref/partial_slip/README.md, The map.
class ZoneGrid {
 public:
  /// With errors of about e^-nats on panels of up to `longest` half-thicknesses.
  ZoneGrid(double nats, double longest);

  [[nodiscard]] double nats() const { return nats_; }
  [[nodiscard]] GridIndex nodes() const { return from_left_.count(); }
  [[nodiscard]] const Row<Float>& from_left() const { return from_left_; }
  [[nodiscard]] const Row<Float>& from_right() const { return from_right_; }
  /// dx/dc at the nodes, which are the rule's weights.
  [[nodiscard]] const Row<Float>& weight() const { return weight_; }

  [[nodiscard]] PanelPoint at(const ComplexFloat& place) const;
  /// c of a real point.
  [[nodiscard]] Float place_of(const Float& from_left, const Float& from_right) const;
  /// dx/dc.
  [[nodiscard]] Float slope_at(const Float& place) const;

 private:
  double nats_;
  Float step_, steepness_, middle_;
  Row<Float> from_left_, from_right_, weight_;
};

}  // namespace nipref::ref
