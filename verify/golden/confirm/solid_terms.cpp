#include <string>

#include <nipref/verify/golden/confirm/rational.hpp>
#include <nipref/verify/golden/confirm/solid_terms.hpp>

namespace nipref::verify::confirm {
namespace {

using Coefficients = Polynomial<Long>;

constexpr int thesis = 1, prony = 2, operators = 3, two_moduli = 4;

SolidFunction relaxing(const Long& at_once, const Long& rate, int rate_factor) {
  return {at_once, {{LongComplex(at_once * rate), LongComplex(rate * rate_factor)}}};
}

/// function: theta1 or theta2.
SolidFunction series(Arguments x, const std::string& function) {
  SolidFunction sum{Long(x[function + "_instantaneous"]), {}};
  for (const char* term : {"", "_2"}) {
    if (const double amplitude = x[function + "_amplitude" + term]; amplitude != 0)
      sum.terms.push_back({LongComplex(amplitude), LongComplex(x[function + "_rate" + term])});
  }
  return sum;
}

SolidFunction fraction(const Coefficients& above, const Coefficients& below) {
  const Long last = below.data().back();
  const bool at_once = above.size() == below.size();
  SolidFunction function{at_once ? Long(above.data().back() / last) : Long(0), {}};
  // The root 0 of a fluid is split off exactly.
  const bool flows = below.size() > 1 && below[0] == 0;
  std::vector<LongComplex> roots = roots_of<700>(flows ? below >> 1 : below);
  if (flows) roots.emplace_back(0);
  for (std::size_t i = 0; i < roots.size(); ++i)
    function.terms.push_back({value_at(above, roots[i]) / (last * apart(roots, i)), -roots[i]});
  return function;
}

}  // namespace

SolidTerms solid_terms(Arguments x) {
  const int model = static_cast<int>(x["material"]);
  if (model == prony) return {series(x, "theta1"), series(x, "theta2")};
  if (model == operators) {
    const auto of = [&](const std::string& name) {
      Coefficients polynomial{Long(x[name + "_0"]), Long(x[name + "_1"]), Long(x[name + "_2"])};
      polynomial.normalize();
      return polynomial;
    };
    const Coefficients p = of("P"), q = of("Q"), p_bulk = of("P_dilatation"), q_bulk = of("Q_dilatation");
    const SolidFunction theta1 = fraction(p, Long(2) * q);
    // A common factor of p and p_bulk would be a double root of their product.
    if (p == p_bulk) return {theta1, fraction(Long(3) * p, Long(6) * q_bulk + Long(2) * q)};
    return {theta1, fraction(Long(3) * p * p_bulk, Long(6) * q_bulk * p + Long(2) * q * p_bulk)};
  }
  const Long bulk = x["bulk"], rate = 1 / Long(x["relaxation_time"]);
  const Long shear = model == two_moduli ? Long(x["shear"]) : Long(3 * bulk / 8);
  return {relaxing(1 / (2 * shear), rate, 1),
          relaxing(3 / (6 * bulk + 2 * shear), rate, model == thesis ? 2 : 1)};
}

}  // namespace nipref::verify::confirm
