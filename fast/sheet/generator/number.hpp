#pragma once
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpc.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <vector>

namespace nipref::fast::generator {

/// 100 digits, of which the continuation of Taylor series to the origin loses at most about 50.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                           boost::multiprecision::et_off>;
using Complex = boost::multiprecision::number<boost::multiprecision::mpc_complex_backend<100>,
                                              boost::multiprecision::et_off>;

inline Real pi() { return boost::math::constants::pi<Real>(); }

/// Coefficients of powers 0, 1, 2, ...
using Series = std::vector<Real>;

}  // namespace nipref::fast::generator
