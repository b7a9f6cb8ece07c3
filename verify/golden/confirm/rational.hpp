#pragma once
#include <algorithm>
#include <boost/math/tools/polynomial.hpp>
#include <cstddef>
#include <vector>

#include <nipref/verify/golden/confirm/number.hpp>

/// Rational functions of the Laplace variable, and their roots.
namespace nipref::verify::confirm {

/// The coefficient of the power 0 comes first.
template <class Float>
using Polynomial = boost::math::tools::polynomial<Float>;

template <class Float>
struct Ratio {
  Polynomial<Float> above, below;

  friend Ratio operator+(const Ratio& a, const Ratio& b) {
    return {a.above * b.below + b.above * a.below, a.below * b.below};
  }
  friend Ratio operator*(const Float& a, const Ratio& b) { return {a * b.above, b.below}; }
};

template <class Float>
Ratio<Float> inverse(const Ratio<Float>& a) {
  return {a.below, a.above};
}

template <class Float, class Complex>
Complex value_at(const Polynomial<Float>& polynomial, const Complex& z) {
  Complex sum(0);
  for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * z + Complex(polynomial[k]);
  return sum;
}

/// The product of root_i - root_j over all other roots.
template <class Complex>
Complex apart(const std::vector<Complex>& roots, std::size_t i) {
  Complex product(1);
  for (std::size_t j = 0; j < roots.size(); ++j) {
    if (j != i) product *= roots[i] - roots[j];
  }
  return product;
}

/// All roots by the method of Durand and Kerner.
template <unsigned digits>
std::vector<ComplexNumber<digits>> roots_of(const Polynomial<Number<digits>>& polynomial) {
  using Coefficient = Number<digits>;
  using Root = ComplexNumber<digits>;
  const std::size_t n = polynomial.size() - 1;
  const Coefficient last = polynomial[n], settled = pow(Coefficient(10), 20 - static_cast<int>(digits));
  Coefficient size = 0;
  for (std::size_t k = 0; k < n; ++k)
    size = std::max<Coefficient>(size, pow(Coefficient(abs(polynomial[k] / last)), 1 / Coefficient(n - k)));
  std::vector<Root> roots;
  Root next(size);
  for (std::size_t k = 0; k < n; ++k) roots.push_back(next *= Root(Coefficient("0.4"), Coefficient("0.9")));
  Coefficient change = 1;
  for (int round = 0; change > settled && round < 4000; ++round) {
    change = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Root step = value_at(polynomial, roots[i]) / (last * apart(roots, i));
      roots[i] -= step;
      if (roots[i] != Root(0)) change = std::max<Coefficient>(change, abs(step) / abs(roots[i]));
    }
  }
  return roots;
}

/// instantaneous delta(t) + sum amplitude e^(-rate t)
template <unsigned digits>
struct Exponentials {
  struct Term {
    ComplexNumber<digits> amplitude, rate;
  };
  Number<digits> instantaneous;
  std::vector<Term> terms;
};

/// The function of time of a ratio: by the roots of its denominator, without those that the numerator has, too. Both
/// polynomials are without zeros at their ends.
template <unsigned digits>
Exponentials<digits> in_exponentials(const Ratio<Number<digits>>& ratio) {
  using Coefficient = Number<digits>;
  using Root = ComplexNumber<digits>;
  const auto& [above, below] = ratio;
  const Coefficient last = below.data().back();
  const bool at_once = above.size() == below.size();
  Exponentials<digits> function{at_once ? Coefficient(above.data().back() / last) : Coefficient(0), {}};
  // The root 0 of a fluid is split off exactly.
  const bool flows = below.size() > 1 && below[0] == 0;
  std::vector<Root> roots = roots_of<digits>(flows ? below >> 1 : below);
  if (flows) roots.emplace_back(0);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Root value = value_at(above, roots[i]);
    const Coefficient parts = value_at(above, Root(Coefficient(abs(roots[i])))).real();
    if (abs(value) > Coefficient("1e-90") * abs(parts))
      function.terms.push_back({value / (last * apart(roots, i)), -roots[i]});
  }
  return function;
}

}  // namespace nipref::verify::confirm
