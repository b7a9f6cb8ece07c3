#pragma once
#include <nipref/data/problem/sheet_load.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The sheet kernels of kernels.hpp as intervals of half-width about e^{-nats}, for odd kernels min(1, |x|) e^{-nats}.
/// Arguments have either sign; alpha != 0 for I1 and I6.
Interval I1_interval(const Exact& alpha, double nats);
Interval I2_interval(const Exact& alpha, double nats);
Interval I3_interval(const Exact& alpha, double nats);
Interval I4_interval(const Exact& eta, double nats);
Interval I5_interval(const Exact& eta, double nats);
Interval I6_interval(const Exact& alpha, const Exact& eta, double nats);
Interval I7_interval(const Exact& eta, double nats);

/// I6_eta, the transform of 2 cosh z/(z S). It is minus the part of I6 that depends on eta alone, without linear
/// growth: I6(alpha, eta) = I1(alpha) + I6_alpha transform - (pi/4)(|alpha| - |eta|) - I6_eta(eta).
Interval I6_eta_interval(const Exact& eta, double nats);

/// N = theta1 + theta2 of an elastic sheet, 1/stress.
inline mpq_class normal_compliance(const Exact& young, const Exact& poisson) {
  return 2 * (1 + poisson.value()) * (1 - poisson.value()) / young.value();
}

/// theta1/N and theta2/N.
struct ThetaShares {
  mpq_class theta1, theta2;

  explicit ThetaShares(const Exact& poisson) : theta1(1 / (2 * (1 - poisson.value()))), theta2(1 - theta1) {}
};

/// The part of the tangential displacements over N that depends on eta: [theta2 I4 - theta1 I5]/(pi N) for a normal
/// load, |eta|/4 + [theta1/N I7 - I6_eta]/pi for a shear load.
Interval fixed_point_interval(data::SheetLoad load, const Exact& eta, const ThetaShares& shares, double nats);

/// The largest double of `bits` significant bits that is at most x > 0. With few bits, its integer multiples are exact.
double of_few_bits(double x, int bits);

/// The bits that quantities of size up to `size` need for an error of e^{-nats}.
mpfr_prec_t working_precision(double nats, double size);

}  // namespace nipref::ref
