#include <algorithm>

#include <nipref/fast/material/internal/polynomial.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_compliance.hpp>

namespace nipref::fast {
namespace {

using internal::OctupleComplex;
using internal::rounded;

OctupleComplex exactly(std::complex<double> z) { return {z.real(), z.imag()}; }

/// The numerator of N over the denominator prod_k (s_k + z). The imaginary parts of its coefficients cancel.
internal::Polynomial numerator(const std::vector<Memory>& terms) {
  using Complex = boost::math::tools::polynomial<OctupleComplex>;
  const auto linear = [](const Memory& term) { return Complex{exactly(term.rate), 1}; };
  Complex whole{1};
  for (const Memory& term : terms) whole *= linear(term);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    Complex others{exactly(terms[k].amplitude)};
    for (std::size_t l = 0; l < terms.size(); ++l)
      if (l != k) others *= linear(terms[l]);
    whole += others;
  }
  std::vector<internal::Octuple> real;
  for (const OctupleComplex& c : whole.data()) real.push_back(c.real());
  return real;
}

/// m_j = 1/N'(-r_j). Differences of rates are taken in the precision of the roots.
RollingCompliance inverted(const std::vector<Memory>& terms) {
  RollingCompliance result{terms, {}, {1}, {}};
  if (result.terms.empty()) return result;
  std::vector<OctupleComplex> roots = internal::paired_roots_of(numerator(result.terms));
  std::ranges::stable_sort(roots, std::greater(),
                           [](const OctupleComplex& root) { return std::abs(rounded(root)); });
  OctupleComplex stiffness = 1;
  for (const OctupleComplex& root : roots) {
    OctupleComplex slope;
    std::vector<OctupleComplex> ratios;
    for (const Memory& term : result.terms) {
      const OctupleComplex over_difference = 1 / (root + exactly(term.rate));
      ratios.push_back(exactly(term.amplitude) * over_difference);
      slope -= ratios.back() * over_difference;
    }
    const OctupleComplex amplitude = 1 / slope;
    result.inverse.push_back({rounded(amplitude), -rounded(root)});
    stiffness -= amplitude / root;
    result.stiffness.push_back(rounded(stiffness).real());
    std::vector<std::complex<double>>& row = result.closure.emplace_back();
    for (const OctupleComplex& ratio : ratios) row.push_back(-rounded(amplitude * ratio));
  }
  // The zero z of a pair with Im z > 0 is minus the rate with Im < 0.
  for (std::size_t j = 0; j + 1 < result.inverse.size(); ++j) {
    if (!(result.inverse[j].rate.imag() < 0)) continue;
    std::swap(result.inverse[j], result.inverse[j + 1]);
    std::swap(result.closure[j], result.closure[j + 1]);
    ++j;
  }
  return result;
}

}  // namespace

RollingCompliance rolling_compliance(const std::vector<Memory>& terms) {
  static Cache<std::vector<Memory>, RollingCompliance> kept(inverted);
  return *kept.at(terms);
}

}  // namespace nipref::fast
