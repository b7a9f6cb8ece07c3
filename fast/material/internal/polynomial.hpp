#pragma once
#include <boost/math/tools/polynomial.hpp>
#include <boost/multiprecision/complex_adaptor.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>
#include <vector>

namespace nipref::fast::internal {

/// A number of 237 bits: with it neither coincident or nearly coincident roots nor cancellation cost a digit of a double.
using Octuple = boost::multiprecision::cpp_bin_float_oct;

using OctupleComplex =
    boost::multiprecision::number<boost::multiprecision::complex_adaptor<Octuple::backend_type>,
                                  boost::multiprecision::et_off>;

/// Rounds both parts to double.
inline std::complex<double> rounded(const OctupleComplex& z) {
  return {static_cast<double>(z.real()), static_cast<double>(z.imag())};
}

/// A polynomial in p with real coefficients, that of p^0 first. The last coefficient is not 0; the polynomial 0 has none.
using Polynomial = boost::math::tools::polynomial<Octuple>;

/// a + b. A coefficient that cancels to 2^-200 of its terms becomes 0, as leading coefficients of doubles may cancel
/// exactly.
Polynomial sum(const Polynomial& a, const Polynomial& b);

/// A rational function: the product of the factors in `numerator` divided by the product of those in `denominator`.
struct Rational {
  std::vector<Polynomial> numerator, denominator;
};
Polynomial product(const std::vector<Polynomial>& factors);

/// All roots: up to the second degree by the formula, otherwise by the Ehrlich-Aberth method, to rounding error.
std::vector<OctupleComplex> roots_of(Polynomial p);

/// All roots as real numbers and exactly conjugate pairs. The roots of a pair are adjacent, the one with Im > 0 first.
/// A root with |Im| up to 1e-13 of its modulus becomes real, since rounding splits a real double root by less.
std::vector<OctupleComplex> paired_roots_of(const Polynomial& p);

}  // namespace nipref::fast::internal
