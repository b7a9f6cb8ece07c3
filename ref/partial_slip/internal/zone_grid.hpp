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

/// Of what there are two: p and q.
template <class Part>
using OfBoth = std::array<Part, 2>;
inline constexpr std::size_t pressure_part = 0, shear_part = 1;

/// A part of the contact in which q = sign friction p, or the surface sticks if sign = 0.
struct SlipZone {
  int sign;
  Float length;
};

/// Appends to the last zone if that has the same sign; between slip of opposite signs there is stick.
inline void add_zone(Row<SlipZone>& zones, int sign, const Float& length) {
  if (!zones.empty() && zones.back().sign == sign) {
    zones.back().length += length;
    return;
  }
  if (!zones.empty() && zones.back().sign * sign < 0)
    zones.push_back({0, std::min(zones.back().length, length) / 8});
  zones.push_back({sign, length});
}

/// A contact that is sought, dimensionless. e >= 0 is the distance from the leading end, q the shear on the sheet along +e.
struct SlipProblem {
  Float beta;
  double friction;
  std::optional<Float> length;  ///< L; where it is not given
  Float load = 0;               ///< int p de
  std::optional<Float> creep;   ///< xi; where it is not given
  Float shear = 0;              ///< int q de
  Float unit = 1;  ///< about the length of the contact, which is the size of tractions and creeps too

  /// Whether the zones are one that sticks, which only a traction of 0 allows. That traction is then one by symmetry, no condition.
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

/// The trapezoidal rule on a panel 0 < x < 1 by x = 1/(1 + e^(-steepness sinh s)). Places are counted in steps, c = 0, 1, ..
/// at the nodes, whose number is even; x = 1/2 is halfway between two. ref/partial_slip/README.md, The map.
class ZoneGrid {
 public:
  /// With errors of about e^-nats on the panels of zones of about these lengths. Each zone keeps its number of panels when its
  /// length changes, so that unknowns stay what they are.
  ZoneGrid(const SlipProblem& problem, double nats, const Row<SlipZone>& zones);

  [[nodiscard]] const SlipProblem& problem() const { return problem_; }
  [[nodiscard]] double nats() const { return nats_; }
  /// Into which a zone is divided.
  [[nodiscard]] int panels_of(GridIndex zone) const { return panels_of_zones_[zone]; }
  [[nodiscard]] GridIndex nodes() const { return from_left_.count(); }
  [[nodiscard]] const Row<Float>& from_left() const { return from_left_; }
  [[nodiscard]] const Row<Float>& from_right() const { return from_right_; }
  /// dx/dc at the nodes, which are the rule's weights.
  [[nodiscard]] const Row<Float>& weight() const { return weight_; }
  [[nodiscard]] const Row<Float>& weight_over_pi() const { return weight_over_pi_; }

  /// Where the equations are asked in a panel of that sign, at one point more than nodes: ref/partial_slip/README.md.
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

/// A part of a zone. It has values of p and of q: what is left of them at the nodes when their linear interpolation between
/// the panel's ends is taken off, then those at its left and right end. Rows of all values are by panels.
struct ZonePanel {
  int sign;
  Float left, length;
  double slip_ratio;  ///< q/p where it slips
  GridIndex first;    ///< value
};

/// A point of a panel.
struct ContactPoint {
  GridIndex panel;
  PanelPoint at;
};

/// Of all zones, from the leading end. They are those of the grid, but for their lengths.
class ZonePanels : public Row<ZonePanel> {
 public:
  ZonePanels(const Row<SlipZone>& zones, const ZoneGrid& grid);

  [[nodiscard]] GridIndex values() const { return values_; }
  [[nodiscard]] Float length() const { return back().left + back().length; }
  [[nodiscard]] ComplexFloat place(const ContactPoint& point) const { return distance(point, 0); }  ///< e
  /// From the left end of panel `joint`, 0 to the number of panels. Its real part is > 0.
  [[nodiscard]] ComplexFloat distance(const ContactPoint& point, GridIndex joint) const;
  /// Cauchy's integral 1/pi int t(e')/(e' - e) de' over the contact at a point, as factors of all values of t: by the grid's rule
  /// and, of the linear interpolations, in closed form, by the values at left ends. In the point's panel the rule lacks what the
  /// remainder at the point adds.
  void set_cauchy_row(Row<ComplexFloat>& row, const ZoneGrid& grid, const ContactPoint& point) const;

 private:
  GridIndex values_ = 0;
};

}  // namespace nipref::ref
