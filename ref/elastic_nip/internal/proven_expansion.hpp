#pragma once
#include <vector>

#include <nipref/ref/elastic_nip/internal/chebyshev_system.hpp>
#include <nipref/ref/nip/internal/contact_bounds.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The pressure of a frictionless contact, p = 2A sum_m c_m sin(mu theta), mu = 2m + 1, and what of the
/// infinite sum these coefficients may miss; A is any in an interval. Notation and units:
/// chebyshev_system.hpp.
///
/// With x_m = sqrt(mu) c_m the system is x + G x = e_0, G_mn = sqrt(mu nu) g_mn/2. The residual of given c_0 .. c_{n-1}
/// is enclosed in rows m < n and bounded in all others; divided by a lower bound lambda of the quadratic form it bounds
/// what they miss. (1) to (3) in the code are those of the proof: ref/elastic_nip/README.md, Contacts without friction.
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

}  // namespace nipref::ref
