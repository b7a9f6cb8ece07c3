#pragma once
#include <vector>

#include <nipref/ref/elastic_nip/internal/chebyshev_system.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The pressure of a frictionless contact, p = 2A sum_m c_m sin(mu theta), mu = 2m + 1, and what of the
/// infinite sum these coefficients may miss; A is any in an interval. Notation and units:
/// chebyshev_system.hpp.
///
/// Let x_m = sqrt(mu) c_m, so that the system is x + G x = e_0 with the symmetric G_mn = sqrt(mu nu) g_mn/2.
/// It has one solution, and a residual r tells the error: |dx| <= |r|/lambda in l2, because
///
/// (1) x + G x >= lambda > 0. With g(x) = x K(x), K the symbol of I1, E(h) = int_0^inf h(x) |q^(x A)|^2 dx/x,
///     the quadratic form is E(g) and that of the logarithm alone, sum x_m^2, is E(1) (both times 2/pi^2; q
///     is odd, so neutral). g rises: its derivative has the sign of z sinh z, z = 2x. As q^(k) = i pi sum
///     (-1)^m mu c_m J_mu(k) and S = sum mu J_mu^2 has S' = k J_0^2/2, so S <= k^2/4, Cauchy's inequality
///     gives |q^(k)|^2 <= k^2 E(1)/2; the frequencies k < z hold at most z^2/4 of E(1), those above keep at
///     least g(z/A) of their part: lambda = g(z/A) (1 - z^2/4) for any 0 < z < 2.
///
/// (2) |G_mn| <= C e^{-mu tau - nu tau'} for y = A (sinh tau + sinh tau') < 2, tau' >= 0, with C = 2 A
///     sqrt(cosh tau cosh tau') Q(y), Q as in smooth_kernel.hpp. For g_mn = +-4 int (1 - g) J_mu(Ax) J_nu(Ax)
///     dx/x; moved by i tau Bessel's integral gives |J_n(w)| <= e^{-n tau + w sinh tau}, and this in J_n =
///     (w/2n)(J_{n-1} + J_{n+1}) the same times w cosh(tau)/n; take the root of both for either factor.
///     Below tau' is 0, or both are half of it in the sense of sinh, and C = 2 A cosh(tau) Q(A sinh tau).
///
/// (3) G grows with A, by at most 1/A: x'G x is -E(1 - g) in frequencies k = x A, so that its derivative is
///     1/A times E(x g'), and x g' = z^2 sinh z/(sinh z + z)^2 is at most z/4 and at most z^2/sinh z, so
///     below 1.
///
/// The residual of given c_0 .. c_{n-1} is enclosed in rows m < n, with g_mn by quadrature, whose nodes fold
/// the coefficients at 4nk +- mu onto mu: at most 8 C e^{-(2n+1) tau}/(1 - e^{-2n tau})^2 in every G_mn; in
/// the other rows (2) bounds it.
struct ProvenExpansion {
  Interval half_length;  ///< A
  std::vector<Float> coefficients;
  Interval radius;         ///< sum_m sqrt(mu) dx_m = sum_m mu |dc_m| <= radius, all m
  Interval energy_radius;  ///< |dx| <= this, so |dc_0|
  /// Of Gauss-Chebyshev at the nodes of the system: int k(t, s) p(s)/(2A) ds by the values of its integrand,
  /// k the kernel J(A (t - s)) or I3(A (t - s)), is off by at most this.
  Interval quadrature_error;
};

/// What solves the system, for all half lengths of the interval, about system.half_length().
ProvenExpansion prove(const ChebyshevSystem& system, const Vector& coefficients, const Interval& half_length);

/// lambda of (1), for all half lengths of the interval.
Interval coercivity(const Interval& half_length);

/// Coefficients that give about so many digits, by the bounds above.
int size_for(double half_length, int digits);

}  // namespace nipref::ref
