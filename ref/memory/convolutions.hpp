#pragma once
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// Convolutions of a fading memory e^{-lambda t} with the decaying waves and the steps that the kernels of
/// the elastic sheet are sums of, to any accuracy, for a load that passes the point at time T.
///
/// t >= 0 is the time since the load started, T of either sign, in one unit of time; lambda, a, b >= 0 in its
/// inverse; each of the three times t and times |T| at most 1e15. All given exactly; digits 16 to 1000. The
/// promise is Enclosure's, the bound proven: quadrature over panels in interval arithmetic, see
/// panel_quadrature.hpp. Only what has faded by more than e^{-7e8}, too little for MPFR, comes as 0 with an
/// error of e^{-6e8}. Arguments outside their domain throw data::BadInput. (thesis 6.20, AII)

/// int_0^t H(T - tau) e^{-lambda (t - tau)} e^{-a (T - tau)} sin b(T - tau) dtau
Enclosure J1(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);
/// The same with cos b(T - tau).
Enclosure J2(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);
/// int_0^t H(tau - T) e^{-lambda (t - tau)} e^{a (T - tau)} sin b(T - tau) dtau
Enclosure J3(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);
/// The same with cos b(T - tau).
Enclosure J4(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits);

/// int_0^t theta(t - tau) sign(T - tau) dtau for theta(t) = gamma0 delta(t) + gamma e^{-lambda t}; gamma0 and
/// gamma of either sign. sign(0) = 0: at T = t, where gamma0 makes it jump, the mean of both sides. J5 is for
/// the constants of theta1, J6 for those of theta2.
Enclosure J5(const Exact& gamma0, const Exact& gamma, const Exact& lambda, const Exact& t, const Exact& T,
             int digits);
Enclosure J6(const Exact& gamma0, const Exact& gamma, const Exact& lambda, const Exact& t, const Exact& T,
             int digits);

}  // namespace nipref::ref
