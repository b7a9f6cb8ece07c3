#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <string_view>
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::fast::internal {

/// With 113 bits products of two doubles are exact, and roots that are near each other cost no digit of a double.
using Quad = boost::multiprecision::cpp_bin_float_quad;
/// Real coefficients, that of p^0 first; the last one is not 0.
using QuadPolynomial = std::vector<Quad>;

QuadPolynomial product(const QuadPolynomial& a, const QuadPolynomial& b);
QuadPolynomial sum(const QuadPolynomial& a, const QuadPolynomial& b);

/// The function of time whose transform is the product of `factors` over `denominator`. Roots that numerator and
/// denominator share to two units in the last place of a double are cancelled; the numerator comes in factors, so that
/// rounding does not split a root that two factors have. Throws data::NoMaterial, naming `name`, unless the degree of
/// the numerator is the denominator's (the material gives way at once) or one less (it does not), and unless the
/// remaining roots of the denominator are simple (to 1e-6). A root 0 is exactly 0. Before amplitudes and rates are
/// rounded to doubles their relative errors are some 1e-31 over the square of the relative distance of the roots.
data::MaterialFunction partial_fractions(const std::vector<QuadPolynomial>& factors,
                                         const QuadPolynomial& denominator, std::string_view name);

}  // namespace nipref::fast::internal
