#pragma once
#include <string_view>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/internal/polynomial.hpp>

namespace nipref::fast::internal {

/// A modulus q/p. `factors` are the known factors of p, or p itself.
struct Operators {
  Polynomial p, q;
  std::vector<Polynomial> factors{p};
};

/// theta1 = p/(2 q) and theta2 = 3 p p'/(6 q' p + 2 q p'), where q/p is the shear modulus and q'/p' the bulk modulus.
struct Compliances {
  Rational theta1, theta2;
};
Compliances compliances_of(const Operators& shear, const Operators& bulk);

/// Relative distance up to which a root of the numerator and one of the denominator count as equal. For coefficients
/// rounded to double it is two units in the last place; for exact ones it is about as far as rounding splits a double root.
inline constexpr double of_rounded = 0x1p-51, of_exact = 0x1p-100;

/// The function of time that has this transform. Common roots of numerator and denominator, which agree to `shared`,
/// are cancelled. The roots of the numerator are found factor by factor, so that rounding does not split a root that
/// two factors have. Throws data::NoMaterial, naming `name`, unless the degree of the numerator is that of the
/// denominator (the material gives way at once) or one less (it does not), and unless the remaining roots of the
/// denominator are simple, that is, differ by more than 1e-6. A root 0 is exactly 0.
data::MaterialFunction partial_fractions(const Rational& transform, std::string_view name, double shared);

}  // namespace nipref::fast::internal
