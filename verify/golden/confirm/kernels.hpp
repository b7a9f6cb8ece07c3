#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

/// The sheet's kernels by a second method. For |x| <= 3 it integrates along the real axis by a double exponential
/// rule, x = e^(t - e^-t), and estimates the error by half as many nodes. Beyond, it adds the integrals around the
/// poles of the symbols: the residues and the poles themselves are contour integrals over circles of 128 points, so
/// that it uses no formula for a residue and no known root.
namespace nipref::verify::confirm {

/// The number quarters pi/4 + rest. At large arguments the rest decays, but it may be all that remains of a sum.
struct Split {
  mpq_class quarters;
  Float rest;
  Float error;  ///< estimate, of rest

  Split& add(const mpq_class& factor, const Split& term);
  [[nodiscard]] Float value() const;
};

/// What symbols are made of at z: 2/(sinh 2z + 2z) and its products with sinh z and cosh z.
template <class Number>
struct SymbolAt {
  Number z, unit, sine, cosine;
};

/// A node of the rule for transforms; the symbols are multiplied by its weight.
struct Node : SymbolAt<Float> {
  Float sine_rest, cosine_rest;  ///< without 2 e^-z
};
const std::vector<Node>& nodes();

/// The sum of `integrand` over the nodes; the error is its difference from twice the sum over the even nodes.
template <class Integrand>
Split integral(Integrand integrand) {
  Float even = 0, odd = 0;
  bool is_even = true;
  for (const Node& node : nodes()) {
    (is_even ? even : odd) += integrand(node);
    is_even = !is_even;
  }
  return {0, even + odd, abs(odd - even) + abs(even) * Float("1e-90")};
}

/// A pole of the symbols in the first quadrant with their residues.
using Pole = SymbolAt<Complex>;
/// The pole of any number from 1 on.
Pole pole_by_circle(std::size_t n);
/// The poles are counted from 1 to 16; the terms of the others decay like e^(-16.5 pi x).
const Pole& pole(std::size_t n);
inline constexpr std::size_t poles = 16;

/// The cosine or sine transform of a symbol at x >= far: the sum over the poles of its residues times e^(i x z). `size`
/// times the term that would come next is the error.
Split around_poles(const Float& x, bool is_sine, int size,
                   const std::function<Complex(const Pole& at)>& residue);

/// Transforms are sums over the poles for |x| >= far.
inline constexpr int far = 3;

/// A kernel of one argument, the cosine or, if it is odd, the sine transform of its symbol.
struct SymbolTransform {
  bool is_odd;
  int growth;  ///< beyond all terms of poles it is an odd kernel's sign times pi/4, or growth |x| pi/4
  Complex (*residue)(const Pole& at);
  Split (*near)(const mpq_class& x, int order);

  /// The value or, of I1 and I3, the derivative of the first or second order.
  [[nodiscard]] Split operator()(const mpq_class& x, int order = 0) const;
};
extern const SymbolTransform I1, I3, I4, I5, I7;
/// I6(alpha, eta) is the difference of these two functions of one argument.
extern const SymbolTransform I6_alpha, I6_eta;

/// int e^(-rate (w - from)) I(w) dw from `from` to `to`, or to infinity without `to`; an odd kernel is taken without
/// its term pi/4 sign w. For |w| < 3 by Gauss's rule on panels with a Chebyshev interpolant of the kernel; beyond, as
/// the sum of the integrals of the terms that belong to the kernel's poles. The coarse rule has fewer points. The
/// rate may be complex.
Complex history(const SymbolTransform& kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse);

/// The same integral of sign w, in closed form.
LongComplex history_of_sign(const mpq_class& from, const std::optional<mpq_class>& to,
                            const LongComplex& rate);

}  // namespace nipref::verify::confirm
