#pragma once
#include <functional>
#include <map>
#include <string>

#include <nipref/verify/seeds/propagated.hpp>

namespace nipref::verify {

/// A very thin frictionless sheet of the solid with one relaxation time tau that ends up twice as compliant as it
/// begins: springs with N p + (N/tau) int e^(-t/tau) p = 2 u/b, in closed form.
struct ThinStandardSolid {
  Propagated leading_share;  ///< L1/L
  Propagated resistance;     ///< mu_R R/L
};

/// memory: F0 tau/L, > 0.
ThinStandardSolid thin_standard_solid(double memory);

/// Numbers of statements that are no formula of other numbers, by name.
const std::map<std::string, std::function<Propagated()>>& computed_numbers();

/// The value of a printed formula in double arithmetic without a bound on its rounding: eight of its sixteen digits are
/// trusted, enough to tell it from the truth.
Propagated printed_form(double value);

}  // namespace nipref::verify
