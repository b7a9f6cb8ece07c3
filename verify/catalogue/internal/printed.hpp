#pragma once
#include <nipref/data/material/solids.hpp>
#include <nipref/verify/formulas/internal/formulas.hpp>

namespace nipref::verify {

/// The value of a function of printed.txt at these numbers. Its formula may also name the numbers in `given`.
double printed(const std::string& function, const std::vector<double>& numbers,
               const GivenNumbers& given = {});

/// The value of a formula that uses functions of printed.txt.
double printed_value(const std::string& formula, const GivenNumbers& given);

/// The numbers that formulas of brock2013 name: the moduli of a half-space over the shear modulus of the sphere on it.
GivenNumbers scaled_moduli(const data::TransverselyIsotropicSolid& half_space,
                           const data::IsotropicSolid& sphere);

/// The number of decimals to which w_S and w_D were rounded for (brock2012) Tables 1 and 2, found by trial: with it all
/// cells of both tables but one agree within a unit of the last digit.
inline constexpr int table_root_decimals = 5;

}  // namespace nipref::verify
