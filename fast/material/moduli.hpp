#pragma once
#include <complex>

#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::fast {

/// A modulus of a linear viscoelastic solid: `spring` and, as the model has them, `second_spring` (not with kelvin_voigt,
/// maxwell or elastic) and `viscosity` (not with elastic). Moduli in stress, viscosities in stress time.
struct Modulus {
  data::SpringModel model;
  double spring, second_spring, viscosity;

  /// BadInput naming prefix + member unless what the model has is a magnitude (data::check_magnitude).
  void check(const char* prefix) const;
};

/// A value that is a sum of fading terms, with what rounding of rate times time may make of it: the sum of each term's
/// magnitude times 1 + rate t.
struct Fading {
  double value;
  double size;
};

// Times and frequencies are finite and >= 0, BadInput otherwise. No term of any sum cancels another. Errors are a few
// units in the last place of the size; of the value where a number alone is returned.

/// Stress under a unit of strain since t ago, beside what a dashpot answers to the step itself: unit of stress.
Fading relaxation(const Modulus& modulus, double t);
/// Strain under a unit of stress since t ago, 1/stress. (thesis figure 32b)
double creep(const Modulus& modulus, double t);
/// Real and imaginary part of the modulus at e^{i omega t}, unit of stress.
double storage(const Modulus& modulus, double omega);
double loss(const Modulus& modulus, double omega);

/// The modulus at p + i omega of Laplace's transformation: the stress over a strain that grows like e^{p t} and swings
/// like e^{i omega t}. The error is at most 32 units in the last place of its modulus. (thesis 6.12)
std::complex<double> modulus_at(const Modulus& modulus, double p, double omega);

/// 1/(2G) and 3/(6K + 2G) as functions of time beside their impulse: the strain t after a unit impulse of stress,
/// 1/(stress time). Both moduli are of one model. (thesis 6.16, 6.17, AIII.10, AIII.11)
Fading theta1(const Modulus& shear, double t);
Fading theta2(const Modulus& shear, const Modulus& bulk, double t);

}  // namespace nipref::fast
