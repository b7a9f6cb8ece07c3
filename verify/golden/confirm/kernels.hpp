#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

/// The sheet's kernels by a second method. For |x| < 3 it integrates along the real axis of z by a double exponential
/// rule, z = e^(t - e^-t), and estimates the error by a rule with half as many nodes. For |x| >= 3 it sums the
/// integrals around the poles of the symbols. The poles and their residues are contour integrals over circles of 128
/// points, so that the method uses no formula for a residue and no known root.
namespace nipref::verify::confirm {

/// The number quarters pi/4 + rest. At large arguments the rest decays, but it may be all that remains of a sum.
struct Split {
  mpq_class quarters;
  Float rest;
  Float error;  ///< error estimate of `rest`

  Split& add(const mpq_class& factor, const Split& term);
  [[nodiscard]] Float value() const;
};

/// The parts of the symbols at z: `unit` is 2/(sinh 2z + 2z), `sine` and `cosine` its products with sinh z and cosh z.
template <class Number>
struct SymbolAt {
  Number z, unit, sine, cosine;
};

/// A node of the rule for transforms. All members but z are multiplied by its weight.
struct Node : SymbolAt<Float> {
  Float sine_rest, cosine_rest;  ///< `sine` and `cosine` less 2 e^-z
};
const std::vector<Node>& nodes();

/// The sum of `integrand` over the nodes. The error estimate is its difference from twice the sum over the even nodes.
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

/// A pole z of the symbols in the first quadrant. The other members are residues.
using Pole = SymbolAt<Complex>;
/// Computes the n-th pole, n >= 1, by integrals over a circle.
Pole pole_by_circle(std::size_t n);
/// The n-th pole, n from 1 to 16, from a cache. The terms of all other poles decay like e^(-16.5 pi x) or faster.
const Pole& pole(std::size_t n);
inline constexpr std::size_t poles = 16;

/// The cosine or sine transform of a symbol at x >= far: the sum over the poles of its residues times e^(i x z). The
/// error estimate is `size` times e^(-16.5 pi x), the decay of the first neglected term.
Split around_poles(const Float& x, bool is_sine, int size,
                   const std::function<Complex(const Pole& at)>& residue);

/// Transforms are sums over the poles for |x| >= far.
inline constexpr int far = 3;

/// A kernel of one argument, the cosine or, if it is odd, the sine transform of its symbol.
struct SymbolTransform {
  bool is_odd;
  int growth;  ///< beside the poles' terms an odd kernel has sign(x) pi/4, an even one growth |x| pi/4
  Complex (*residue)(const Pole& at);
  Split (*near)(const mpq_class& x, int order);

  /// The value or, for I1 and I3, the derivative of the first or second order.
  [[nodiscard]] Split operator()(const mpq_class& x, int order = 0) const;
};
extern const SymbolTransform I1, I3, I4, I5, I7;
/// I6(alpha, eta) is the difference of these two functions of one argument.
extern const SymbolTransform I6_alpha, I6_eta;

/// int e^(-rate (w - from)) I(w) dw from `from` to `to`, or to infinity without `to`. An odd kernel is taken without
/// its term pi/4 sign w. The part with |w| < 3 is integrated by Gauss's rule on panels with a Chebyshev interpolant of
/// the kernel, the part beyond is the sum of the integrals of the poles' terms. The coarse rule has fewer points. The
/// rate may be complex.
Complex history(const SymbolTransform& kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse);

/// int e^(-rate (w - from)) sign w dw between the same limits, in closed form.
LongComplex history_of_sign(const mpq_class& from, const std::optional<mpq_class>& to,
                            const LongComplex& rate);

}  // namespace nipref::verify::confirm
