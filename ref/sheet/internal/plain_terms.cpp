#include <climits>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/sheet/internal/plain_terms.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>

namespace nipref::ref {
namespace {

struct PlainTermKey {
  int n;
  mpfr_prec_t precision;

  auto operator<=>(const PlainTermKey&) const = default;
};

PlainTerm make_term(const PlainTermKey& key) {
  const ComplexInterval z = sheet_root_interval(key.n, key.precision);
  const ComplexInterval sech = reciprocal({cosh(z.real) * cos(z.imag), sinh(z.real) * sin(z.imag)});
  const ComplexInterval square = sech * sech, over_z = reciprocal(z);
  const auto minus = [](const ComplexInterval& x) -> ComplexInterval { return {-x.real, -x.imag}; };
  return {z,
          {z * square * square, square, minus(square * sech), sech, over_z, minus(over_z * sech),
           minus(z * square * sech)}};
}

std::size_t size_of_term(const PlainTerm& term) {
  return static_cast<std::size_t>(32 * term.z.real.precision()) / CHAR_BIT;
}

}  // namespace

std::shared_ptr<const PlainTerm> plain_term(int n, mpfr_prec_t precision) {
  static Cache<PlainTermKey, PlainTerm> kept(make_term, size_of_term);
  return kept.at({n, precision});
}

ComplexInterval reciprocal(const ComplexInterval& x) {
  const Interval size = square(x.real) + square(x.imag);
  return {x.real / size, -(x.imag / size)};
}

void check_residue_terms(int terms) {
  if (terms >= 1 && terms <= most_residue_terms) return;
  throw data::BadInput("terms", std::to_string(terms),
                       "must be from 1 to " + std::to_string(most_residue_terms));
}

bool is_negligible(int n, const Interval& x, mpfr_prec_t precision, Interval& bound) {
  bound = 1100 * exp(-((2L * n - 1) * (Interval::pi(x.precision()) * x) / 2));
  return mpfr_zero_p(bound.upper()) != 0 || mpfr_get_exp(bound.upper()) < -precision;
}

}  // namespace nipref::ref
