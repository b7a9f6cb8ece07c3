#pragma once
#include <variant>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>

namespace nipref::fast {

/// Displacements by a moving unit load, plain sums or exact, with lengths in half-thicknesses and times in
/// b/speed: t since it started, T when it passes the point, t0 when it passes the pinned point.
class ViscoelasticSheet {
 public:
  /// residue_terms: of the plain sums; 0: exact. smallest_term: see PlainMovingLoad.
  ViscoelasticSheet(const data::ViscoelasticNip& nip, int residue_terms, double smallest_term = 0);

  /// Null if the displacements are exact.
  [[nodiscard]] const PlainMovingLoad* plain() const { return std::get_if<PlainMovingLoad>(&load_); }
  /// theta1 + theta2 at once, 1/stress.
  [[nodiscard]] double compliance() const { return compliance_; }
  [[nodiscard]] double normal_displacement(double t, double T) const;
  [[nodiscard]] double tangential_displacement(double t, double T, double t0) const;

 private:
  double compliance_;
  double time_;  ///< b/speed in what the exact load is given, whose times have a unit
  std::variant<MovingLoad, PlainMovingLoad> load_;
};

}  // namespace nipref::fast
