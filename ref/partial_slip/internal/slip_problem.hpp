#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <nipref/ref/number/float.hpp>

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

  /// arctan(beta sign friction)/pi.
  [[nodiscard]] Float shift(int sign) const { return atan(Float(beta * friction * sign)) / pi(); }
};

}  // namespace nipref::ref
