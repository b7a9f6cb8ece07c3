#pragma once
#include <nipref/data/problem/sheet_load.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/field_functions.hpp>

namespace nipref::fast::internal {

/// A point as both loads see it, alpha >= 0, 0 <= depth <= 1: distance from each load and from its face.
struct SeenFromLoads {
  SeenFromLoads(double along, double across);

  double alpha, depth;
  double near_face, far_face;    ///< 1 - depth, 1 + depth
  double near, far;              ///< distances from the loads
  double near_share, far_share;  ///< distance from the face over the square of that from the load
  double shares_apart;           ///< near_share - far_share, relatively accurate
};

/// The stresses of two half-planes, each under the load on its own face (Flamant).
SheetStresses half_plane_stresses(const SeenFromLoads& at, data::SheetLoad load);

/// What the sheet's stresses are beside them under either load, analytic up to a distance of 2 from the sheet. It is
/// minus theirs where the sheet's have faded.
struct StressesBeside {
  SheetStresses normal, shear;
};
/// What loads on one side of a place have in sum, none nearer to it than near_load_end.
struct FarLoads {
  AlongWaves pressure, shear;  ///< e^{i alpha z_n} times each load, alpha its distance
  double shear_force;
};

/// At one depth from -1 to 1.
class StressesAtDepth {
 public:
  explicit StressesAtDepth(double depth);
  /// At any finite alpha.
  [[nodiscard]] StressesBeside beside(double alpha) const;
  /// The whole of the stresses under far loads, half-planes included; side: 1 if they are at smaller alpha, else -1.
  [[nodiscard]] SheetStresses far(const FarLoads& loads, double side) const;

 private:
  double depth_;
  AcrossWaves waves_;
};

/// What belongs to them of the parts of u and v, in the kernels' terms; see field_functions.hpp.
struct HalfPlaneParts {
  double first, second;  ///< the factors of theta2/N (or 1) and of theta1/N
};
HalfPlaneParts half_plane_u(const SeenFromLoads& at, data::SheetLoad load);
HalfPlaneParts half_plane_v(const SeenFromLoads& at, data::SheetLoad load);

}  // namespace nipref::fast::internal
