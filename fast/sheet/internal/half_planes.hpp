#pragma once
#include <nipref/data/problem/sheet_load.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/field_functions.hpp>
#include <nipref/fast/sheet/internal/theta_shares.hpp>

namespace nipref::fast::internal {

/// A point with alpha >= 0, 0 <= depth <= 1, by its distances from each load and from the load's face.
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

/// The sheet's stresses less those of the half-planes, under either load. They are analytic up to a distance of 2
/// from the sheet; far from the load, where the sheet's stresses have decayed, they are minus the half-planes'
/// stresses.
struct StressesBeside {
  SheetStresses normal, shear;
};
/// Sums over the loads on one side of a point, none of them closer to it than near_load_end.
struct FarLoads {
  AlongWaves pressure, shear;  ///< e^{i alpha z_n} times each load, alpha its distance
  double shear_force;
};

/// The stresses at one depth from -1 to 1.
class StressesAtDepth {
 public:
  explicit StressesAtDepth(double depth);
  /// For any finite alpha.
  [[nodiscard]] StressesBeside beside(double alpha) const;
  /// The stresses under far loads, half-planes included; `side` is 1 if the loads are at smaller alpha, else -1.
  [[nodiscard]] SheetStresses far(const FarLoads& loads, double side) const;

 private:
  double depth_;
  AcrossWaves waves_;
};

/// What the displacements u along +x and v along +y, over theta1 + theta2, have at a depth 0 <= s <= 1 beyond s times u
/// and once v of the face at the same alpha. It decays like the stresses: what loads displace far away is a shift along the
/// sheet and a uniform strain.
struct FromFace {
  double u, v;
};
struct FromFaceBeside {
  FromFace normal, shear;
};
class DisplacementsFromFace {
 public:
  DisplacementsFromFace(double depth, const Shares& share);
  /// Less that of both half-planes, for any finite alpha, see StressesBeside.
  [[nodiscard]] FromFaceBeside beside(double alpha) const;
  /// Of far loads, see StressesAtDepth.
  [[nodiscard]] FromFace far(const FarLoads& loads, double side) const;

 private:
  double depth_;
  Shares share_;
  AcrossWaves waves_, of_face_;
};

/// The half-planes' contributions to the parts of u and v, in terms of the kernels; see field_functions.hpp.
struct HalfPlaneParts {
  double first, second;  ///< the factors of theta2/N (or 1) and of theta1/N
};
HalfPlaneParts half_plane_u(const SeenFromLoads& at, data::SheetLoad load);
HalfPlaneParts half_plane_v(const SeenFromLoads& at, data::SheetLoad load);

}  // namespace nipref::fast::internal
