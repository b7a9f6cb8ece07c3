#pragma once
#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// The tractions on the line through the point of first touch in one direction, |x| < L/2:
///   sigma33 = -amplitude/cos(Phi) sqrt(L^2 - 4x^2) cos(P ln((L-2x)/(L+2x)) + Phi),
///   tau = shear_share amplitude/cos(Phi) sqrt(L^2 - 4x^2) sin(P ln((L-2x)/(L+2x)) + Phi),
/// tan(Phi) = x/(2 r0 B), B = sqrt(wS/wD) - P L/(2 r0). The tractions oscillate at the ends. (brock2012 49 with the
/// signs of P, Phi and tau corrected)
struct RollingLine {
  double span;         ///< L, unit of length
  double index;        ///< P of (brock2012 43b)
  double lean;         ///< 2 r0 B: x for which Phi is 45 degrees, unit of length
  double amplitude;    ///< unit of stress/length
  double shear_share;  ///< sqrt(wD/wS)
  /// V0: the surface moves along the line by du/dx = -V0 + x^2/(2 r0^2). (brock2012 40, 48 corrected)
  Estimate creep;
  double uncertainty;  ///< estimate of the error of span and amplitude, relative

  /// sigma33, < 0 if compressive, unit of stress, 0 outside the contact; x finite, BadInput otherwise.
  [[nodiscard]] Estimate normal_traction(double x) const;
  /// tau along the line; unit, domain and bad input as above.
  [[nodiscard]] Estimate shear_traction(double x) const;
  /// r_C: the normal traction is compressive for |x| < r_C if L is small compared with r0. (brock2012 50)
  [[nodiscard]] Estimate compressed_radius() const;

 private:
  enum class Wave { cosine, sine };
  [[nodiscard]] Estimate traction(double x, Wave wave) const;
};

/// A rigid sphere that rolls without slip on an isotropic half-space, as constructed in the paper: on every line
/// through the point of first touch the surface has the sphere's slope and stretch, and the spans make the force
/// stationary, both to first order in L/r0. (brock2012 37-54) This construction does not solve the contact problem, and
/// it defines no approach of the bodies.
class RollingSphere {
 public:
  [[nodiscard]] Estimate span() const { return span_; }    ///< L1, along the motion, unit of length
  [[nodiscard]] Estimate force() const { return force_; }  ///< F3, compressive (brock2012 54)
  /// L(psi)/L1 (brock2012 53a); across the motion it is 53b without the c_D under its root. The argument is psi
  /// relative to the motion, of unit length.
  [[nodiscard]] Estimate span_ratio(Direction from_motion) const;
  /// The pressure at the centre, which is the same on every line; unit of stress.
  [[nodiscard]] Estimate peak_pressure() const;
  [[nodiscard]] RollingLine along(Direction from_motion) const;
  // Results on the line in the direction psi from the motion.
  [[nodiscard]] Estimate span(Direction psi) const { return span_ratio(psi) * span_; }  ///< L(psi)
  [[nodiscard]] Estimate pressure(Direction psi, double x) const {
    return -1 * along(psi).normal_traction(x);
  }
  [[nodiscard]] Estimate shear(Direction psi, double x) const { return along(psi).shear_traction(x); }
  [[nodiscard]] Estimate creep(Direction psi) const { return along(psi).creep; }
  [[nodiscard]] Estimate compressed_radius(Direction psi) const { return along(psi).compressed_radius(); }

 private:
  struct Shape;
  RollingSphere(const data::IsotropicSolid& solid, double radius, double speed);
  [[nodiscard]] Shape shape(Direction from_motion) const;
  [[nodiscard]] Estimate force_factor() const;

  data::IsotropicSolid solid_;
  double radius_, speed_;
  double stiffness_along_ = 0;
  Estimate span_{}, force_{};
  friend RollingSphere rolling_sphere_for_span(const data::IsotropicSolid&, double, double, double);
  friend RollingSphere rolling_sphere_for_force(const data::IsotropicSolid&, double, double, double);
};

/// The sphere of `radius` > 0 rolling at 0 <= speed < v_R, unit of sqrt(shear/density), with the span L1 > 0 along the
/// motion, in the unit of the radius. All must be finite, else BadInput. The paper's linearisation requires a span that
/// is small compared with the radius; `along` checks only that B > 0.
RollingSphere rolling_sphere_for_span(const data::IsotropicSolid& solid, double radius, double speed,
                                      double span);

/// The rolling sphere with the force F3 > 0; otherwise like rolling_sphere_for_span. BadInput also if the resultant of
/// the oscillating tractions is tensile, within 1e-4 of the Rayleigh speed, where rolling_sphere_for_span gives F3 < 0.
RollingSphere rolling_sphere_for_force(const data::IsotropicSolid& solid, double radius, double speed,
                                       double force);

/// s = exp(-pi/(2P)). On a line of span L the normal traction of a rolling sphere may be tensile over the outermost
/// L/2 - r_C = s L/(1 + s) at either end. The error is one or two units in the last place for every P, as ln s has two
/// words. s is 0 if it is below the smallest double, as at P = 0. Arguments and bad input are as for
/// isotropic_response(). (brock2012 50)
double rolling_strip(const data::IsotropicSolid& solid, double speed, Direction from_motion);

/// Psi_R, in radians: between the speeds of Rayleigh waves and of shear waves, the paper's tractions are tensile on
/// lines within this angle of the motion, so that the bodies separate there. A rolling sphere itself is solved below
/// the Rayleigh speed only. `speed` is relative to v_S, from the Rayleigh speed to 1, and -1 < poisson < 1/2, else
/// BadInput. Accuracy: a few units in the last place of the larger of the angle and 1e-7. (brock2012 55)
double separation_angle(double poisson, double speed);

}  // namespace nipref::fast
