#pragma once
#include <gmpxx.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpc.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <string>
#include <utility>

#include <nipref/ref/number/float.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>

/// The numbers that the second methods compute with.
namespace nipref::verify::confirm {

template <unsigned digits>
using Number = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits>,
                                             boost::multiprecision::et_off>;
template <unsigned digits>
using ComplexNumber = boost::multiprecision::number<boost::multiprecision::mpc_complex_backend<digits>,
                                                    boost::multiprecision::et_off>;

template <class Float>
Float pi() {
  return boost::math::constants::pi<Float>();
}

template <class Float>
Float to_number(const mpq_class& x) {
  Float value;
  mpfr_set_q(value.backend().data(), x.get_mpq_t(), MPFR_RNDN);
  return value;
}

template <class Float>
mpq_class exactly(const Float& x) {
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), x.backend().data());
  return value;
}

template <class Float>
Confirmation confirmation(std::string method, const Float& value, const Float& error) {
  ref::Float v = ref::zero_of_bits(mpfr_get_prec(value.backend().data())), e = ref::zero_of_bits(64);
  mpfr_set(ref::raw(v), value.backend().data(), MPFR_RNDN);
  mpfr_abs(ref::raw(e), error.backend().data(), MPFR_RNDU);
  return {std::move(method), std::move(v), std::move(e)};
}

}  // namespace nipref::verify::confirm
