#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/ref/sheet/field.hpp>
#include <nipref/ref/sheet/internal/field_integral.hpp>

#include "support/intervals.hpp"
#include "support/symbol_sizes.hpp"
#include "support/test.hpp"

using namespace nipref;
using namespace nipref::ref;
using data::SheetLoad;

namespace {

/// Upper bound on a cell of |z|^3 (|2z/(S cosh z)| + |2z/(S sinh z)|) e^{3x}; the symbols: 8 z e^{-3z}/(Q (1 +- e2)).
double weight(double left, double right) {
  const SymbolSizes at({cell(left, right), Interval(field_line, SymbolSizes::bits)});
  return highest(8 * square(square(abs(at.z))) / abs(at.q) *
                 (1 / abs(at.one + at.e2) + 1 / abs(at.one - at.e2)));
}

}  // namespace

TEST_CASE("the integral that bounds the field's aliasing holds on an interval mesh") {
  // The integrand is the weight times e^{-3x} e^{x}, over both halves of the line. From x = 20 on
  // |z|^4 8 (1/|Q|)(1/|1+q| + 1/|1-q|) < 17 x^4, and the rest of the integral is below 1e-11.
  double sum = 0;
  constexpr double width = 1.0 / 512;
  for (double left = 0; left < 20; left += width)
    sum += 2 * weight(left, left + width) * std::exp(-2 * left) * width * (1 + 1e-12);
  sum += 1e-11;
  MESSAGE("integral along the line: ", sum);
  CHECK(sum <= field_line_integral);
  CHECK(2 * sum >= field_line_integral);
}

TEST_CASE("the curvature of the field along the sheet is bounded by 160 over the fourth power of the depth") {
  // 2 z e^{2z}/S <= 1/2 + 4z: below 0.01 because S >= 4z, from 0.25 on because S >= e^{2z}/2, in between on a mesh.
  for (double z = 0.01; z < 0.3; z += 1e-4) {
    const Interval x = cell(z, z + 1e-4), twice = 2 * x;
    const Interval left = twice * exp(twice) / (sinh(twice) + twice);
    CHECK_UNARY(highest(left) <= 0.5 + 4 * z);
  }
  for (const double depth : {0.0, 0.5, -0.8, 0.95}) {
    const double from_face = 1 - std::fabs(depth), most = 160 / std::pow(from_face, 4);
    double largest = 0;
    for (const SheetLoad load : {SheetLoad::normal, SheetLoad::shear}) {
      for (const double alpha : {0.0, 0.02, 0.3, 2.0}) {
        const auto curvature = [&](const auto& kernel) {
          const auto at = [&](double place) {
            return kernel(Exact(mpq_class(alpha) + mpq_class(place))).value;
          };
          const double step = 0x1p-20 * from_face;
          const Float second = at(step) - 2 * at(0) + at(-step);
          largest = std::max(largest, std::fabs(static_cast<double>(second)) / (step * step));
        };
        const Exact here(depth), poisson(0.25), middle(0.0);
        curvature([&](const Exact& a) { return sheet_across(a, here, load, 40); });
        curvature([&](const Exact& a) { return sheet_along(a, here, load, 40); });
        curvature([&](const Exact& a) { return sheet_shear(a, here, load, 40); });
        curvature([&](const Exact& a) { return sheet_u(a, here, load, poisson, 40); });
        curvature([&](const Exact& a) { return sheet_v(a, middle, here, load, poisson, 40); });
      }
    }
    CAPTURE(depth);
    CHECK(largest <= most);
    CHECK(largest >= 1e-3 * most * from_face);
  }
}

TEST_CASE("what the field's sum and series leave out is bounded by 25 and 1300") {
  // From x = 8 on the second parts times e^{3x}/x are at most 8/((1 - q^2)(1 - q)), q = e^{-2x}.
  const Interval q = cell(0, std::exp(-16.0) * (1 + 1e-12)), second = 8 / ((1 - square(q)) * (1 - q));
  CHECK(highest(second) <= 9.3);
  CHECK(highest(4 * Interval(9.3, SymbolSizes::bits) / (2 - Interval(4L, SymbolSizes::bits) / 8)) <=
        field_sum_remainder);
  // Bounds of e^x/|cosh z| at a root; of |c_n| over |z_n|, y_n and y_n^2; of the sum beyond N, largest at alpha = 1.
  CHECK(highest(sqrt(1 / Interval(0.98, SymbolSizes::bits) + 1) + 1) <= 3.02);
  CHECK(highest(Interval(3.02, SymbolSizes::bits) * Interval(1.61, SymbolSizes::bits) / 2) <= 2.5);
  CHECK(highest(Interval(2.5, SymbolSizes::bits) * sqrt(Interval(2L, SymbolSizes::bits))) <= 5);
  for (long N = 1; N <= 100; ++N) {
    CAPTURE(N);
    Interval sum(SymbolSizes::bits);
    for (long n = N + 1; n <= N + 40; ++n)
      sum = sum + square(Interval(2 * n - 1, SymbolSizes::bits) / 2) *
                      exp(-((n - N - 1) * Interval::pi(SymbolSizes::bits)));
    CHECK(highest(80 * (square(Interval::pi(SymbolSizes::bits)) * sum)) <
          static_cast<double>(field_series_remainder * (N + 1) * (N + 1)));
  }
}

TEST_CASE("summation and residues agree on the field where both converge") {
  const mpq_class s(3, 10);
  const FieldIntegrand across{false,
                              false,
                              {{-1, 0, FieldSymbol::sinh_over_S, false},
                               {-1, 1, FieldSymbol::cosh_over_S, false},
                               {s, 1, FieldSymbol::sinh_over_S, true}}};
  const FieldIntegrand along{false,
                             false,
                             {{1, -1, FieldSymbol::cosh_over_S, false},
                              {-1, 0, FieldSymbol::sinh_over_S, false},
                              {s, 0, FieldSymbol::cosh_over_S, true}}};
  const FieldIntegrand odd{
      true, true, {{-1, -1, FieldSymbol::cosh_over_S, true}, {s, 0, FieldSymbol::cosh_over_S, false}}};
  for (const FieldIntegrand* integrand : {&across, &along, &odd}) {
    const FieldPoint at{Exact(1.0), Exact(s)};
    const Interval by_sum = field_by_summation(*integrand, at, 200),
                   by_roots = field_by_residues(*integrand, at, 200);
    CHECK(meet(by_sum, by_roots));
    CHECK(width_of(by_sum) < 1e-80);
  }
}

TEST_CASE("the field keeps its digits towards the load, and is exactly 0 where it must be") {
  const auto n = SheetLoad::normal, s = SheetLoad::shear;
  const Exact just_inside(1 - 0x1p-53), tiny = Exact::parse("1e-300"), zero(0.0), one(1.0);
  for (const SheetLoad load : {n, s}) {
    const Enclosure along = sheet_along(tiny, just_inside, load, 30);
    CHECK(mpfr_cmp_d(raw(along.error), 1e-30) <= 0);
    CHECK(sheet_across(tiny, one, load, 30).to_double() == 0);
    CHECK(sheet_shear(tiny, zero, load, 30).to_double() == 0);
  }
  CHECK(sheet_shear(zero, just_inside, n, 30).to_double() == 0);
  CHECK(sheet_v(tiny, tiny, zero, s, Exact(0.25), 30).to_double() == 0);
  // The load over its distance 2^-53, times -2/pi, and the small effect of the far face.
  CHECK(sheet_across(zero, just_inside, n, 30).to_double() ==
        doctest::Approx(-0x1p53 * 2 / 3.141592653589793).epsilon(1e-14));
}

TEST_CASE("the reference refuses bad places in the field by name") {
  const auto at = [](const char* alpha, const char* depth) {
    return sheet_across(Exact::parse(alpha), Exact::parse(depth), SheetLoad::normal, 20);
  };
  CHECK_REFUSED(at("0", "1"), "alpha = ");
  CHECK_REFUSED(at("1001", "0"), "alpha = ");
  CHECK_REFUSED(at("1", "1.0000001"), "depth = ");
  CHECK_NOTHROW((void)at("0", "0.9999"));
}
