#include <optional>

#include <nipref/ref/material/internal/partial_fractions.hpp>

namespace nipref::ref {
namespace {

using Points = std::vector<ComplexInterval>;

ComplexInterval at(const Polynomial& p, const ComplexInterval& z) {
  const mpfr_prec_t bits = z.re.precision();
  ComplexInterval value{Interval(bits), Interval(bits)};
  for (std::size_t k = p.size(); k-- > 0;) {
    value = value * z;
    value.re = value.re + Interval(p[k], bits);
  }
  return value;
}

/// prod (z_i - z_j)
ComplexInterval apart(const Points& points, std::size_t i) {
  const mpfr_prec_t bits = points[i].re.precision();
  ComplexInterval product{Interval(1L, bits), Interval(bits)};
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j != i) product = product * (points[i] - points[j]);
  }
  return product;
}

/// The discs that contain one root each; nothing if some discs overlap.
std::optional<Points> proven_roots(const Polynomial& denominator, mpfr_prec_t bits) {
  const Points near = roots_near(denominator, bits);
  const Exact last(last_of(denominator));
  std::vector<Interval> radii;
  Points roots;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Interval lead = abs(apart(near, i)) * Interval(mpq_class(abs(last.value())), bits);
    if (mpfi_has_zero(lead.get()) > 0) return {};
    radii.push_back(static_cast<long>(near.size()) * (abs(at(denominator, near[i])) / lead));
    roots.push_back({near[i].re.widened(radii[i]), near[i].im.widened(radii[i])});
  }
  for (std::size_t i = 0; i < near.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Interval between = abs(near[i] - near[j]) - radii[i] - radii[j];
      if (sign_of(between) <= 0) return {};
    }
  }
  return roots;
}

}  // namespace

std::vector<OscillatingTerm> partial_fractions(const Polynomial& numerator, const Polynomial& denominator,
                                               mpfr_prec_t bits) {
  std::optional<Points> roots = proven_roots(denominator, bits);
  while (!roots) roots = proven_roots(denominator, bits *= 2);
  std::vector<OscillatingTerm> terms;
  for (std::size_t i = 0; i < roots->size(); ++i) {
    const ComplexInterval& root = (*roots)[i];
    const ComplexInterval slope = Interval(last_of(denominator), bits) * apart(*roots, i);
    terms.push_back({at(numerator, root) * inverse(slope), -root});
  }
  return terms;
}

bool has_repeated_root(const Polynomial& denominator) {
  Polynomial slope = denominator.prime(), factor = denominator;
  if (slope.is_zero()) return false;
  cancel(slope, factor);
  return factor.size() < denominator.size();
}

}  // namespace nipref::ref
