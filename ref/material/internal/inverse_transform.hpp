#pragma once
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The function of time whose transform is numerator/denominator, at t > 0, where impulses at 0 do not matter. The
/// denominator has a higher degree than the numerator, which is not 0. The interval contains the value, proven, and
/// becomes narrower with more bits.
///
/// Let f have the transform R/D. It is the divided difference of R(p) e^(p t)/d over the roots of D, where d is D's
/// last coefficient, and |e^x[x_0..x_m]| <= e^(max Re x)/m! bounds it. The divided difference is enclosed for
/// approximations z_j of the roots, however close to each other; it is then f~ with the transform R/D~, D~ = d prod
/// (p - z_j). As R/D (1 + (D - D~)/D~) = R/D~, f + k * f = f~, where k has the transform (D - D~)/D~. With mu = max
/// Re z_j, |f~| <= F e^(mu s) and |k| <= c e^(mu s) on [0, t], Gronwall's inequality gives |f - f~| <= F e^(mu t)
/// (e^(c t) - 1).
Interval inverse_transform(const Polynomial& numerator, const Polynomial& denominator, const mpq_class& t,
                           mpfr_prec_t bits);

/// An upper bound of the slowest rate, -max Re of the roots of D, by which values that underflow are refused.
double slowest_rate(const Polynomial& denominator);

}  // namespace nipref::ref
