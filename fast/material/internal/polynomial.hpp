#pragma once
#include <boost/math/tools/polynomial.hpp>
#include <boost/multiprecision/complex_adaptor.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>
#include <vector>

namespace nipref::fast::internal {

/// 237 bits, so that roots that coincide, or nearly so, and terms that cancel cost no digit of a double.
using Octuple = boost::multiprecision::cpp_bin_float_oct;

using OctupleComplex =
    boost::multiprecision::number<boost::multiprecision::complex_adaptor<Octuple::backend_type>,
                                  boost::multiprecision::et_off>;

/// In double.
inline std::complex<double> rounded(const OctupleComplex& z) {
  return {static_cast<double>(z.real()), static_cast<double>(z.imag())};
}

/// Real coefficients, that of p^0 first; the last one is not 0. The polynomial 0 has none.
using Polynomial = boost::math::tools::polynomial<Octuple>;

/// a + b. A coefficient that cancels to less than 2^-200 of its terms is 0: leading coefficients of doubles cancel exactly.
Polynomial sum(const Polynomial& a, const Polynomial& b);

/// The product of some factors over that of others.
struct Rational {
  std::vector<Polynomial> numerator, denominator;
};
Polynomial product(const std::vector<Polynomial>& factors);

/// All roots: by the formula up to the second degree, otherwise to rounding by the method of Ehrlich and Aberth.
std::vector<OctupleComplex> roots_of(Polynomial p);

/// The same as real numbers and conjugate pairs, exactly: each pair stands together, that with im > 0 first. Rounding splits
/// a double root by less than 1e-13 of it: both are real.
std::vector<OctupleComplex> paired_roots_of(const Polynomial& p);

}  // namespace nipref::fast::internal
