#pragma once
#include <vector>

#include <nipref/ref/elastic_nip/internal/grip_expansion.hpp>
#include <nipref/ref/number/internal/complex_float.hpp>

namespace nipref::ref {

/// How waves fade along a strip of half-thickness 1 between gripped faces, where pressure and displacements are the same
/// above and below: like e^(-rate y), the rates half the zeros x of (3 - 4 poisson) sin x = x.
struct GripWaves {
  Float slowest;                     ///< zeta, real
  std::vector<ComplexFloat> faster;  ///< the next ones, imaginary parts > 0

  explicit GripWaves(const Float& poisson);
};

/// Shear at the distance s from an end of a gripped contact, less the waves that come from the other end: like the waves
/// that leave, linear in 1, A and the size of the slow one that comes. All in units of ThinGrippedNip.
class EndShear {
 public:
  /// The contact's half length is A >= 5.
  EndShear(GripExpansion contact, double half_length, const Float& poisson, const GripWaves& waves);

  /// s > 0, such that A - s is a double. What the contact is too short for is what its waves make of it.
  [[nodiscard]] Float at(double s) const;
  /// Of it, the slow wave: what the other end feels, with the other sign.
  [[nodiscard]] Float slow_wave_at(const Float& distance) const;

 private:
  [[nodiscard]] Float in_contact(double y) const;
  /// At a distance from the end that they come from, the slowest first.
  [[nodiscard]] std::vector<Float> waves_at(const Float& distance) const;
  [[nodiscard]] Float sum_of_waves_at(const Float& distance) const;

  GripExpansion contact_;
  double half_length_;
  Float slope_;
  GripWaves waves_;
  std::vector<Float> sizes_;
};

}  // namespace nipref::ref
