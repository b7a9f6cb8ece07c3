#pragma once
#include <string_view>
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/internal/polynomial.hpp>

namespace nipref::fast::internal {

/// What is one root of numerator and denominator, relative: two units in the last place of a double, as where the
/// coefficients are rounded, or what is rounding of the roots, of a double root, too, where they are exact.
inline constexpr double of_rounded = 0x1p-51, of_exact = 0x1p-100;

/// The function of time whose transform is the product of `factors` over `denominator`. Roots that numerator and
/// denominator share to `shared` are cancelled; the numerator comes in factors, so that rounding does not split a root
/// that two factors have. Throws data::NoMaterial, naming `name`, unless the degree of
/// the numerator is the denominator's (the material gives way at once) or one less (it does not), and unless the
/// remaining roots of the denominator are simple (to 1e-6). A root 0 is exactly 0.
data::MaterialFunction partial_fractions(const std::vector<Polynomial>& factors,
                                         const Polynomial& denominator, std::string_view name, double shared);

}  // namespace nipref::fast::internal
