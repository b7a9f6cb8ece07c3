#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

/// The sheet's kernels by a second method. Up to |x| = 3 by their integrals along the real axis with a double
/// exponential rule, x = e^(t - e^-t), and with half as many nodes; beyond, by integrals around the poles of their
/// symbols: residues and the places of the poles are numerical integrals over circles of 128 points, no formula of a
/// residue and no root is taken from anywhere.
namespace nipref::verify::confirm {

using Float = Number<100>;
using Complex = ComplexNumber<100>;

/// quarters pi/4 + rest. At large arguments rest decays and may be all that is left of a sum.
struct Split {
  mpq_class quarters;
  Float rest;
  Float error;  ///< estimate, of rest

  Split& add(const mpq_class& factor, const Split& term);
  [[nodiscard]] Float value() const;
};

Split kernel_I1(const mpq_class& alpha);
Split kernel_I2(const mpq_class& alpha);
Split kernel_I3(const mpq_class& alpha);
Split kernel_I4(const mpq_class& eta);
Split kernel_I5(const mpq_class& eta);
Split kernel_I7(const mpq_class& eta);
/// I6(alpha, eta) is the difference of these two, each of one argument.
Split kernel_I6_alpha(const mpq_class& alpha);
Split kernel_I6_eta(const mpq_class& eta);

/// One of the kernels' poles in the first quadrant with the residues of their symbols there.
struct Pole {
  Complex z;
  Complex I1, I3, I4, I5, I7, I6_alpha, I6_eta;
};
/// Counted from 1, up to 16: what is beyond decays like e^(-16.5 pi x).
const Pole& pole(std::size_t n);
inline constexpr std::size_t poles = 16;

/// Beyond it by the poles.
inline constexpr int far = 3;

}  // namespace nipref::verify::confirm
