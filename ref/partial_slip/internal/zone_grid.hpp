#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <nipref/ref/number/internal/complex.hpp>

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

/// A pair, one part for p and one for q.
template <class Part>
using OfBoth = std::array<Part, 2>;
inline constexpr std::size_t pressure_part = 0, shear_part = 1;

/// A part of the contact in which q = sign friction p, or the surface sticks if sign = 0.
struct SlipZone {
  int sign;
  Float length;
};

/// Appends a zone, or lengthens the last one if its sign is the same. Between opposite slips a stick zone is inserted.
inline void add_zone(Row<SlipZone>& zones, int sign, const Float& length) {
  if (!zones.empty() && zones.back().sign == sign) {
    zones.back().length += length;
    return;
  }
  if (!zones.empty() && zones.back().sign * sign < 0)
    zones.push_back({0, std::min(zones.back().length, length) / 8});
  zones.push_back({sign, length});
}

/// The problem of a contact, dimensionless. e >= 0 is the distance from the leading end, q the shear along +e.
struct SlipProblem {
  Float beta;
  double friction;
  std::optional<Float> length;  ///< L, if it is given
  Float load = 0;               ///< int p de, if the length is not given
  std::optional<Float> creep;   ///< xi, if it is given
  Float shear = 0;              ///< int q de, if the creep is not given
  Float unit = 1;               ///< about the length of the contact, also the scale of tractions and creeps

  /// Whether all of the contact sticks, which only a traction of 0 allows. By symmetry this traction is no condition.
  [[nodiscard]] bool may_stick_all_along(const Row<SlipZone>& zones) const {
    return zones.count() == 1 && zones.back().sign == 0 && !creep && shear == 0;
  }
  /// arctan(beta sign friction)/pi.
  [[nodiscard]] Float shift(int sign) const { return atan(Float(beta * friction * sign)) / pi(); }
};

/// A place in a panel: its distances from both ends over the panel's length, each exact where it is small.
struct PanelPoint {
  ComplexFloat from_left, from_right;
};

/// The trapezoidal rule on a panel 0 < x < 1 by x = 1/(1 + e^(-steepness sinh s)). Places are counted in steps, c = 0,
/// 1, .. at the nodes, whose number is even; x = 1/2 is halfway between two nodes. ref/partial_slip/README.md, The map.
class ZoneGrid {
 public:
  /// A grid with errors of about e^-nats on the panels of zones of about these lengths. A zone keeps its number of
  /// panels when its length changes, so that the unknowns stay the same.
  ZoneGrid(const SlipProblem& problem, double nats, const Row<SlipZone>& zones);

  [[nodiscard]] const SlipProblem& problem() const { return problem_; }
  [[nodiscard]] double nats() const { return nats_; }
  /// The number of panels into which a zone is divided.
  [[nodiscard]] int panels_of(GridIndex zone) const { return panels_of_zones_[zone]; }
  [[nodiscard]] GridIndex nodes() const { return from_left_.count(); }
  [[nodiscard]] const Row<Float>& from_left() const { return from_left_; }
  [[nodiscard]] const Row<Float>& from_right() const { return from_right_; }
  /// dx/dc at the nodes, which are the rule's weights.
  [[nodiscard]] const Row<Float>& weight() const { return weight_; }
  [[nodiscard]] const Row<Float>& weight_over_pi() const { return weight_over_pi_; }

  /// The collocation points in a panel of that sign, one more than nodes: ref/partial_slip/README.md.
  [[nodiscard]] const Row<PanelPoint>& points(int sign) const {
    return points_[static_cast<std::size_t>(sign + 1)];
  }

  [[nodiscard]] PanelPoint at(const ComplexFloat& place) const;
  /// c of a real point.
  [[nodiscard]] Float place_of(const Float& from_left, const Float& from_right) const;
  /// dx/dc.
  [[nodiscard]] Float slope_at(const Float& place) const;

 private:
  SlipProblem problem_;
  double nats_;
  Row<int> panels_of_zones_;
  Float step_, steepness_, middle_;
  Row<Float> from_left_, from_right_, weight_, weight_over_pi_;
  std::array<Row<PanelPoint>, 3> points_;
};

/// A part of a zone. Its values of p and of q are their remainders at the nodes, beyond the linear interpolation
/// between the panel's ends, then p and q at its left and right end. Rows of all values are ordered by panels.
struct ZonePanel {
  int sign;
  Float left, length;
  double slip_ratio;  ///< q/p where it slips
  GridIndex first;    ///< index of its first value
};

/// A point of a panel.
struct ContactPoint {
  GridIndex panel;
  PanelPoint at;
};

/// The panels of all zones, from the leading end: as many as the grid has, with the lengths of the zones.
class ZonePanels : public Row<ZonePanel> {
 public:
  ZonePanels(const Row<SlipZone>& zones, const ZoneGrid& grid);

  [[nodiscard]] GridIndex values() const { return values_; }
  [[nodiscard]] Float length() const { return back().left + back().length; }
  [[nodiscard]] ComplexFloat place(const ContactPoint& point) const { return distance(point, 0); }  ///< e
  /// The distance of a point from the left end of panel `joint`, 0 to the number of panels. Its real part is > 0.
  [[nodiscard]] ComplexFloat distance(const ContactPoint& point, GridIndex joint) const;
  /// Sets the factors of all values of t in Cauchy's integral 1/pi int t(e')/(e' - e) de' over the contact, at a point.
  /// Remainders are summed by the grid's rule, which in the point's panel lacks the local term of the remainder. Linear
  /// interpolations are integrated in closed form, by factors of the values at left ends.
  void set_cauchy_row(Row<ComplexFloat>& row, const ZoneGrid& grid, const ContactPoint& point) const;

 private:
  GridIndex values_ = 0;
};

}  // namespace nipref::ref
