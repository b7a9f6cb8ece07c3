#pragma once
#include <memory>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// A rigid sphere that rolls without slip, in multiprecision, by the papers' rule from the response of the surface along
// lines. Errors are estimated.
//
//   digits      16 to 100, else BadInput; results have a relative error of at most 10^-digits
//   degrees     angle of a line from the motion

/// P = ln((1 + q)/(1 - q))/(2 pi), q = S/sqrt(K K_nn), the index of the oscillating tractions at the ends of a line
/// under rolling without slip. (brock2012 43b)
Estimate rolling_index(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// The same of a line beyond the Rayleigh speed, where K, K_nn and S are negative and -q > 1: ln((|q| + 1)/(|q| -
/// 1))/(2 pi), the index of tractions that jump at the ends. (brock2012 56)
Estimate rolling_index_beyond(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// L(psi)/L(0) of a rolling sphere whose span along the motion is not small against its radius, the root that goes with
/// the span: L (sqrt(wS/wD) - P L/(2 r0)) Q is the same on all lines. BadInput "span_over_radius" where there is none.
/// (brock2012 52, signs corrected)
Estimate rolling_finite_span_ratio(const SurfaceAnswer& surface, const Exact& degrees,
                                   const Exact& span_over_radius, int digits);

/// L(psi)/L(0) of a rolling sphere by the papers' rule, to first order in span over radius: the amplitudes at the
/// centre, whose squares are proportional to K_nn/K/(K K_nn - S^2), are equal. (brock2012 53)
Estimate rolling_span_ratio(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// exp(-pi/(2P)) of a line; 0 where P = 0. (brock2012 50)
Estimate rolling_strip(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// F3 r0/L^3, L the span along the motion, unit of stress, to first order in L/r0: negative just below the Rayleigh
/// speed. (brock2012 54)
Estimate rolling_force(const SurfaceAnswer& surface, int digits);

/// V0 of a line, on which du/dx = -V0 + x^2/(2 r0^2). span_over_radius > 0 is that along the motion; BadInput "span"
/// for a contact that is not small against the radius. (brock2012 40, 48 with the sign of P corrected)
Estimate rolling_creep(const SurfaceAnswer& surface, const Exact& degrees, const Exact& span_over_radius,
                       int digits);

/// A rolling sphere, whose radius is an exact number, under a load, to first order in span over radius as in the paper.
/// With force = factor span^3 the span for a given force follows in closed form.
class RollingSphere {
 public:
  /// The integral over the lines is computed when it is first needed. BadInput "digits" where it does not converge,
  /// "speed" where a force is given and the resultant of the tractions is tensile, just below the Rayleigh speed.
  RollingSphere(SurfaceAnswer surface, double radius, const HalfSpaceLoad& load, int digits);

  [[nodiscard]] Estimate span(const Exact& degrees) const;        ///< L(psi), unit of length
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;  ///< L(psi)/L(0)
  [[nodiscard]] Estimate force() const;                           ///< (brock2012 54)
  // BadInput "span" for a contact that is not small against the radius.
  [[nodiscard]] Estimate peak_pressure() const;  ///< at the centre
  /// The tractions at x on a line, 0 outside the contact; the shear is that along the line. (brock2012 49, corrected)
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
