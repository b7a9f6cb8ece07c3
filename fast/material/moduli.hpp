#pragma once
#include <complex>

#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::fast {

/// A modulus of a linear viscoelastic solid. Every model has a `spring`; only standard_linear has a `second_spring`;
/// all but elastic have a `viscosity`. The unit of springs is that of stress, the unit of viscosities stress time.
struct Modulus {
  data::SpringModel model;
  double spring, second_spring, viscosity;

  /// Throws BadInput that names `prefix` (+ _2 or _viscosity) unless the model's members are magnitudes (check_magnitude).
  void check(const char* prefix) const;
};

/// A sum of decaying terms. `size`, the scale of its rounding error, is the sum of the terms' magnitudes, each
/// multiplied by 1 + rate t.
struct Fading {
  double value;
  double size;
};

// Times and frequencies must be finite and >= 0; otherwise BadInput is thrown. No term of any sum cancels another.
// Errors are a few units in the last place of the size, or of the value if a function returns no size.

/// The stress at time t after a unit step of strain, without a dashpot's impulse at the step itself. Unit of stress.
Fading relaxation(const Modulus& modulus, double t);
/// The strain at time t after a unit step of stress, 1/stress. (thesis figure 32b)
double creep(const Modulus& modulus, double t);
/// The real and the imaginary part of the modulus for a strain e^{i omega t}, unit of stress.
double storage(const Modulus& modulus, double omega);
double loss(const Modulus& modulus, double omega);

/// The modulus at p + i omega in the Laplace domain: the ratio of stress to strain for a strain e^{(p + i omega) t}.
/// The error is at most 32 units in the last place of its absolute value. (thesis 6.12)
std::complex<double> modulus_at(const Modulus& modulus, double p, double omega);

/// 1/(2G) and 3/(6K + 2G) as functions of time, without their impulse at time 0: the strain at time t after a unit
/// impulse of stress, 1/(stress time). Both moduli must have the same model. (thesis 6.16, 6.17, AIII.10, AIII.11)
Fading theta1(const Modulus& shear, double t);
Fading theta2(const Modulus& shear, const Modulus& bulk, double t);

}  // namespace nipref::fast
