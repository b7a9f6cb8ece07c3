#pragma once

// Convolutions of one relaxation term e^(-lambda t) as a load passes a fixed point at the time T: J1 to J4 with one
// residue of a kernel, J5 and J6 with the sign of the distance. Thesis (6.18), (6.20), Appendix II.
//
// In common to all functions of this header:
//   t           time since the load started, >= 0
//   T           time at which the load passes the point, either sign
//   lambda      rate of relaxation, 1/time, >= 0
//   a, b        decay and frequency of the residue in time, a_n and b_n of (6.10), 1/time, >= 0
//   domain      every magnitude at most 1e150, so that no product of two overflows
//   accuracy    4 units in the last place of the scale, or a few more where long double is no wider than double.
//               The scale is the integral with the sine replaced by min(1, b |T - tau|) and a cosine or sign
//               replaced by 1. Results below 2^-1022 have an error of at most 2^-1074
//   bad input   anything outside the domain, nan: data::BadInput

namespace nipref::fast {

/// int_0^t H(T - tau) e^(-lambda (t - tau)) e^(-a (T - tau)) sin b (T - tau) dtau, a time. Thesis (AII.6).
double J1(double lambda, double a, double b, double t, double T);

/// J1 with the cosine in place of the sine. Thesis (AII.6).
double J2(double lambda, double a, double b, double t, double T);

/// int_0^t H(tau - T) e^(-lambda (t - tau)) e^(a (T - tau)) sin b (T - tau) dtau, a time. Thesis (AII.9), (AII.13).
double J3(double lambda, double a, double b, double t, double T);

/// J3 with the cosine in place of the sine. Thesis (AII.9), (AII.13).
double J4(double lambda, double a, double b, double t, double T);

/// gamma0 sign(T - t) + int_0^t gamma e^(-lambda (t - tau)) sign(T - tau) dtau with sign(0) = 0, in the unit of
/// gamma0, for one term of theta1. gamma0 and gamma may have either sign. Thesis (AII.20), (AII.21).
double J5(double gamma0, double gamma, double lambda, double t, double T);

/// The function J5 for a term of theta2. Thesis (AII.20), (AII.21).
double J6(double gamma0, double gamma, double lambda, double t, double T);

}  // namespace nipref::fast
