#pragma once
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// theta(t) = instantaneous delta(t) + sum amplitude e^(-rate t), constants known exactly, as data::MaterialFunction has
/// them in double: with the rates >= 0 of the terms, and with those, all else, that are the roots of fractions.
struct ExactFunction {
  struct Term {
    mpq_class amplitude;  ///< 1/(stress time)
    mpq_class rate;       ///< 1/time
  };
  mpq_class instantaneous;  ///< 1/stress
  std::vector<Term> terms;  ///< no rate twice
  /// Transforms numerator/denominator in p, 1/time: of no common factor, the denominator's degree the higher one and its
  /// roots simple, of negative real parts.
  std::vector<ExactRatio> fractions;
};

/// The sheet's material, known exactly.
struct ExactMaterial {
  ExactFunction theta1;
  ExactFunction theta2;

  /// N = theta1 + theta2, terms of equal rate joined.
  [[nodiscard]] ExactFunction normal() const;
};

/// To this many digits, from the exact values of the doubles that describe the material. BadInput unless its rates are
/// real.
ExactMaterial exact_material(const data::ViscoelasticMaterial& material, int digits);

/// By its compliances theta1 and theta2. BadInput, naming `last`, for what gives way without bound at once, for repeated
/// roots and for strains that do not fade, but for a fluid's.
ExactMaterial exact_material(const ExactRationalSolid& solid);

/// The thesis's standard linear solid, G = 3K/8, both moduli falling to one half.
enum class Solid {
  standard_linear_solid,  ///< as it was defined: theta2 fades like e^{-t/tau}
  thesis                  ///< as it was printed and used: theta2 fades like e^{-2t/tau} (thesis AIII.15)
};

/// theta1 = 4/(3 bulk) [delta + e^{-t/tau}/tau], theta2 a third of it, up to what `solid` says. bulk > 0 is
/// the modulus at once, unit of stress; tau > 0 the relaxation time. BadInput otherwise. (thesis AIII.14)
ExactMaterial exact_solid(Solid solid, const Exact& bulk, const Exact& tau);

}  // namespace nipref::ref
