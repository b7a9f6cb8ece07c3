#pragma once
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpc.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <functional>
#include <vector>

namespace nipref::fast::generator {

/// A number of 100 digits, of which the evaluation of a polynomial by powers loses at most about 50.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                           boost::multiprecision::et_off>;
using Complex = boost::multiprecision::number<boost::multiprecision::mpc_complex_backend<100>,
                                              boost::multiprecision::et_off>;

inline Real pi() { return boost::math::constants::pi<Real>(); }

/// Coefficients of powers 0, 1, 2, ...
using Series = std::vector<Real>;

/// p(x).
Real value(const Series& p, const Real& x);

/// The polynomial of the given degree that agrees with f at the Chebyshev nodes of [low, high]. Its error is within a
/// small factor of the least possible.
Series interpolated(const std::function<Real(const Real&)>& f, const Real& low, const Real& high, int degree);

}  // namespace nipref::fast::generator
