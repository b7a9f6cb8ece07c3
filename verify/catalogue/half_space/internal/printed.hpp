#pragma once
#include <optional>

#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/response.hpp>

namespace nipref::verify {

// Formulas of the half-space papers that are WRONG, or correct ones with the rounding of the papers' tables. They are used
// only to replay the tables; the correct formulas are in fast. "as printed" means by the paper's equation, "as tabulated"
// by the formula that gives the numbers of the paper's table. Speeds are relative to the shear wave speed of the isotropic
// solid. The domain is that of the papers' tables.

/// (brock2012 35) as printed, C2 L2/(C1 L1). Wrong: sqrt(c_D^4 + gamma^2) should be c_D^2, because friction
/// does nothing across the motion.
double die_span_ratio_as_printed(double poisson, double friction, double speed);

/// The formula of (brock2012) Table 1: with the wrong root of (35), and without friction in Delta_1 and Q_1.
/// `decimals`: the number of decimals to which the roots w_S and w_D are rounded.
double die_span_ratio_as_tabulated(double poisson, double friction, double speed,
                                   std::optional<int> decimals);

/// (brock2012 53b) as printed, L2/L1. Wrong: a factor c_D under the second root; it is not 1 at rest.
double rolling_span_ratio_as_printed(double poisson, double speed);

/// (brock2012 53b) without that factor, which is right, but with the roots w_S and w_D rounded to `decimals`.
double rolling_span_ratio_as_tabulated(double poisson, double speed, int decimals);

/// mu times the displacement in its own direction that a shear load along or across a line causes, with (N1, N2) of
/// (brock2012 39a) as printed. Wrong: M is subtracted instead of R, so that 0 is left along the line. `degrees`: angle
/// from the direction of motion.
double in_line_as_printed(double poisson, double speed, double degrees);
double across_as_printed(double poisson, double speed, double degrees);

/// V0 of (brock2012 48) as printed, on the line at `degrees` of a contact with the span L1 = `span` r0 along the motion.
/// Wrong: the sign of P.
double rolling_creep_as_printed(double poisson, double speed, double degrees, double span);

/// The moduli of a half-space over the shear modulus mu_0 of the sphere on it, as in the paper.
struct ScaledModuli {
  double c11, c33, c13, c44, c66;
  double speed_scale;        ///< c/c_0 = sqrt(rho/rho_0)
  double sphere_dilatation;  ///< c_D of the sphere
};

ScaledModuli scaled_moduli(const data::TransverselyIsotropicSolid& half_space,
                           const data::IsotropicSolid& sphere);

/// (brock2013 35) with (25c) as printed, L_Y/L_X, axis normal; Table 1 was made with it. Wrong: c_D^2 - 1
/// also divides the term of the half-space, and the couplings of the two bodies are added where they
/// subtract.
double sphere_span_ratio_as_printed(const ScaledModuli& moduli, double friction, double speed);

/// Omega of (brock2013 29a) with (25c) as printed, axis normal. Wrong: the couplings are added. `cosine`: of psi - theta.
double sphere_exponent_as_printed(const ScaledModuli& moduli, double friction, double speed, double cosine);

/// F3 r0/(mu0 L_X^3) of (brock2013 36) with (25c) as printed, axis normal. Wrong: that, 1/Q^2 for 1/Q^3, the exponents
/// of the pressure interchanged and the limits with them.
double sphere_force_as_printed(const ScaledModuli& moduli, double friction, double speed);

/// The same of (brock2013 47) with (43) as printed, axis in the surface, no friction.
double in_plane_force_as_printed(const ScaledModuli& moduli, fast::Direction motion, double speed);

/// The number of decimals to which w_S and w_D were rounded for (brock2012) Tables 1 and 2. It was found by trial: with it
/// all cells of both tables but one agree within a unit of the last digit.
inline constexpr int table_root_decimals = 5;

/// mu_0 K of the sphere, by (brock2013 20). `cosine_from_motion`: of psi - theta.
double sphere_compliance(const ScaledModuli& moduli, double cosine_from_motion, double speed);

/// The forms of (brock2013 43) with the axis in the surface along x2. Both lack 2 A6 T5 (d6 + d12) sin^2(psi)/d1; as printed the
/// first term of M needs a minus sign, too, and the other form is the formula that gives Table 3.
enum class InPlaneForm { printed, tabulated };

/// mu_0 K of the half-space by such a form.
double in_plane_compliance(InPlaneForm form, const ScaledModuli& moduli, fast::Direction line,
                           double cosine_from_motion, double speed);
/// The span at `phi` from the motion over that along it by such a form, degrees, without friction; theta is the motion's.
double in_plane_span_ratio(InPlaneForm form, const ScaledModuli& moduli, double theta, double phi,
                           double speed);

/// d6 + P - P6 of (brock2013 46b) with P6 of (46d) as printed. Wrong: it is negative, c_minus complex.
double branch_radicand_as_printed(const ScaledModuli& moduli, fast::Direction motion);

}  // namespace nipref::verify
