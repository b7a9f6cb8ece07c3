#pragma once
#include <boost/math/tools/polynomial.hpp>
#include <span>

#include <nipref/verify/golden/confirm/number.hpp>

/// Rational functions of the Laplace variable, and their roots.
namespace nipref::verify::confirm {

/// A polynomial. The coefficient of the power 0 comes first.
template <class Real>
using PolynomialOf = boost::math::tools::polynomial<Real>;
using Polynomial = PolynomialOf<Long>;

struct Ratio {
  Polynomial above, below;

  friend Ratio operator+(const Ratio& a, const Ratio& b) {
    return {a.above * b.below + b.above * a.below, a.below * b.below};
  }
  friend Ratio operator*(const Long& a, const Ratio& b) { return {a * b.above, b.below}; }
};

inline Ratio inverse(const Ratio& a) { return {a.below, a.above}; }

template <class Real, class Root>
Root value_at(const PolynomialOf<Real>& polynomial, const Root& z) {
  Root sum(0);
  for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * z + Root(polynomial[k]);
  return sum;
}

/// The product of root_i - root_j over all other roots.
template <class Root>
Root apart(const std::vector<Root>& roots, std::size_t i) {
  Root product(1);
  for (std::size_t j = 0; j < roots.size(); ++j)
    if (j != i) product *= roots[i] - roots[j];
  return product;
}

/// All roots by the method of Durand and Kerner.
template <unsigned digits>
std::vector<ComplexNumber<digits>> roots_of(const PolynomialOf<Number<digits>>& polynomial) {
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

/// The moduli G and K of a material. operator_moduli() takes them from its differential operators.
struct Moduli {
  Ratio G, K;
};
Moduli operator_moduli(std::span<const double> p, std::span<const double> q,
                       std::span<const double> p_dilatation, std::span<const double> q_dilatation);
inline Moduli operator_moduli(Arguments x) {
  return operator_moduli(x.list("P_0"), x.list("Q_0"), x.list("P_dilatation_0"), x.list("Q_dilatation_0"));
}

/// theta1 = 1/(2G) and theta2 = 3/(6K + 2G).
struct Compliance {
  Ratio theta1, theta2;

  Compliance(const Ratio& first, const Ratio& second) : theta1(first), theta2(second) {}
  explicit Compliance(const Moduli& of)
      : theta1(inverse(Long(2) * of.G)), theta2(Long(3) * inverse(Long(6) * of.K + Long(2) * of.G)) {}
  /// The rate of theta1 is 1/relaxation_time, that of theta2 `rate_factor` times as large.
  Compliance(const Long& bulk, const Long& shear, const Long& relaxation_time, int rate_factor);
};

/// The function of time instantaneous delta(t) + sum amplitude e^(-rate t).
struct Exponentials {
  struct Term {
    LongComplex amplitude, rate;
  };
  Long instantaneous;
  std::vector<Term> terms;
};

/// The function of time whose Laplace transform is the ratio, by the roots of its denominator that do not cancel.
inline Exponentials in_exponentials(Ratio ratio) {
  auto& [above, below] = ratio;
  above.normalize();
  below.normalize();
  const Long last = below.data().back();
  const bool at_once = above.size() == below.size();
  Exponentials function{at_once ? Long(above.data().back() / last) : Long(0), {}};
  // The root 0 of a fluid is split off exactly.
  const bool flows = below.size() > 1 && below[0] == 0;
  std::vector<LongComplex> roots = roots_of<700>(flows ? below >> 1 : below);
  if (flows) roots.emplace_back(0);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const LongComplex value = value_at(above, roots[i]);
    const Long parts = value_at(above, LongComplex(Long(abs(roots[i])))).real();
    if (abs(value) > Long("1e-90") * abs(parts))
      function.terms.push_back({value / (last * apart(roots, i)), -roots[i]});
  }
  return function;
}

/// theta1 and theta2 of a material as functions of time.
struct BothFunctions {
  Exponentials theta1, theta2;

  BothFunctions(Exponentials first, Exponentials second)
      : theta1(std::move(first)), theta2(std::move(second)) {}
  explicit BothFunctions(const Compliance& of)
      : theta1(in_exponentials(of.theta1)), theta2(in_exponentials(of.theta2)) {}
};

}  // namespace nipref::verify::confirm
