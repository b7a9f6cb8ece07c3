#pragma once
#include <nipref/ref/elastic_nip/internal/chebyshev_system.hpp>
#include <nipref/ref/nip/internal/contact_bounds.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>

namespace nipref::ref {

/// What solves the system, for all half lengths of the interval, about system.half_length().
///
/// With x_m = sqrt(mu) c_m the system is x + G x = e_0, G_mn = sqrt(mu nu) g_mn/2. The residual of given c_0 .. c_{n-1}
/// is enclosed in rows m < n and bounded in all others; divided by a lower bound lambda of the quadratic form it bounds
/// what they miss. (1) to (3) in the code are those of the proof: ref/elastic_nip/README.md, Contacts without friction.
ProvenExpansion prove(const ChebyshevSystem& system, const Vector& coefficients, const Interval& half_length);

}  // namespace nipref::ref
