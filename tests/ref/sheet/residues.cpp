#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/internal/transform.hpp>

#include "support/all_symbols.hpp"
#include "support/intervals.hpp"
#include "support/test.hpp"

using namespace nipref::ref;

namespace {

/// The contribution of the poles of tanh, which the trapezoidal rule subtracts from I1: ln coth(pi x/3).
Interval subtracted_part(Symbol symbol, const Exact& x, mpfr_prec_t precision) {
  if (symbol != Symbol::I1) return Interval(precision);
  return log1p(2 / expm1(2 * Interval::pi(precision) * Interval(x, precision) / 3));
}

double log2_width(const Interval& x) {
  Float width = zero_of_bits(64);
  mpfi_diam_abs(raw(width), x.get());
  return static_cast<double>(mpfr_get_exp(raw(width)));
}

}  // namespace

TEST_CASE("the bounds of the residues are those that interval arithmetic makes of them") {
  constexpr mpfr_prec_t bits = 64;
  const Interval r = Interval::pi(bits) / 2, square_of_cosh = (sqrt(4 * square(r) - 1) - 1) / 2;
  CHECK(lowest(square_of_cosh) >= 0.98);
  CHECK(highest(r / square_of_cosh) <= 1.61);
  const Interval least(0.98, bits), most(1.61, bits), root = sqrt(least);
  for (const Interval& residue : {most / (2 * least), 1 / (2 * least), 1 / (2 * least * root), 1 / (2 * root),
                                  1 / (2 * r * least), 1 / (2 * r * root), most / (2 * root)})
    CHECK(highest(residue) < 1);
  CHECK(highest(2 * Interval::pi(bits) / (1 - exp(-Interval::pi(bits)))) <= series_remainder);
  for (long n = 1; n <= 100; ++n) {
    const auto pole = sheet_pole(n, bits);
    const Interval size = abs(pole->z), cosh_size = 1 / abs(pole->sech);
    CAPTURE(n);
    CHECK(highest(pole->z.re) < lowest(pole->z.im));
    CHECK(lowest(square(cosh_size)) >= 0.98);
    CHECK(highest(size / square(cosh_size)) <= 1.61);
    CHECK(highest(exp(pole->z.re) / cosh_size) <= 3.02);
  }
  CHECK(lowest(square(cosh(Interval::pi(bits))) / square(Interval::pi(bits))) >= 2.01);
}

TEST_CASE("the residue series and the trapezoidal rule enclose the same, as tightly as was asked") {
  for (const Symbol symbol : all_symbols) {
    for (const std::string text : {"1", "2.7", "17.3", "120"}) {
      for (const double more_nats : {3.0, 40.0, 110.0, 500.0}) {
        CAPTURE(bounds(symbol).name, text, more_nats);
        const Exact x = Exact::parse(text);
        const double nats = more_nats + 2.2 * x.approximate();
        const Interval series = residue_series(symbol, x, nats);
        const Interval sum = transform(symbol, x, nats) + subtracted_part(symbol, x, 1600);
        CHECK(meet(series, sum));  // they overlap
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
  CHECK(has_zero(coarse));
  CHECK(is_inside(fine, coarse));
}
