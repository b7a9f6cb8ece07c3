#pragma once
#include <nipref/fast/sheet/generator/number.hpp>

namespace nipref::fast::generator {

/// p(x).
Real value(const Series& p, const Real& x);

/// Coefficients of p(x + shift) in powers of x, the first `length` of them.
Series shifted(const Series& p, const Real& shift, int length);

/// Coefficients of p(x)/(centre + x).
Series divided_by_argument(const Series& p, const Real& centre);

/// ln(centre + x), the first `length` coefficients.
Series logarithm(const Real& centre, int length);

/// Polynomial of the given degree that agrees with p at the Chebyshev nodes of [low, high]: its error is
/// within a small factor of the least possible, about 2^degree times smaller than that of the truncated
/// series.
Series economised(const Series& p, const Real& low, const Real& high, int degree);

}  // namespace nipref::fast::generator
