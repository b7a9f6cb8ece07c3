#pragma once
#include <mpfr.h>

#include <memory>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// Whether the residue series gives the transform at x to e^{-nats} with so few terms that it costs less than
/// the trapezoidal rule. False for x < 1.
bool residues_are_cheaper(double x, double nats);

/// The Fourier transform of a symbol at x >= 1, given exactly, within an interval of half-width about
/// e^{-nats}, from the roots z_n of S in the first quadrant: what transform() gives by summation, but for
/// `normal`, whose poles of tanh are left out, all of I1.
///
///     even    -2 pi Im sum_n c_n e^{i x z_n}
///     odd     pi/4 + 2 pi Re sum_n c_n e^{i x z_n}        (pi/4: half the residue 1/2 of the pole at 0)
///
/// The lines Im z = k pi, k = 1, 2, ..., lie between the roots; there |S| >= max(2 k pi, |sinh 2 Re z|), so
/// that the integral around -k < Re z < k below such a line tends to that along the real axis, and the series
/// is exact. As S' = 4 cosh^2 z and sinh z = -z/cosh z at a root,
///
///     normal    z/(2 cosh^4 z)     I3  1/(2 cosh^2 z)     I4  -1/(2 cosh^3 z)     I5  1/(2 cosh z)
///     I6_alpha  1/(2 z cosh^2 z)   I6_eta  1/(2 z cosh z)                         I7  -z/(2 cosh^3 z)
///
/// are the c_n. They are below 1: cosh 2z = +-sqrt(1 + 4 z^2) makes |cosh^2 z| >= f(|z|) with f(r) =
/// (sqrt(4 r^2 - 1) - 1)/2; as |z| > pi/2 (SheetRoot), f(pi/2) > 0.98 and f' >= 1, f >= 0.98 and |z|/f <=
/// 1.61. With Im z_n > (n - 1/2) pi the terms beyond N then sum to less than 2 pi e^{-(N+1/2) pi x}/(1 -
/// e^{-pi x}) <= 7 e^{-(N+1/2) pi x}, which widens the interval. The terms are in interval arithmetic.
Interval residue_series(Symbol symbol, const Exact& x, double nats);

/// What the poles z_k of G below the line Im z = 4 pi lines add to the trapezoidal rule with step h, transform(), so
/// that only the aliasing from that line is left as its error. The rule's sum is the integral of G(z) cos(x z)
/// cot(pi z/h)/(2i) around the real axis. Its upper half, moved up over the poles, and its lower half, moved down,
/// leave their residues behind. With r_k, the residue of G (c_n at a root; -4/(3 z_k) at the poles z_k = (2k + 1)
/// 2 pi i/3 of `normal`),
///
///     -2 pi i sum_k r_k cos(x z_k)/(e^{-2 pi i z_k/h} - 1),    odd: sin(x z_k),
///
/// undoes that. A root and its image -conj(z_n) together make 4 pi Im of what the root makes. The terms are in interval
/// arithmetic; the half-width is about e^{-nats} where 2 pi/h >= nats/(4 pi lines) + x.
Interval passed_poles(Symbol symbol, const Exact& x, double step, long lines, double nats);

/// The part of the roots in int_x^inf e^{-rate (w - x)} I(w) dw, the memory of a kernel (I1, I3, I4 or I5 for
/// the symbol of its name), |x| >= 1, rate > 0, all else as above:
///
///     x > 0    even -2 pi Im, odd +2 pi Re of sum_n c_n e^{i x z_n}/(rate - i z_n)
///     x < 0    even -2 pi Im, odd -2 pi Re of sum_n c_n e^{i |x| z_n}/(rate + i z_n).
///
/// As Re z_n, Im z_n > 1, no factor 1/(rate -+ i z_n) exceeds 1, and none does on the lines Im z = k pi > rate
/// + 1, so that the series is exact, but for the poles at 0 and i rate (memory/internal/fading.hpp), and what
/// is left out has the same bound.
Interval fading_residue_series(Symbol symbol, const Exact& x, const Exact& rate, double nats);

/// A root and 1/cosh of it.
struct SheetPole {
  ComplexInterval z;
  ComplexInterval sech;
};

/// Of z_n, kept, with up to a quarter more bits than were asked for, so that many arguments share them.
std::shared_ptr<const SheetPole> sheet_pole(long n, mpfr_prec_t precision);

/// Bits for the n-th term at x, of size about e^{-x Im z_n}, where the relative error of z_n counts x |z_n| times.
mpfr_prec_t term_precision(long n, double x, double nats);

/// z_n to about `precision` bits: proven as sheet_root() says.
ComplexInterval sheet_root_interval(long n, mpfr_prec_t precision);

}  // namespace nipref::ref
