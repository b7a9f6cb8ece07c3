#pragma once
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// Directions over half a turn for the trapezoidal rule, in a variable u for integrands that are functions of T =
/// tan(psi - centre) with singularities at T = i y, smallest <= |y| <= largest: T = smallest sc(u, k), k' =
/// smallest/largest. All these singularities have |Im u| = K(k') >= pi/2. The period 2 K(k) grows only with the
/// logarithm of k', so that the number of directions does, too, near critical lines and for slender ellipses.
class CrowdedDirections {
 public:
  /// 0 < smallest <= 1 <= largest; the centre in degrees.
  CrowdedDirections(const Exact& centre, const Float& smallest, const Float& largest);

  struct Direction {
    Exact degrees;
    Float cosine, sine;
    Float weight;  ///< dpsi/du times the period: its mean over the directions is int dpsi
  };
  /// The i-th of `count` directions; it is the 2 i-th of 2 count directions.
  [[nodiscard]] Direction at(long i, long count) const;

 private:
  [[nodiscard]] Float sc(const Float& u) const;  ///< 0 <= u <= K/2, to rounding

  Exact centre_;
  Float smallest_, complement_;  ///< k'
  Float quarter_, conjugate_;    ///< K(k), K(k')
};

/// The direction, in degrees, in which the compliance is largest, and the half width of this peak at half its height,
/// in radians and at most 1, which is about the distance of the nearest singularity. By parabolas from a scan of 1/K, which
/// is smooth even close to the critical speed.
struct PeakOfCompliance {
  double degrees, width;
};
PeakOfCompliance peak_of_compliance(const SurfaceAnswer& surface);

}  // namespace nipref::ref
