#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/sheet/internal/field_integral.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>

namespace nipref::ref {
namespace {

/// The N for which the truncation error is below about e^{-nats}.
long field_terms_needed(double alpha, double nats) {
  double terms = 1;
  for (int pass = 0; pass < 3; ++pass) {
    terms = (nats + std::log(static_cast<double>(field_series_remainder)) + 2 * std::log(terms + 1)) /
                (std::numbers::pi * alpha) -
            0.5;
    terms = std::max(terms, 1.0);
  }
  return static_cast<long>(std::ceil(terms));
}

/// sum of factor c e^{i alpha z} over the terms, c without its 1/2.
ComplexInterval pole_term(const FieldIntegrand& integrand, const FieldPoint& at, const SheetPole& pole) {
  const mpfr_prec_t precision = pole.z.re.precision();
  const Interval alpha(at.alpha, precision), s(at.depth, precision);
  const Interval size = exp(-(alpha * pole.z.im)), angle = alpha * pole.z.re;
  const Interval a = s * pole.z.re, b = s * pole.z.im;
  const ComplexInterval grows{cosh(a) * cos(b), sinh(a) * sin(b)}, rises{sinh(a) * cos(b), cosh(a) * sin(b)};
  const ComplexInterval cubed = pole.sech * pole.sech * pole.sech;
  const ComplexInterval of_sinh = -(pole.z * cubed);
  ComplexInterval sum{Interval(precision), Interval(precision)};
  for (const FieldTerm& term : integrand.terms) {
    ComplexInterval next =
        (term.symbol == FieldSymbol::sinh_over_S ? of_sinh : pole.sech) * (term.sinh ? rises : grows);
    if (term.power > 0) next = next * pole.z;
    if (term.power < 0) next = next * inverse(pole.z);
    sum = sum + Interval(term.factor, precision) * next;
  }
  return ComplexInterval{size * cos(angle), size * sin(angle)} * sum;
}

/// The residue of a term at 0 over pi/4, the part that does not decay.
mpq_class at_origin(const FieldTerm& term, const FieldPoint& at) {
  const int order = term.power + (term.sinh ? 1 : 0) - (term.symbol == FieldSymbol::cosh_over_S ? 1 : 0);
  if (order == -1) return term.sinh ? mpq_class(term.factor * at.depth.value()) : term.factor;
  return order == -2 ? mpq_class(-term.factor * at.alpha.value()) : mpq_class(0);
}

}  // namespace

Interval field_by_residues(const FieldIntegrand& integrand, const FieldPoint& at, double nats) {
  const double alpha = at.alpha.approximate();
  const long terms = field_terms_needed(alpha, nats);
  Interval sum(mpfr_prec_t{64});
  for (long n = terms; n >= 1; --n) {
    const auto pole = sheet_pole(n, term_precision(n, alpha, nats));
    const ComplexInterval next = pole_term(integrand, at, *pole);
    sum = integrand.sine ? sum + next.re : sum - next.im;
  }
  mpq_class quarters = 0;
  for (const FieldTerm& term : integrand.terms) quarters += at_origin(term, at);
  Interval value = sum;
  if (quarters != 0) {
    const mpfr_prec_t precision = std::max(sum.precision(), working_precision(nats, alpha));
    value = Interval(mpq_class(quarters / 4), precision) + sum;
  }
  const long count = terms + 1;
  Interval tail =
      field_series_remainder *
      (count * (count * exp(-((2 * terms + 1) * (Interval::pi(64) * Interval(at.alpha, 64)) / 2))));
  if (integrand.odd_in_depth) tail = Interval(at.depth, 64) * tail;
  return value.widened(tail);
}

}  // namespace nipref::ref
