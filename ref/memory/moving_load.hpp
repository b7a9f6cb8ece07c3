#pragma once
#include <optional>

#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// Error bounds of a distance, in half thicknesses, now and at the start: of the load from the point, or of the fixed
/// point from the load.
struct PathError {
  mpq_class alpha, start;
};

/// Error bounds of a moving load.
struct MovingLoadError {
  PathError load, fixed_point;
  mpq_class memory;  ///< of the relative errors of amplitudes and rates of the memory, below 1/2
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
/// the fixed point of the centre line; half_thickness > 0, any consistent units. In each of the times T, t0, T - t and
/// t0 - t the load moves by at most 1000 half thicknesses, if the material has fractions by at most 250. The rates of
/// the material are at most 1e100 speed/half_thickness. Results are in 1/stress for a unit load per length. A value
/// takes milliseconds, with fractions tens of milliseconds.
///
/// Definition: with alpha = speed (T - t)/half_thickness and eta = speed (t0 - t)/half_thickness,
///
///     pi Un = N * I1(alpha),
///     pi Vn = N * I3(alpha) - theta2 * I2(alpha) + theta2 * I4(eta) - theta1 * I5(eta),
///
/// theta * I(alpha) = int_0^t theta(t - tau) I(speed (T - tau)/half_thickness) dtau. (thesis 6.18, 6.23-6.28)
///
/// residue_terms: 0 for the kernels themselves, or 1 to 500 for the sum of this many residues of each kernel, as in the
/// thesis. The error is then the error of this sum, without the sum's truncation error.
///
/// Every displacement promises an Enclosure; digits 16 to 1000. The bound is proven: see kernels.hpp for the
/// instantaneous response and fading.hpp for the memory. Bad arguments throw data::BadInput.
class MovingLoad {
 public:
  MovingLoad(ExactMaterial material, const Exact& speed, const Exact& half_thickness, int residue_terms = 0);

  /// Normal displacement; t != T.
  [[nodiscard]] Enclosure normal_displacement(const Exact& t, const Exact& T, int digits) const;
  /// Tangential displacement relative to the fixed point. At T = t, where it jumps, the value is the mean of both sides
  /// (sign(0) = 0); at t0 = t it is continuous.
  [[nodiscard]] Enclosure tangential_displacement(const Exact& t, const Exact& T, const Exact& t0,
                                                  int digits) const;
  /// The displacements under a load that started infinitely long ago. It is alpha half thicknesses behind the point,
  /// which it has not passed yet if alpha > 0, and eta behind the fixed point; |alpha|, |eta| <= 1000.
  [[nodiscard]] Enclosure steady_normal_displacement(const Exact& alpha, int digits) const;
  [[nodiscard]] Enclosure steady_tangential_displacement(const Exact& alpha, const Exact& eta,
                                                         int digits) const;

  /// Proven bounds of the change of a displacement by such errors: ref/memory/README.md, What a displacement changes
  /// by. The material has no fractions. BadInput "y" if the load may be over the point.
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
