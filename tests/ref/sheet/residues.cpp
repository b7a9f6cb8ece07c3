#include <doctest/doctest.h>

#include <string>

#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/internal/transform.hpp>

#include "support/all_symbols.hpp"

using namespace nipref::ref;

namespace {

/// What the poles of tanh, which the trapezoidal rule subtracts from I1, contribute: ln coth(pi x/3).
Interval subtracted_part(Symbol symbol, const Exact& x, mpfr_prec_t precision) {
  if (symbol != Symbol::normal) return Interval(precision);
  return log1p(2 / expm1(2 * Interval::pi(precision) * Interval(x, precision) / 3));
}

double log2_width(const Interval& x) {
  Float width = zero_of_bits(64);
  mpfi_diam_abs(raw(width), x.get());
  return static_cast<double>(mpfr_get_exp(raw(width)));
}

}  // namespace

TEST_CASE("the residue series and the trapezoidal rule enclose the same, as tightly as was asked") {
  for (const Symbol symbol : all_symbols) {
    for (const std::string text : {"1", "2.7", "17.3", "120"}) {
      for (const double more_nats : {3.0, 40.0, 110.0, 500.0}) {
        CAPTURE(bounds(symbol).name);
        CAPTURE(text);
        CAPTURE(more_nats);
        const Exact x = Exact::parse(text);
        const double nats = more_nats + 2.2 * x.approximate();
        const Interval series = residue_series(symbol, x, nats);
        const Interval sum = transform(symbol, x, nats) + subtracted_part(symbol, x, 1600);
        CHECK(mpfi_cmp(series.get(), sum.get()) == 0);  // they overlap
        CHECK(log2_width(sum) <= 3 - nats / 0.6931);
        CHECK(log2_width(series) <= 2 - nats / 0.6931);
      }
    }
  }
}

TEST_CASE("where nothing of the series is needed its remainder still covers the value") {
  const Exact x = Exact::parse("20");
  const Interval coarse = residue_series(Symbol::I7, x, 20);
  const Interval fine = residue_series(Symbol::I7, x, 150);
  CHECK(mpfi_has_zero(coarse.get()) > 0);
  CHECK(mpfr_cmp(coarse.lower(), fine.lower()) <= 0);
  CHECK(mpfr_cmp(coarse.upper(), fine.upper()) >= 0);
}
