#pragma once
#include <memory>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// A rigid sphere that rolls without slip, in multiprecision. By the rule of brock2012, the tractions on each line of
// the contact follow from the response of the surface along this line alone. Errors are estimated.
//
//   digits      16 to 100, else BadInput; results have a relative error of at most 10^-digits; BadInput "speed" where
//               S^2 is within 1e-32 of K K_nn, as at the critical speed
//   degrees     angle of a line from the motion
//
// K, S and K_nn are compliance, coupling and in_line of a line, see LineResponse, and wS/wD = K_nn/K. L(psi) is the
// span, the length of the contact on a line, and r0 the radius of the sphere.

/// P = ln((1 + q)/(1 - q))/(2 pi), q = S/sqrt(K K_nn), dimensionless: the index of the tractions under rolling without
/// slip, which oscillate at the ends of a line. (brock2012 43b)
Estimate rolling_index(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// ln((|q| + 1)/(|q| - 1))/(2 pi), the index of a line beyond the Rayleigh speed, on which K, K_nn and S are negative
/// and -q > 1. The tractions jump at the ends of this line. (brock2012 56)
Estimate rolling_index_beyond(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// L(psi)/L(0) of a rolling sphere whose span along the motion is not small compared with its radius. L (sqrt(wS/wD) -
/// P L/(2 r0)) Q, Q = 1/sqrt(K K_nn - S^2), is the same on all lines. Of the two roots L(psi) this is the one that
/// vanishes with L(0). BadInput "span" or "span_over_radius" if there is none. (brock2012 52, signs corrected)
Estimate rolling_finite_span_ratio(const SurfaceAnswer& surface, const Exact& degrees,
                                   const Exact& span_over_radius, int digits);

/// L(psi)/L(0) of a rolling sphere to first order in span over radius: the amplitudes at the centre, proportional to
/// L sqrt(K_nn/K/(K K_nn - S^2)), are equal on all lines. (brock2012 53)
Estimate rolling_span_ratio(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// exp(-pi/(2P)) = (L/2 - r_C)/(L/2 + r_C) of a line with the compressed radius r_C; 0 where P <= 0. (brock2012 50)
Estimate rolling_strip(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// F3 r0/L(0)^3, unit of stress, to first order in L/r0. It is negative just below the Rayleigh speed. (brock2012 54)
Estimate rolling_force(const SurfaceAnswer& surface, int digits);

/// The creep V0 of a line, on which du/dx = -V0 + x^2/(2 r0^2). span_over_radius = L(0)/r0 > 0; BadInput "span" for a
/// contact that is not small compared with the radius. (brock2012 40, 48 with the sign of P corrected)
Estimate rolling_creep(const SurfaceAnswer& surface, const Exact& degrees, const Exact& span_over_radius,
                       int digits);

/// A rolling sphere under a load, to first order in span over radius, as in brock2012. The doubles of radius and load
/// are taken as exact numbers. As force = factor span^3, the span for a given force follows in closed form.
class RollingSphere {
 public:
  /// The integral over the lines is computed when it is first needed. BadInput "digits" if it does not converge,
  /// "speed" if a force is given and the resultant of the tractions is tensile, as just below the Rayleigh speed.
  RollingSphere(SurfaceAnswer surface, double radius, const HalfSpaceLoad& load, int digits);

  [[nodiscard]] Estimate span(const Exact& degrees) const;        ///< L(psi), unit of length
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;  ///< L(psi)/L(0)
  [[nodiscard]] Estimate force() const;                           ///< (brock2012 54)
  // The next functions throw BadInput "span" for a contact that is not small compared with the radius.
  [[nodiscard]] Estimate peak_pressure() const;  ///< at the centre
  /// Pressure and shear along the line at x on a line, 0 outside the contact. (brock2012 49, corrected)
  [[nodiscard]] Estimate pressure(const Exact& degrees, const Exact& x) const;
  [[nodiscard]] Estimate shear(const Exact& degrees, const Exact& x) const;
  [[nodiscard]] Estimate creep(const Exact& degrees) const;  ///< V0 (brock2012 48)
  [[nodiscard]] Estimate compressed_radius(
      const Exact& degrees) const;  ///< r_C, unit of length (brock2012 50)

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::ref
