#pragma once
#include <optional>

#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// What is not known of the distances, in half thicknesses: of the load from the point (or of the fixed point from the
/// load) now and at the start.
struct PathError {
  mpq_class alpha, start;
};

/// What is not known of a moving load: besides distances a share of every amplitude and rate of the memory, below 1/2.
struct MovingLoadError {
  PathError load, fixed_point;
  mpq_class memory;
};

/// The load's path relative to a point of the surface, in half thicknesses: the load is at the distance `alpha`
/// before the point now, and was at the distance `start` when it started, if it ever did.
struct LoadPath {
  Exact alpha;
  std::optional<Exact> start;
};

/// Displacements of the surface of a viscoelastic sheet under a pair of opposite unit line loads that move at
/// `speed` > 0 over the sheet, which was at rest before.
///
/// t >= 0 is the time since the load started, T the time at which it passes the point, t0 the time at which it passes
/// the fixed point of the centre line; half_thickness > 0, any consistent units. The load's displacements in T, t0, T
/// - t and t0 - t are at most 1000 half thicknesses. Results are in 1/stress for a unit load per length. A material's
/// rates are at most 1e100 speed/half_thickness; with fractions the displacements are at most 200. A value takes
/// milliseconds, with fractions tens of milliseconds.
///
/// Definition: with alpha = speed (T - t)/half_thickness and eta = speed (t0 - t)/half_thickness,
///
///     pi Un = N * I1(alpha),
///     pi Vn = N * I3(alpha) - theta2 * I2(alpha) + theta2 * I4(eta) - theta1 * I5(eta),
///
/// theta * I(alpha) = int_0^t theta(t - tau) I(speed (T - tau)/half_thickness) dtau. (thesis 6.18, 6.23-6.28)
///
/// residue_terms: 0, or 1 to 500 for the sum of this many residues of each kernel, as in the thesis; the error is
/// then that of the sum's value, without its truncation error.
///
/// Every displacement promises an Enclosure; digits 16 to 1000. The bound is proven: see kernels.hpp for the instantaneous
/// response, fading.hpp for the memory. Bad arguments throw data::BadInput.
class MovingLoad {
 public:
  MovingLoad(ExactMaterial material, const Exact& speed, const Exact& half_thickness, int residue_terms = 0);

  /// Normal displacement; t != T.
  [[nodiscard]] Enclosure normal_displacement(const Exact& t, const Exact& T, int digits) const;
  /// Tangential displacement relative to the fixed point. At T = t, where it jumps, the value is the mean of both sides
  /// (sign(0) = 0); at t0 = t it is continuous.
  [[nodiscard]] Enclosure tangential_displacement(const Exact& t, const Exact& T, const Exact& t0,
                                                  int digits) const;
  /// The same displacements for a load that started infinitely long ago and is alpha half thicknesses behind the point (alpha
  /// > 0: the load has not passed it yet) and eta behind the fixed point; |alpha|, |eta| <= 1000.
  [[nodiscard]] Enclosure steady_normal_displacement(const Exact& alpha, int digits) const;
  [[nodiscard]] Enclosure steady_tangential_displacement(const Exact& alpha, const Exact& eta,
                                                         int digits) const;

  /// Bounds of what a displacement changes by within such errors, proven: ref/memory/README.md, Moving loads. The material
  /// has no fractions. BadInput "y" where the load may be over the point.
  [[nodiscard]] Interval normal_change(const Exact& t, const Exact& T, const MovingLoadError& error) const;
  [[nodiscard]] Interval tangential_change(const Exact& t, const Exact& T, const Exact& t0,
                                           const MovingLoadError& error) const;
  /// N of the material.
  [[nodiscard]] const ExactFunction& normal() const { return normal_; }

 private:
  [[nodiscard]] Enclosure normal_at(const LoadPath& alpha, int digits) const;
  [[nodiscard]] Enclosure tangential_at(const LoadPath& alpha, const LoadPath& eta, int digits) const;

  ExactMaterial material_;
  ExactFunction normal_;
  mpq_class travel_rate_;  ///< speed over half_thickness
  int residue_terms_;
};

}  // namespace nipref::ref
