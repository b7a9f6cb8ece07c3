#pragma once
#include <memory>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/number/accuracy.hpp>
#include <nipref/fast/number/two_words.hpp>

namespace nipref::fast {

/// Displacements of the surface of a viscoelastic sheet under unit line loads that press on both sides and
/// move along it with constant speed: thesis (6.23)-(6.28), corrected. Any consistent units.
///
///   t          time since the load started, >= 0
///   T, t0      times at which the load passes the point and the pinned point, of either sign: the point is
///              alpha = F0 (T - t)/b half-thicknesses ahead of the load, the pinned point eta = F0 (t0 - t)/b
///   accuracy   max(8 units in the last place, rtol) of the scale, for rates up to 1e12 F0/b. For the scale, the
///              sums and integrals take the amplitudes' magnitudes and, as kernels, max(|kernel|, envelope).
///              A complex rate adds a few roundings for each radian of its oscillation before it has decayed.
///              Results below 1e-290 have an absolute error of up to 1e-305
///   cost       Un: half a microsecond for a real rate, twice as much just behind the load; Vn: a few microseconds.
///              Complex rates are integrated by panels: tens of microseconds, more if they oscillate often
///   bad input  nan, infinite, t < 0, more than 1e100 b/F0 between two of 0, t and T or t0, and a point under the
///              load, where Un is infinite: data::BadInput
class MovingLoad {
 public:
  /// speed: F0 > 0, length/time. half_thickness: b > 0, length. Anything else: BadInput.
  MovingLoad(const data::ViscoelasticMaterial& material, double speed, double half_thickness,
             Accuracy accuracy = {});

  /// Un, the normal displacement towards the middle plane, 1/stress.
  [[nodiscard]] double normal_displacement(double t, double T) const;

  /// Vn, the displacement along the sheet relative to the pinned point, 1/stress.
  [[nodiscard]] double tangential_displacement(double t, double T, double t0) const;

  /// Un and Vn of a load that has moved by `way` >= 0 half-thicknesses, with alpha and eta given: as accurate however
  /// much longer the way is than these distances. Each of them and its sum with the way is at most 1e100.
  [[nodiscard]] double normal_displacement_after(double way, double alpha) const;
  [[nodiscard]] double tangential_displacement_after(double way, double alpha, double eta) const;

  /// Un of a load that started infinitely long ago. alpha: either sign, not 0.
  [[nodiscard]] double steady_normal_displacement(double alpha) const;

  /// Vn of a load that started infinitely long ago.
  [[nodiscard]] double steady_tangential_displacement(double alpha, double eta) const;

 private:
  struct LoadPath;
  struct Fades;
  [[nodiscard]] LoadPath load_path(const char* name, double t, double T) const;
  [[nodiscard]] LoadPath path_after(double way, const char* name, double alpha) const;
  [[nodiscard]] LoadPath steady_path(double alpha) const;
  [[nodiscard]] double normal_displacement(const LoadPath& load_path) const;
  [[nodiscard]] double tangential_displacement(const LoadPath& to_point, const LoadPath& to_pin) const;

  data::MaterialFunctions functions_;
  data::MaterialFunction normal_;
  internal::Two way_per_time_, time_unit_;  ///< F0/b and b/F0
  Accuracy accuracy_;
  std::shared_ptr<const Fades> fades_;
};

}  // namespace nipref::fast
