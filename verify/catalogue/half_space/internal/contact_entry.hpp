#pragma once
#include <string>
#include <vector>

#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

// What the catalogue's entries about contacts on half-spaces share.

/// Measured against its own value.
Quantity contact_entry(std::string name, std::string definition, std::string source, double promise);

// Arguments of the isotropic entries begin with poisson, speed.

std::vector<Argument> isotropic_arguments();

/// The entry's points: up to `largest_share` of the Rayleigh speed; `more` draws the arguments after the
/// first two.
void draw_isotropic(Quantity& entry, double largest_share, std::function<Point(Random&)> more);

double draw_angle(Random& random);  ///< degrees
double draw_friction(Random& random);

}  // namespace nipref::verify
