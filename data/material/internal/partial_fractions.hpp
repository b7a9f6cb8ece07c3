#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <string_view>
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::data {

/// 113 bits: products of two doubles are exact, and roots that are near each other cost no digit of a double.
using Wide = boost::multiprecision::cpp_bin_float_quad;
/// Real coefficients, that of p^0 first; the last one is not 0.
using Polynomial = std::vector<Wide>;

[[nodiscard]] Polynomial product(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial sum(const Polynomial& a, const Polynomial& b);

/// The function of time whose transform is the product of `factors` over `denominator`. What both share (to
/// two units in the last place of a double) is cancelled; as factors, so that a root of two of them is not parted by rounding. BadInput, naming
/// `name`, unless both have the same degree or the numerator's is one lower (nothing gives way at once; a
/// higher one: it gives way without bound) and the denominator's roots that remain are simple (to 1e-6).
/// A root 0 is exactly 0.
/// Amplitudes and rates are rounded to doubles last; before they are good to some 1e-31 over the square of the relative
/// distance of the roots.
[[nodiscard]] MaterialFunction partial_fractions(const std::vector<Polynomial>& factors,
                                                 const Polynomial& denominator, std::string_view name);

}  // namespace nipref::data
