#pragma once
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The function of time whose transform is numerator/denominator, at t > 0 beside its impulses at 0; the denominator is
/// of a higher degree than the numerator, which is not 0. The interval holds it, proven, and is the narrower the more bits.
///
/// f of the transform R/D is the divided difference of R(p) e^(p t)/d over the roots of D, d its last coefficient, and
/// bounded as |e^x[x_0..x_m]| <= e^(max Re x)/m!. It is taken over approximations z_j of the roots, however near to
/// each other, exactly: that is f~ of R/D~ with D~ = d prod (p - z_j). As R/D (1 + (D - D~)/D~) = R/D~, f + k * f = f~
/// with k of the transform (D - D~)/D~; with mu = max Re z_j, |f~| <= F e^(mu s) and |k| <= c e^(mu s) on [0, t],
/// Gronwall's inequality gives |f - f~| <= F e^(mu t) (e^(c t) - 1).
Interval inverse_transform(const Polynomial& numerator, const Polynomial& denominator, const mpq_class& t,
                           mpfr_prec_t bits);

/// An upper bound of the slowest rate, -max Re of the roots of D, for refusing what has faded beyond any number.
double slowest_rate(const Polynomial& denominator);

}  // namespace nipref::ref
