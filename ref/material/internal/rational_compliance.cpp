#include <algorithm>
#include <utility>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/material/internal/rational_compliance.hpp>

namespace nipref::ref {
namespace {

/// Whether each point is a zero of p to a relative error `unit`: within n |p/p'| of it there is a zero, and these
/// discs do not overlap.
bool are_zeros(const FloatPolynomial& p, const std::vector<ComplexFloat>& zeros, const Float& unit) {
  return std::ranges::all_of(zeros, [&](const ComplexFloat& zero) {
    const auto [value, slope] = p.at(zero);
    const bool alone = std::ranges::all_of(zeros, [&](const ComplexFloat& other) {
      return &other == &zero || abs(other - zero) > sqrt(unit) * abs(zero);
    });
    return alone && p.degree() * abs(value) <= unit * abs(slope) * abs(zero);
  });
}

/// All zeros, checked; a zero at 0 is exact and comes last.
std::vector<ComplexFloat> zeros_of(Polynomial p, const Float& unit, const char* name) {
  const bool flows = sgn(p[0]) == 0;
  if (flows) p.erase(p.begin());
  const FloatPolynomial others(p);
  std::vector<ComplexFloat> zeros = approximate_zeros(others, unit);
  if (sgn(p[0]) == 0 || !are_zeros(others, zeros, unit)) {
    throw data::NoMaterial(name, "(its roots)",
                           "must have rates that are apart: two of them are one, or nearly so");
  }
  if (flows) zeros.emplace_back();
  return zeros;
}

ComplexFloat rounded(const ComplexFloat& x) {
  return {at_working_precision(x.re), at_working_precision(x.im)};
}

}  // namespace

Compliance rational_compliance(Polynomial numerator, Polynomial denominator, const char* name) {
  cancel(numerator, denominator);
  if (numerator.size() > denominator.size() || numerator.size() + 1 < denominator.size())
    throw data::NoMaterial(name, "(its degree)",
                           "must give way at once by a finite compliance or by a dashpot");
  const mpq_class gain =
      numerator.size() < denominator.size() ? mpq_class(0) : mpq_class(numerator.back() / denominator.back());

  const mpfr_prec_t bits = working_bits();
  const Float unit = ldexp(Float(1), -bits - 8);
  std::vector<ComplianceTerm> terms;
  {
    const WorkingDigits working(static_cast<int>(static_cast<double>(2 * bits) * 0.302) + 10);
    const FloatPolynomial above(numerator), below(denominator);
    for (ComplexFloat zero : zeros_of(denominator, unit, name)) {
      if (abs(zero.im) <= unit * abs(zero)) zero.im = 0;
      if (zero.im > 0) continue;  // the term of its conjugate stands for both
      const ComplexFloat residue = above.at(zero).first / below.at(zero).second;
      terms.push_back({residue * Float(zero.is_real() ? 1 : 2), -zero});
    }
  }
  Compliance result{to_float(Exact(gain)), {}};
  for (const ComplianceTerm& term : terms)
    result.terms.push_back({rounded(term.amplitude), rounded(term.rate)});
  return result;
}

}  // namespace nipref::ref
