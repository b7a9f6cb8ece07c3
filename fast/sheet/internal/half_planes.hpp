#pragma once
#include <nipref/data/problem/sheet_load.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/field_functions.hpp>
#include <nipref/fast/sheet/internal/theta_shares.hpp>

namespace nipref::fast {

inline SheetStresses operator+(const SheetStresses& a, const SheetStresses& b) {
  return {a.across + b.across, a.along + b.along, a.shear + b.shear};
}
inline SheetStresses operator*(double factor, const SheetStresses& a) {
  return {factor * a.across, factor * a.along, factor * a.shear};
}

}  // namespace nipref::fast

namespace nipref::fast::internal {

/// A point with alpha >= 0, 0 <= depth <= 1, by its distances from each load and from the load's face.
struct SeenFromLoads {
  SeenFromLoads(double along, double across);

  double alpha, depth;
  double near_face, far_face;    ///< 1 - depth, 1 + depth
  double near, far;              ///< distances from the loads
  double near_share, far_share;  ///< distance from the face over the square of the distance from the load
  double shares_apart;           ///< near_share - far_share, relatively accurate
};

/// The stresses of two half-planes, each under the load on its own face (Flamant).
SheetStresses half_plane_stresses(const SeenFromLoads& at, data::SheetLoad load);

/// A field under the normal load and, if requested, under the shear load.
template <class Field>
struct UnderLoads {
  Field normal, shear;
};

/// The stresses at one depth from -1 to 1.
class StressesAtDepth {
 public:
  explicit StressesAtDepth(double depth);
  /// For any finite alpha.
  [[nodiscard]] UnderLoads<SheetStresses> at(double alpha, bool with_shear) const;

 private:
  double depth_;
  AcrossWaves waves_;
};

/// The displacements u along +x and v along +y at a depth 0 <= s <= 1, minus s u and minus v of the face at the same
/// alpha, divided by theta1 + theta2. They decay like the stresses, as the displacement far from the loads is a shift
/// along the sheet and a uniform strain.
struct FromFace {
  double u, v;
};
class DisplacementsFromFace {
 public:
  DisplacementsFromFace(double depth, const Shares& share);
  /// For any finite alpha.
  [[nodiscard]] UnderLoads<FromFace> at(double alpha, bool with_shear) const;

 private:
  double depth_;
  Shares share_;
  AcrossWaves waves_, of_face_;
};

/// The half-planes' contributions to the parts of u and v, in terms of the kernels; see field_functions.hpp.
struct HalfPlaneParts {
  double first, second;  ///< the factors of theta2/N (or 1) and of theta1/N

  friend HalfPlaneParts operator+(const HalfPlaneParts& a, const HalfPlaneParts& b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend HalfPlaneParts operator-(const HalfPlaneParts& a, const HalfPlaneParts& b) {
    return {a.first - b.first, a.second - b.second};
  }
};
HalfPlaneParts half_plane_u(const SeenFromLoads& at, data::SheetLoad load);
HalfPlaneParts half_plane_v(const SeenFromLoads& at, data::SheetLoad load);

}  // namespace nipref::fast::internal
