#pragma once
#include <gmpxx.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpc.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <complex>

#include <nipref/ref/number/float.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/support/internal/common.hpp>

/// The number types of the second methods, and their conversions.
namespace nipref::verify::confirm {

template <unsigned digits>
using Number = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits>,
                                             boost::multiprecision::et_off>;
template <unsigned digits>
using ComplexNumber = boost::multiprecision::number<boost::multiprecision::mpc_complex_backend<digits>,
                                                    boost::multiprecision::et_off>;

/// At the squared phase speed 1e-44, where the terms of half-spaces cancel, a hundred of these digits are left.
using Float = Number<150>;
using Complex = ComplexNumber<150>;
/// The type for the terms of memories, where more digits cancel.
using Long = Number<700>;
using LongComplex = ComplexNumber<700>;

template <class Real = Float>
Real pi() {
  return boost::math::constants::pi<Real>();
}

template <class Real = Float>
Real to_number(const mpq_class& x) {
  Real value;
  mpfr_set_q(value.backend().data(), x.get_mpq_t(), MPFR_RNDN);
  return value;
}

template <class Real>
mpq_class exactly(const Real& x) {
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), x.backend().data());
  return value;
}

template <class Real>
Confirmation confirmation(std::string method, const Real& value, const Real& error) {
  ref::Float v = ref::zero_of_bits(mpfr_get_prec(value.backend().data())), e = ref::zero_of_bits(64);
  mpfr_set(ref::raw(v), value.backend().data(), MPFR_RNDN);
  mpfr_abs(ref::raw(e), error.backend().data(), MPFR_RNDU);
  return {std::move(method), std::move(v), std::move(e)};
}

}  // namespace nipref::verify::confirm
