#pragma once
#include <span>
#include <vector>

#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

// From the catalogue's arguments about half-spaces to what the two paths take.

/// Of the critical speed, in the audits; where the reference has to integrate over lines, farther off.
inline constexpr double nearest_critical = 1 - 1e-9, nearest_integrated = 1 - 1e-6;

using Doubles = std::span<const double>;
using Exacts = std::span<const ref::Exact>;

/// mu = 1, density 1: speeds are v/v_S.
data::IsotropicSolid unit_isotropic(double poisson);
ref::ExactStiffness exact_isotropic(const ref::Exact& poisson);
/// By a half-space of mu = 1 and density 1; the angle counts from the motion.
fast::SurfaceResponse isotropic_surface(double poisson, double speed);
/// BadInput unless the speed is below that of Rayleigh waves.
ref::SurfaceAnswer exact_isotropic_surface(const ref::Exact& poisson, const ref::Exact& speed);

// The seed's steel is the unit: its mu of stress, its v_S of speed. (brock2013 section 3)

/// The decimal number that a constant is written as, exactly; 77.2 is no double.
ref::Exact as_written(double constant);

/// `x` and the seed's graphite epoxy, c11 to density.
Point with_epoxy(Point x);

/// axis, c11, c33, c13, c44, c66 (GPa), density (kg/m^3), from the argument number `at` on, with the seed's
/// values unless others are given.
void append_transverse_arguments(std::vector<Argument>& arguments);
/// Those without the axis.
void append_constants(std::vector<Argument>& arguments);
data::SymmetryAxis axis_at(Doubles x, std::size_t at);
/// In the units in which it is given, so that no constant is rounded.
data::TransverselyIsotropicSolid transverse_at(Doubles x, std::size_t at);
/// Of loads that move at `speed` times steel's shear wave speed.
fast::TransverselyIsotropicHalfSpace transverse_surface_at(Doubles x, std::size_t at, double theta_deg,
                                                           double speed);
/// From those units to those of steel.
fast::LineResponse in_steel(const fast::LineResponse& line);
double speed_in_steel(double speed);
/// In the units of steel, with the seed's sphere.
ScaledModuli scaled_moduli_at(Doubles x, std::size_t at);
ref::ExactStiffness exact_transverse_at(Exacts x, std::size_t at);
ref::ExactStiffness exact_transverse_at(Exacts x, std::size_t at, data::SymmetryAxis axis);
/// BadInput naming the speed unless it is subcritical on every line.
void check_subcritical(Exacts x, std::size_t at, const ref::Exact& theta_deg, const ref::Exact& speed);

}  // namespace nipref::verify
