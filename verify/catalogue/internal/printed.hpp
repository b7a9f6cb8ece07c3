#pragma once
#include <nipref/data/material/solids.hpp>
#include <nipref/verify/formulas/internal/formulas.hpp>

namespace nipref::verify {

/// A function of printed.txt, which says what each of them is, at these numbers, and at those that it takes from around it.
double printed(const std::string& function, const std::vector<double>& numbers,
               const GivenNumbers& given = {});

/// The value of a formula with such functions.
double printed_value(const std::string& formula, const GivenNumbers& given);

/// What the formulas of brock2013 take from around them: the moduli of a half-space over the shear modulus of the sphere on it.
GivenNumbers scaled_moduli(const data::TransverselyIsotropicSolid& half_space,
                           const data::IsotropicSolid& sphere);

/// The number of decimals to which w_S and w_D were rounded for (brock2012) Tables 1 and 2. It was found by trial: with it
/// all cells of both tables but one agree within a unit of the last digit.
inline constexpr int table_root_decimals = 5;

}  // namespace nipref::verify
