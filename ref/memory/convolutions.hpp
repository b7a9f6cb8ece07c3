#pragma once
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

// Convolutions of a memory e^{-lambda t} with the decaying waves and the steps whose sums are the kernels of the
// elastic sheet, to any accuracy, for a load that passes the point at time T.
//
// t >= 0 is the time since the load started; T, the time at which it passes, has either sign. Both have one unit of
// time; lambda, a, b >= 0 have its inverse. lambda, a and b times t and times |T| are at most 1e15. All arguments are
// exact numbers; digits 16 to 1000. Every function promises an Enclosure, proven: ref/memory/README.md, Convolutions. A
// value below e^{-7e8}, which is out of MPFR's range, is returned as 0 with an error of e^{-6e8}. Arguments outside
// their domain throw data::BadInput. (thesis 6.20, AII)

/// int_0^t H(T - tau) e^{-lambda (t - tau)} e^{-a (T - tau)} sin b(T - tau) dtau
Enclosure J1(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);
/// J1 with cos b(T - tau) in place of the sine.
Enclosure J2(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);
/// int_0^t H(tau - T) e^{-lambda (t - tau)} e^{a (T - tau)} sin b(T - tau) dtau
Enclosure J3(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);
/// J3 with cos b(T - tau) in place of the sine.
Enclosure J4(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);

/// int_0^t theta(t - tau) sign(T - tau) dtau for theta(t) = gamma0 delta(t) + gamma e^{-lambda t}. gamma0 and gamma
/// have either sign. At T = t, where gamma0 causes a jump, the value is the mean of both sides (sign(0) = 0). J5 is for
/// the constants of theta1, J6 for the constants of theta2.
Enclosure J5(const Exact& gamma0, const Exact& gamma, const Exact& lambda, const Exact& t, const Exact& T,
             int digits);
inline Enclosure J6(const Exact& gamma0, const Exact& gamma, const Exact& lambda, const Exact& t,
                    const Exact& T, int digits) {
  return J5(gamma0, gamma, lambda, t, T, digits);
}

}  // namespace nipref::ref
