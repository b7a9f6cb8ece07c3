#include <climits>
#include <memory>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/memo.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {
namespace {

ComplexInterval reciprocal(const ComplexInterval& x) {
  const Interval size = square(x.real) + square(x.imag);
  return {x.real / size, -(x.imag / size)};
}

/// A root and the residues' coefficients there, doubled: z/cosh^4 z, 1/cosh^2 z and 1/z, see residue_series().
struct PlainTerm {
  ComplexInterval z, I1, I3, I6;
};

struct PlainTermKey {
  int n;
  mpfr_prec_t precision;

  auto operator<=>(const PlainTermKey&) const = default;
};

PlainTerm make_term(const PlainTermKey& key) {
  const ComplexInterval z = sheet_root_interval(key.n, key.precision);
  const ComplexInterval sech = reciprocal({cosh(z.real) * cos(z.imag), sinh(z.real) * sin(z.imag)});
  const ComplexInterval square = sech * sech;
  return {z, z * square * square, square, reciprocal(z)};
}

std::size_t size_of_term(const PlainTerm& term) {
  return static_cast<std::size_t>(16 * term.z.real.precision()) / CHAR_BIT;
}

std::shared_ptr<const PlainTerm> plain_term(int n, mpfr_prec_t precision) {
  static Memo<PlainTermKey, PlainTerm> kept(make_term, size_of_term);
  return kept.at({n, precision});
}

const ComplexInterval& coefficient(const PlainTerm& term, PlainKernel kernel) {
  if (kernel == PlainKernel::I1) return term.I1;
  return kernel == PlainKernel::I3 ? term.I3 : term.I6;
}

}  // namespace

Interval plain_series(PlainKernel kernel, const Interval& alpha, int terms) {
  if (terms < 1 || terms > most_residue_terms)
    throw data::BadInput("terms", std::to_string(terms),
                         "must be from 1 to " + std::to_string(most_residue_terms));
  const mpfr_prec_t precision = alpha.precision();
  const bool odd = kernel == PlainKernel::I3, behind = mpfr_sgn(alpha.upper()) < 0;
  const Interval a = behind ? -alpha : alpha, pi = Interval::pi(precision);
  Interval sum(precision);
  for (int n = 1; n <= terms; ++n) {
    // No more is left: at most 500 terms, Im z_n > (n - 1/2) pi and coefficients below 2.1, see residue_series().
    const Interval rest = 1100 * exp(-((2 * n - 1) * (pi * a) / 2));
    if (mpfr_cmp_d(rest.upper(), 0) == 0 || mpfr_get_exp(rest.upper()) < -precision) {
      sum = sum.widened(rest);
      break;
    }
    const PlainTerm& term = *plain_term(n, precision + 32);
    const Interval size = exp(-(a * term.z.imag)), angle = a * term.z.real;
    const ComplexInterval wave = coefficient(term, kernel) * ComplexInterval{cos(angle), sin(angle)};
    sum = sum + size * (odd ? wave.real : wave.imag);
  }
  if (!odd) {
    const Interval series = -(pi * sum);
    return kernel == PlainKernel::I1 ? series : series - pi * a / 4;
  }
  const Interval value = pi / 4 + pi * sum;
  return behind ? -value : value;
}

}  // namespace nipref::ref
