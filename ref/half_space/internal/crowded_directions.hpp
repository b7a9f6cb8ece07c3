#pragma once
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/internal/float.hpp>

namespace nipref::ref {

/// Directions over half a turn for the trapezoidal rule in u, at which functions of T = tan(psi - centre) with
/// singularities at T = i y, smallest <= |y| <= largest, are evenly easy: T = smallest sc(u, k), k' =
/// smallest/largest. All of these singularities lie |Im u| = K(k') >= pi/2 off, and the period is 2 K(k), which
/// grows with the logarithm of k' only: near critical lines and for slender ellipses as for round ones.
class CrowdedDirections {
 public:
  /// 0 < smallest <= 1 <= largest; the centre in degrees.
  CrowdedDirections(const Exact& centre, const Float& smallest, const Float& largest);

  struct Direction {
    Exact degrees;
    Float cosine, sine;  ///< of it
    Float weight;        ///< dpsi/du times the period: its mean over the directions is int dpsi
  };
  /// The i-th of so many; those of even number come again in twice as many.
  [[nodiscard]] Direction at(long i, long count) const;

 private:
  [[nodiscard]] Float sc(const Float& u) const;  ///< 0 <= u <= K/2, to rounding

  Exact centre_;
  Float smallest_, complement_;  ///< k'
  Float quarter_, conjugate_;    ///< K(k), K(k')
};

/// Where the compliance is largest, in degrees, and how far off it is half of that, in radians but at most 1:
/// the smallest singularity that it has about there. By a scan of 5 degrees of 1/K, which is smooth however
/// near the critical speed is, and parabolas; 16 digits of the surface are enough.
struct PeakOfCompliance {
  double degrees, width;
};
PeakOfCompliance peak_of_compliance(const SurfaceAnswer& surface);

}  // namespace nipref::ref
