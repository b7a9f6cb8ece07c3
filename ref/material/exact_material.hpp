#pragma once
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// theta(t) = instantaneous delta(t) + sum amplitude e^(-rate t), as data::MaterialFunction in double. Rates that are
/// given are exact and >= 0 and stand in `terms`; all other rates are the roots of the denominators in `fractions`.
struct ExactFunction {
  struct Term {
    mpq_class amplitude;  ///< 1/(stress time)
    mpq_class rate;       ///< 1/time
  };
  mpq_class instantaneous;  ///< 1/stress
  std::vector<Term> terms;  ///< no rate twice
  /// Transforms numerator/denominator in p, 1/time, without common factors. The denominator has the higher degree,
  /// and its roots are simple and have negative real parts.
  std::vector<ExactRatio> fractions;
};

/// The sheet's material with exact constants.
struct ExactMaterial {
  ExactFunction theta1;
  ExactFunction theta2;

  /// N = theta1 + theta2, terms of equal rate joined.
  [[nodiscard]] ExactFunction normal() const;
};

/// The material whose constants are the exact values of the doubles. BadInput for given rates that are not real, and as
/// below.
ExactMaterial exact_material(const data::ViscoelasticMaterial& material);

/// The material by its compliances theta1 and theta2. Throws data::NoMaterial that names Q or Q_dilatation for what gives way
/// at once without bound, or later than a dashpot does, for repeated roots, and for a memory that does not decay, except
/// that of a fluid.
ExactMaterial exact_material(const ExactRationalSolid& solid);

/// A material without fractions, and the share by which its amplitudes and rates may be off.
struct NearMaterial {
  ExactMaterial material;
  mpq_class memory_error;
};

/// The terms of all fractions, enclosed with about so many bits. BadInput unless their rates are real.
NearMaterial with_given_rates(const ExactMaterial& material, mpfr_prec_t bits);

/// The thesis's standard linear solid: G = 3K/8, and both moduli relax to one half.
enum class Solid {
  standard_linear_solid,  ///< as defined: theta2 decays like e^{-t/tau}
  thesis                  ///< as printed and used: theta2 decays like e^{-2t/tau} (thesis AIII.15)
};

/// theta1 = 4/(3 bulk) [delta + e^{-t/tau}/tau] and theta2 a third of it, with the exponent of `solid`. bulk > 0 is the
/// instantaneous modulus, unit of stress, and tau > 0 the relaxation time. BadInput otherwise. (thesis AIII.14)
ExactMaterial exact_solid(Solid solid, const Exact& bulk, const Exact& tau);

}  // namespace nipref::ref
