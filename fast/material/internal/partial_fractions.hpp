#pragma once
#include <string_view>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/internal/polynomial.hpp>

namespace nipref::fast::internal {

/// A modulus q/p. `factors`: those of p that are known, otherwise p itself.
struct Operators {
  Polynomial p, q;
  std::vector<Polynomial> factors{p};
};

/// theta1 = p/(2 q) of the shear modulus, theta2 = 3 p p'/(6 q' p + 2 q p') with p' and q' of the bulk modulus.
struct Compliances {
  Rational theta1, theta2;
};
Compliances compliances_of(const Operators& shear, const Operators& bulk);

/// Roots of numerator and denominator that agree to this, relative, are one: two units in the last place of a double where
/// the coefficients are rounded to doubles; where they are exact, what rounding makes of a double root.
inline constexpr double of_rounded = 0x1p-51, of_exact = 0x1p-100;

/// The function of time that has this transform. Roots that numerator and denominator share to `shared` are cancelled; the
/// numerator's are those of its factors, so that rounding does not split a root that two of them have. Throws
/// data::NoMaterial, naming `name`, unless the degree of the numerator is the denominator's (the material gives way at once)
/// or one less (it does not), and unless the remaining roots of the denominator are simple (to 1e-6). A root 0 is exactly 0.
data::MaterialFunction partial_fractions(const Rational& transform, std::string_view name, double shared);

}  // namespace nipref::fast::internal
