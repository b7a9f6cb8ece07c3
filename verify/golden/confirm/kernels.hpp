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

/// made(x, weight) of each node below `end` of the double exponential rule on x > 0. Node j is at t = j/256; the coarse
/// rule has the nodes of even j. For kernels at |x| <= 3 the integrands are analytic and bounded in the strip |Im t| < 0.3.
template <class Node>
std::vector<Node> double_exponential_rule(int end, Node (*made)(const Float& x, const Float& weight)) {
  const Float step = Float(1) / 256;
  std::vector<Node> nodes;
  for (int j = -1400; j <= 1600; ++j) {
    const Float t = j * step, x = exp(t - exp(-t));
    if (x > end) break;
    nodes.push_back(made(x, step * x * (1 + exp(-t))));
  }
  return nodes;
}

/// The sum of `integrand` over the nodes; the error is its difference from twice the sum over the even nodes.
template <class Node, class Integrand>
Split integral(const std::vector<Node>& nodes, Integrand integrand) {
  Float even = 0, odd = 0;
  bool is_even = true;
  for (const Node& node : nodes) {
    (is_even ? even : odd) += integrand(node);
    is_even = !is_even;
  }
  return {0, even + odd, abs(odd - even) + abs(even) * Float("1e-90")};
}

Split kernel_I1(const mpq_class& alpha);
Split kernel_I2(const mpq_class& alpha);
Split kernel_I3(const mpq_class& alpha);
Split kernel_I4(const mpq_class& eta);
Split kernel_I5(const mpq_class& eta);
Split kernel_I7(const mpq_class& eta);
/// I6(alpha, eta) is the difference of these two functions of one argument.
Split kernel_I6_alpha(const mpq_class& alpha);
Split kernel_I6_eta(const mpq_class& eta);

/// A pole of the kernels in the first quadrant with the residues of their symbols.
struct Pole {
  Complex z;
  Complex I1, I3, I4, I5, I7, I6_alpha, I6_eta;
};
/// The pole of any number from 1 on.
Pole pole_by_circle(std::size_t n);
/// The poles are counted from 1 to 16; the terms of the others decay like e^(-16.5 pi x).
const Pole& pole(std::size_t n);
inline constexpr std::size_t poles = 16;

/// The cosine or sine transform of a symbol at x >= far: the sum over the poles of its residues times e^(i x z). `size`
/// times the term that would come next is the error.
Split around_poles(const Float& x, bool is_sine, int size,
                   const std::function<Complex(const Pole& at)>& residue);

/// The kernels are sums over the poles for |x| >= far.
inline constexpr int far = 3;

/// A kernel whose history is taken: its values and the residues of its symbol.
struct Remembered {
  Split (*at)(const mpq_class& x);
  Complex Pole::*residue;
  bool is_odd;
};
inline constexpr Remembered remembered_I1{kernel_I1, &Pole::I1, false},
    remembered_I3{kernel_I3, &Pole::I3, true}, remembered_I4{kernel_I4, &Pole::I4, true},
    remembered_I5{kernel_I5, &Pole::I5, true};

/// int e^(-rate (w - from)) I(w) dw from `from` to `to`, or to infinity without `to`; an odd kernel is taken without
/// its term pi/4 sign w. For |w| < 3 by Gauss's rule on panels with a Chebyshev interpolant of the kernel; beyond, as
/// the sum of the integrals of the terms that belong to the kernel's poles. The coarse rule has fewer points. The
/// rate may be complex.
Complex history(const Remembered& kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse);

/// The same integral of sign w, in closed form.
LongComplex history_of_sign(const mpq_class& from, const std::optional<mpq_class>& to,
                            const LongComplex& rate);

}  // namespace nipref::verify::confirm
