#pragma once
#include <mpfr.h>

#include <memory>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// Whether the residue series gives the transform at x to e^{-nats} at less cost than the trapezoidal rule. False for
/// x < 1.
bool residues_are_cheaper(double x, double nats);

/// The Fourier transform of a symbol at an exact x >= 1, as an interval of half-width about e^{-nats}, from the
/// residues at the roots z_n of S in the first quadrant. The value is that of transform(), but for I1 it is the whole
/// kernel, because the poles of tanh are left out. The terms are in interval arithmetic. The terms beyond N sum to less
/// than series_remainder e^{-(N+1/2) pi x}, by which the interval is widened. Proof: ref/sheet/README.md, Kernels.
Interval residue_series(Symbol symbol, const Exact& x, double nats);
inline constexpr long series_remainder = 7;

/// The correction of the trapezoidal rule with step h, see transform(), for the poles of G below the line Im z = 4 pi
/// lines. After it the aliasing error is bounded by the integral along this line. The terms are in interval arithmetic;
/// the half-width is about e^{-nats} if 2 pi/h >= nats/(4 pi lines) + x. Proof: ref/sheet/README.md, Kernels.
Interval passed_poles(Symbol symbol, const Exact& x, double step, long lines, double nats);

/// The sum over the roots in int_x^inf e^{-rate (w - x)} I(w) dw, |x| >= 1, rate >= 0, the memory of I1, I3, I4 or I5,
/// with the truncation error of residue_series(). Proof: ref/memory/README.md, The memory of a load from infinity.
Interval fading_residue_series(Symbol symbol, const Exact& x, const Interval& rate, double nats);

/// A root z and 1/cosh z.
struct SheetPole {
  ComplexInterval z;
  ComplexInterval sech;
};

/// The pole z_n, cached. It has up to a quarter more bits than requested, so that many arguments share it.
std::shared_ptr<const SheetPole> sheet_pole(long n, mpfr_prec_t precision);

/// A kernel's coefficient at a root in the thesis's sum, twice the residue; I1 is included in that of I6_alpha_part,
/// the minus sign in that of I6_eta_part.
ComplexInterval plain_coefficient(PlainKernel kernel, const SheetPole& pole);

/// BadInput unless 1 <= terms <= most_residue_terms.
void check_residue_terms(int terms);

/// Whether the terms from the n-th on, without the factor pi, sum to less than 2^-precision at x >= 0. Sets `bound` to
/// a bound of the sum: there are at most 500 terms, Im z_n > (n - 1/2) pi, and no coefficient exceeds 2.1.
bool is_negligible(int n, const Interval& x, mpfr_prec_t precision, Interval& bound);

/// The bits that the n-th term at x needs: it is about e^{-x Im z_n}, with x |z_n| times the relative error of z_n.
mpfr_prec_t term_precision(long n, double x, double nats);

/// BadInput unless 1 <= n <= 10^9.
void check_root_number(long n);

/// An enclosure of z_n to about `precision` bits, proven as in sheet_root().
ComplexInterval sheet_root_interval(long n, mpfr_prec_t precision);

}  // namespace nipref::ref
