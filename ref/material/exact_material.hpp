#pragma once
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// theta(t) = instantaneous delta(t) + sum amplitude e^(-rate t), as data::MaterialFunction in double. `terms` has the
/// terms of exactly known rates >= 0. The other rates are minus the roots of the denominators of `fractions`.
struct ExactFunction {
  struct Term {
    mpq_class amplitude;  ///< 1/(stress time)
    mpq_class rate;       ///< 1/time
  };
  mpq_class instantaneous;  ///< 1/stress
  std::vector<Term> terms;  ///< the rates are all different
  /// The transforms of the other terms: ratios of polynomials in p, 1/time, without common factors. The denominator has
  /// the higher degree, and its roots are simple and have negative real parts.
  std::vector<ExactRatio> fractions;
};

/// The sheet's material with exact constants.
struct ExactMaterial {
  ExactFunction theta1;
  ExactFunction theta2;

  /// N = theta1 + theta2; terms of equal rates are added.
  [[nodiscard]] ExactFunction normal() const;
};

/// The material whose constants are the exact values of the doubles. Throws BadInput if given rates are not real, and
/// data::NoMaterial as the next function does.
ExactMaterial exact_material(const data::ViscoelasticMaterial& material);

/// The material with the compliances theta1 and theta2 of the solid. Throws data::NoMaterial, naming Q or Q_dilatation,
/// if the instantaneous compliance is infinite, if the transform of a compliance decreases faster than 1/p, as of a
/// dashpot, or if a denominator has repeated roots or a root with real part >= 0, except the root 0 of a fluid.
ExactMaterial exact_material(const ExactRationalSolid& solid);

/// A material without fractions, and a bound of the relative errors of its amplitudes and rates.
struct NearMaterial {
  ExactMaterial material;
  mpq_class memory_error;
};

/// The material with the terms of all fractions, enclosed with about `bits` bits. BadInput unless their rates are real.
NearMaterial with_given_rates(const ExactMaterial& material, mpfr_prec_t bits);

/// The thesis's standard linear solid: G = 3K/8, and both moduli relax to one half.
enum class Solid {
  standard_linear_solid,  ///< as defined: theta2 decays like e^{-t/tau}
  thesis                  ///< as printed and used: theta2 decays like e^{-2t/tau} (thesis AIII.15)
};

/// theta1 = 4/(3 bulk) [delta + e^{-t/tau}/tau] (thesis AIII.14); theta2 is a third of it, with the exponent of `solid`.
/// bulk > 0 is the instantaneous modulus, unit of stress; tau > 0 is the relaxation time. BadInput otherwise.
ExactMaterial exact_solid(Solid solid, const Exact& bulk, const Exact& tau);

}  // namespace nipref::ref
