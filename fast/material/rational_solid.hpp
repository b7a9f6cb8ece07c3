#pragma once
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/moduli.hpp>

namespace nipref::fast {

/// A solid whose moduli are ratios of polynomials in d/dt, by the constants that describe it. Nothing is asked of it but
/// that it has these functions: it may be a fluid (a rate of 0, Q without p^0), give way to nothing at once (Kelvin's and
/// Voigt's: instantaneous 0, Q of one degree more than P), have rates that are equal, nearly so or complex, and gain
/// energy. The number of terms and the order are not bounded, but of the roots of an operator, or of what a bulk modulus is
/// divided by, at most four may be within 1e-9 of each other.
using RationalSolid =
    std::variant<data::PronySeries, data::DifferentialOperators, data::SingleRelaxationTimeSolid>;

enum class Strain { shear, dilatation };

// As their namesakes in moduli.hpp are defined, dilatation meaning K. Computed in 237 bits and rounded: good to a unit in
// the last place of max(|value|, size), the size being some 1e-45 of the parts that the value is made of, 0 in effect
// unless these cancel. Tens to hundreds of microseconds.
//
// BadInput, naming a member as the catalogue does: coefficients that are neither 0 nor magnitudes (data::is_magnitude),
// rates and coefficients of operators < 0, a P or Q or a theta that is 0 altogether, Q of a lower degree than P or of
// more than one higher; t, p and omega not finite or < 0; five such roots; and where the value is not within the range of
// doubles. Where p is 0, the number that is named is omega.

Fading relaxation(const RationalSolid& solid, Strain of, double t);
Fading creep(const RationalSolid& solid, Strain of, double t);
Fading storage(const RationalSolid& solid, Strain of, double omega);
Fading loss(const RationalSolid& solid, Strain of, double omega);
/// Real or imaginary part of the modulus at p + i omega.
Fading modulus_at(const RationalSolid& solid, Strain of, double p, double omega, bool imaginary);
Fading theta1(const RationalSolid& solid, double t);
Fading theta2(const RationalSolid& solid, double t);

}  // namespace nipref::fast
