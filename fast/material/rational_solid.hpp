#pragma once
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/moduli.hpp>

namespace nipref::fast {

/// A solid whose moduli are ratios of polynomials in d/dt, given by its constants. It needs no property but that the
/// functions below exist. It may be a fluid (a rate of 0, Q without p^0) or be rigid at first (Kelvin-Voigt:
/// instantaneous 0, Q of one degree more than P); its rates may be equal, nearly equal or complex; and it may gain
/// energy. The number of terms and the order are not limited. At most four roots of an operator, or of the denominator
/// of the bulk modulus, may be within 1e-9 of each other.
using RationalSolid =
    std::variant<data::PronySeries, data::DifferentialOperators, data::SingleRelaxationTimeSolid>;

enum class Strain { shear, dilatation };

// The functions are defined like those of the same name in moduli.hpp; Strain::dilatation stands for K. Results are
// computed in 237 bits and rounded. The error is at most a unit in the last place of max(|value|, size). The size is about
// 1e-45 of the sum of the terms' magnitudes and matters only if they cancel. A call takes tens to hundreds of microseconds.
//
// BadInput, with the name of the member in the catalogue, is thrown for: coefficients that are neither 0 nor magnitudes
// (data::is_magnitude); negative rates and coefficients of operators; a P, Q or theta that is 0; a degree of Q that is
// neither the degree of P nor one more; t, p and omega that are not finite or < 0; five nearly coincident roots; and
// values beyond the range of doubles. Where p is 0, the number that is named is omega.

Fading relaxation(const RationalSolid& solid, Strain of, double t);
Fading creep(const RationalSolid& solid, Strain of, double t);
Fading storage(const RationalSolid& solid, Strain of, double omega);
Fading loss(const RationalSolid& solid, Strain of, double omega);
/// The real or imaginary part of the modulus at p + i omega.
Fading modulus_at(const RationalSolid& solid, Strain of, double p, double omega, bool imaginary);
Fading theta1(const RationalSolid& solid, double t);
Fading theta2(const RationalSolid& solid, double t);

}  // namespace nipref::fast
