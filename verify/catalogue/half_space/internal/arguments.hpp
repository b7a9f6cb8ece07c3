#pragma once
#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/verify/catalogue/named_point.hpp>

namespace nipref::verify {

// Conversion of the catalogue's arguments about half-spaces to the arguments of both paths.

/// The solid with mu = 1 and density 1, so that speeds are v/v_S.
data::IsotropicSolid unit_isotropic(double poisson);
ref::ExactStiffness exact_isotropic(const ref::Exact& poisson);
/// The response of a half-space with mu = 1 and density 1; angles are measured from the direction of motion.
fast::SurfaceResponse isotropic_surface(double poisson, double speed);
/// BadInput unless the speed is below that of Rayleigh waves.
ref::SurfaceAnswer exact_isotropic_surface(const ref::Exact& poisson, const ref::Exact& speed);
ref::LineAnswer line_answer(const ref::LineResponse& of);

fast::Direction direction_of(const NamedPoint& x, const char* degrees);
ref::SurfaceDirection direction_of(const NamedExact& x, const char* degrees);

// Units are those of the seed's steel: its mu for stress, its v_S for speed. (brock2013 section 3)

/// The exact value of a constant as it is written in decimal: 77.2 is not a double.
ref::Exact as_written(double constant);

// Arguments of a transversely isotropic solid: c11, c33, c13, c44, c66 (GPa) and density (kg/m^3), by default those of
// the seed's graphite epoxy, and axis, the direction of its axis relative to the surface.

data::SymmetryAxis symmetry_axis(const auto& x) {
  return x.choice("axis") == 0 ? data::SymmetryAxis::normal : data::SymmetryAxis::in_plane;
}
/// The solid in the units in which it is given, so that no constant is rounded.
data::TransverselyIsotropicSolid transverse_of(const NamedPoint& x);
/// The half-space under loads that move at `speed` times steel's shear wave speed in the direction theta_deg.
fast::TransverselyIsotropicHalfSpace transverse_surface_of(const NamedPoint& x);
// Conversion from those units to those of steel.
fast::LineResponse in_steel(const fast::LineResponse& line);
double speed_in_steel(double speed);
/// The smallest critical speed of loads that move in the direction theta_deg, in steel's shear wave speeds.
double critical_speed_of(const NamedPoint& x);
ref::ExactStiffness exact_transverse_of(const NamedExact& x, data::SymmetryAxis axis);
/// BadInput naming the speed unless it is subcritical on every line.
void check_subcritical(const NamedExact& x);

/// A line of a half-space under a moving load, as the reference takes it.
struct ExactLine {
  ref::ExactStiffness solid;
  ref::Exact speed;
  ref::SurfaceDirection motion, psi;

  [[nodiscard]] ref::LineResponse response(int digits) const {
    return ref::line_response(solid, speed, motion, psi, digits);
  }
  /// The line itself. BadInput unless the load is slower along it than its waves; the reference solves beyond, too.
  [[nodiscard]] const ExactLine& checked() const {
    ref::check_subcritical(solid, speed, motion, psi);
    return *this;
  }
};

/// The evaluator of a component of the response of the line that `line_of` makes.
inline auto component_of(ExactLine (*line_of)(const NamedExact& x),
                         ref::Enclosure ref::LineResponse::*member) {
  return [=](const NamedExact& x, int digits) { return line_of(x).response(digits).*member; };
}

/// d ln K/d ln speed by a central difference of K, which the reference computes to three times `digits`, 16 to 485.
ref::Estimate exact_condition(const ExactLine& line, int digits);

}  // namespace nipref::verify
