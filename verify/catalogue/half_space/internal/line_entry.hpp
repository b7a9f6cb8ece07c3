#pragma once
#include <string>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

// What the catalogue's entries about lines on half-spaces share.

/// Measured against its own value, good to 4 units in the last place.
Quantity half_space_entry(std::string name, std::string definition, std::string source);

/// d ln K/d ln speed.
Quantity condition_entry(std::string name, std::string source);

/// By a central difference of the reference's K in three times the digits; digits: 16 to 485.
ref::Estimate exact_condition(const ref::ExactStiffness& solid, const ref::Exact& speed,
                              const ref::SurfaceDirection& motion, const ref::SurfaceDirection& psi,
                              int digits);

/// Of the critical speed: from 1e-8 to 1 - 1e-9.
double draw_share(Random& random);
/// Crowded at 0 and 90.
double draw_degrees(Random& random);

}  // namespace nipref::verify
