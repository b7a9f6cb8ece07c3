#pragma once
#include <nipref/verify/support/internal/formulas.hpp>

namespace nipref::verify {

/// Besides the functions of the library: cosine(x) and sine(x) of x degrees, turned_cosine(psi, x) and turned_sine(psi, x) of psi
/// radians and x degrees, which keep their digits near 90 degrees.
template <>
struct FormulaWords<double> {
  using OfOne = double(double);
  using OfTwo = double(double, double);
  static double pi() { return std::numbers::pi; }
  static double exact(double value) { return value; }
  static double value(double x) { return x; }
  static const std::map<std::string, OfOne*> of_one;
  static const std::map<std::string, OfTwo*> of_two;
  static const std::map<std::string, FormulaFunctional<double>> functionals;
};

/// Numbers by the names that formulas have for them.
using GivenNumbers = std::vector<std::pair<std::string, double>>;

}  // namespace nipref::verify
