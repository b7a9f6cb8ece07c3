#pragma once
#include <gmpxx.h>

#include <boost/math/tools/polynomial.hpp>
#include <string>
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

enum class ComplexPart { re, im };

/// A polynomial in p with rational coefficients; the first is the coefficient of p^0.
using Polynomial = boost::math::tools::polynomial<mpq_class>;

/// numerator/denominator, two polynomials in p = d/dt.
struct ExactRatio {
  Polynomial numerator, denominator;
};

/// fast::RationalSolid with exact constants.
struct ExactRationalSolid {
  ExactRatio shear, dilatation;  ///< G and K
  ExactRatio theta1, theta2;
};

/// instantaneous + sum amplitude/(p + rate)
struct ExactSeries {
  Exact instantaneous;
  std::vector<Exact> amplitudes, rates;
};

// These functions throw BadInput where fast::RationalSolid does, but constants may have any magnitude.

ExactRationalSolid exact_prony(const ExactSeries& theta1, const ExactSeries& theta2);
/// G = Q/P, K = Q'/P'.
ExactRationalSolid exact_operators(const std::vector<Exact>& p, const std::vector<Exact>& q,
                                   const std::vector<Exact>& p_dilatation,
                                   const std::vector<Exact>& q_dilatation);
ExactRationalSolid exact_moduli(const ExactRatio& shear, const ExactRatio& bulk);
/// The modulus of a model of springs, unit of stress, and a dashpot, unit of stress times time, all > 0. Constants that
/// the model does not have are ignored. BadInput otherwise, naming `name`, `name`_2 or `name`_viscosity.
ExactRatio exact_modulus(data::SpringModel model, const Exact& spring, const Exact& second_spring,
                         const Exact& viscosity, const std::string& name);
/// data::SingleRelaxationTimeSolid
ExactRationalSolid exact_single_time(const Exact& bulk, const Exact& shear, const Exact& tau,
                                     int theta2_rate_factor);

// Definitions: the functions of the same names in fast. `modulus` is shear or dilatation; t, omega, p >= 0; digits 16
// to 1000. Error bounds are proven: common factors are cancelled exactly; for functions of time see
// inverse_transform(). BadInput "t" if the value is below e^-7e8 or, in an unstable material, above e^2300 (1000 digits
// before the point).

Enclosure relaxation(const ExactRatio& modulus, const Exact& t, int digits);
Enclosure creep(const ExactRatio& modulus, const Exact& t, int digits);
Enclosure storage(const ExactRatio& modulus, const Exact& omega, int digits);
Enclosure loss(const ExactRatio& modulus, const Exact& omega, int digits);
/// The real or the imaginary part of the modulus at p + i omega.
Enclosure modulus_at(const ExactRatio& modulus, const Exact& p, const Exact& omega, ComplexPart part,
                     int digits);
/// theta1 or theta2 at t, without the impulse at t = 0.
Enclosure fading_part(const ExactRatio& theta, const Exact& t, int digits);

}  // namespace nipref::ref
