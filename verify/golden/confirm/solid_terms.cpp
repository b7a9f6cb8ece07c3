#include <algorithm>

#include <nipref/verify/golden/confirm/solid_terms.hpp>

namespace nipref::verify::confirm {
namespace {

using Coefficients = std::vector<Long>;

constexpr int thesis = 1, prony = 2, operators = 3, two_moduli = 4;

SolidFunction relaxing(const Long& at_once, const Long& rate, int rate_factor) {
  return {at_once, {{LongComplex(at_once * rate), LongComplex(rate * rate_factor)}}};
}

SolidFunction series(std::span<const double> x) {
  SolidFunction function{Long(x[0]), {}};
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}})
    if (x[k] != 0) function.terms.push_back({LongComplex(x[k]), LongComplex(x[k + 1])});
  return function;
}

Coefficients polynomial(std::span<const double> x) {
  Coefficients c(x.begin(), x.end());
  while (c.size() > 1 && c.back() == 0) c.pop_back();
  return c;
}

Coefficients multiplied(const Long& factor, const Coefficients& a, const Coefficients& b) {
  Coefficients c(a.size() + b.size() - 1, Long(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) c[i + k] += factor * a[i] * b[k];
  }
  return c;
}

Coefficients added(Coefficients a, Coefficients b) {
  if (a.size() < b.size()) std::swap(a, b);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
  return a;
}

LongComplex value_at(const Coefficients& c, const LongComplex& p) {
  LongComplex sum(0);
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * p + LongComplex(c[k]);
  return sum;
}

/// The product of root_i - root_j over all other roots.
LongComplex apart(const std::vector<LongComplex>& roots, std::size_t i) {
  LongComplex product(1);
  for (std::size_t j = 0; j < roots.size(); ++j) {
    if (j != i) product *= roots[i] - roots[j];
  }
  return product;
}

std::vector<LongComplex> roots_of(const Coefficients& c) {
  const std::size_t n = c.size() - 1;
  Long size = 0;
  for (std::size_t k = 0; k < n; ++k)
    size = std::max<Long>(size, pow(Long(abs(c[k] / c.back())), 1 / Long(n - k)));
  std::vector<LongComplex> roots;
  LongComplex start(Long("0.4") * size, Long("0.9") * size), next(1);
  for (std::size_t k = 0; k < n; ++k) roots.push_back(next *= start);
  for (std::size_t k = 0; k < n; ++k) roots[k] /= pow(size, Long(k));
  Long change = 1;
  for (int round = 0; change > Long("1e-680") && round < 4000; ++round) {
    change = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const LongComplex step = value_at(c, roots[i]) / (c.back() * apart(roots, i));
      roots[i] -= step;
      if (roots[i] != LongComplex(0)) change = std::max<Long>(change, abs(step) / abs(roots[i]));
    }
  }
  return roots;
}

SolidFunction fraction(const Coefficients& above, Coefficients below) {
  const bool at_once = above.size() == below.size();
  SolidFunction function{at_once ? Long(above.back() / below.back()) : Long(0), {}};
  // The root 0 of a fluid is split off exactly.
  const bool flows = below.size() > 1 && below.front() == 0;
  Coefficients rest = below;
  if (flows) rest.erase(rest.begin());
  std::vector<LongComplex> roots = roots_of(rest);
  if (flows) roots.emplace_back(0);
  for (std::size_t i = 0; i < roots.size(); ++i)
    function.terms.push_back({value_at(above, roots[i]) / (below.back() * apart(roots, i)), -roots[i]});
  return function;
}

}  // namespace

SolidTerms solid_terms(Arguments x) {
  const int model = static_cast<int>(x["material"]);
  if (model == prony) return {series(x.from("theta1_instantaneous")), series(x.from("theta2_instantaneous"))};
  if (model == operators) {
    const auto of = [&](const char* first) { return polynomial(x.from(first).first(3)); };
    const Coefficients p = of("P_0"), q = of("Q_0"), p_bulk = of("P_dilatation_0"),
                       q_bulk = of("Q_dilatation_0"), one{Long(1)};
    const SolidFunction theta1 = fraction(p, multiplied(2, q, one));
    // A common factor of p and p_bulk would be a double root of their product.
    if (p == p_bulk)
      return {theta1,
              fraction(multiplied(3, p, one), added(multiplied(6, q_bulk, one), multiplied(2, q, one)))};
    return {theta1,
            fraction(multiplied(3, p, p_bulk), added(multiplied(6, q_bulk, p), multiplied(2, q, p_bulk)))};
  }
  const Long bulk = x["bulk"], rate = 1 / Long(x["relaxation_time"]);
  const Long shear = model == two_moduli ? Long(x["shear"]) : Long(3 * bulk / 8);
  return {relaxing(1 / (2 * shear), rate, 1),
          relaxing(3 / (6 * bulk + 2 * shear), rate, model == thesis ? 2 : 1)};
}

}  // namespace nipref::verify::confirm
