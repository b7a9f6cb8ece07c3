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

/// The Fourier transform of a symbol at an exact x >= 1, as an interval of half-width about e^{-nats}, from the roots
/// z_n of S in the first quadrant. It is the value of transform(), except that for I1, whose poles of tanh are
/// left out, it is the whole kernel. The terms beyond N sum to less than series_remainder e^{-(N+1/2) pi x}, which widens the
/// interval; the terms are in interval arithmetic. Proof: ref/sheet/README.md, Kernels.
Interval residue_series(Symbol symbol, const Exact& x, double nats);
inline constexpr long series_remainder = 7;

/// The correction to the trapezoidal rule with step h, see transform(), for the poles of G below the line Im z = 4 pi lines,
/// after which only the aliasing from that line remains as its error. The terms are in interval arithmetic; the half-width
/// is about e^{-nats} where 2 pi/h >= nats/(4 pi lines) + x. Proof: the same page.
Interval passed_poles(Symbol symbol, const Exact& x, double step, long lines, double nats);

/// The part of the roots in int_x^inf e^{-rate (w - x)} I(w) dw, the memory of a kernel (I1, I3, I4 or I5), |x| >= 1, rate >=
/// 0, with the same truncation error. Proof: ref/memory/README.md, The memory of a load from infinity.
Interval fading_residue_series(Symbol symbol, const Exact& x, const Interval& rate, double nats);

/// A root z and 1/cosh z.
struct SheetPole {
  ComplexInterval z;
  ComplexInterval sech;
};

/// The pole z_n, cached. It has up to a quarter more bits than requested, so that many arguments share it.
std::shared_ptr<const SheetPole> sheet_pole(long n, mpfr_prec_t precision);

/// A kernel's coefficient at a root as the thesis sums it, twice its residue: I6_alpha_part with I1, I6_eta_part with its sign.
ComplexInterval plain_coefficient(PlainKernel kernel, const SheetPole& pole);

/// BadInput unless 1 <= terms <= most_residue_terms.
void check_residue_terms(int terms);

/// Whether the terms from the n-th on, without pi, sum to less than 2^-precision at x >= 0; if so, `bound` is set to a
/// bound of the sum. There are at most 500 terms, Im z_n > (n - 1/2) pi, and no coefficient exceeds 2.1, see
/// residue_series().
bool is_negligible(int n, const Interval& x, mpfr_prec_t precision, Interval& bound);

/// The bits that the n-th term at x needs: its size is about e^{-x Im z_n}, and the relative error of z_n is
/// multiplied by x |z_n|.
mpfr_prec_t term_precision(long n, double x, double nats);

/// BadInput unless 1 <= n <= 10^9.
void check_root_number(long n);

/// z_n to about `precision` bits: proven as sheet_root() says.
ComplexInterval sheet_root_interval(long n, mpfr_prec_t precision);

}  // namespace nipref::ref
