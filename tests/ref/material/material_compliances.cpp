// Quotients of polynomials as sums of fading terms.
#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

namespace {

Compliance compliance(const Polynomial& numerator, const Polynomial& denominator) {
  return compliance_of(
      exact_material(ExactRationalSolid{{}, {}, {numerator, denominator}, {{1}, {1}}}).theta1);
}

bool near(const Float& x, const Float& y) { return abs(x - y) <= 1e-38 * (1 + abs(y)); }

}  // namespace

TEST_CASE("compliances: real rates and a conjugate pair are found as they were put together") {
  const WorkingDigits working(40);
  // 2 + 3/(p + 1/7) + (p + 5)/(p^2 + 2 p + 10), the pair's rates 1 +- 3 i
  const Polynomial single{mpq_class(1, 7), 1}, pair{10, 2, 1};
  const Polynomial numerator = 2 * single * pair + 3 * pair + Polynomial{5, 1} * single;
  const Compliance found = compliance(numerator, single * pair);
  CHECK(near(found.at_once, 2));
  REQUIRE(found.terms.size() == 3);
  for (const ComplianceTerm& term : found.terms) {
    if (term.rate.is_real()) {
      CHECK(near(term.rate.re, Float(1) / 7));
      CHECK(near(term.amplitude.re, 3));
    } else {
      CHECK(near(term.rate.re, 1));
      const int sign = term.rate.im > 0 ? 1 : -1;
      CHECK(near(term.rate.im, 3 * sign));
      // 2 Re amplitude e^{-(1 + 3i) t} = e^{-t} (cos 3t + (4/3) sin 3t)
      CHECK(near(term.amplitude.re, 0.5));
      CHECK(near(term.amplitude.im, Float(2 * sign) / 3));
    }
  }
}

TEST_CASE("compliances: common factors cancel exactly, and rates need not be doubles' size apart") {
  const WorkingDigits working(40);
  const Polynomial common{mpq_class(1, 3), 1}, rest{2, 1}, zero{5, 1};
  const Compliance found = compliance(common * zero, common * rest);
  REQUIRE(found.terms.size() == 1);
  CHECK(near(found.terms[0].rate.re, 2));
  CHECK(near(found.terms[0].amplitude.re, 3));
  const mpq_class small = mpq_class(1) / mpq_class(mpz_class("100000000000000000000"));
  const Compliance close = compliance(zero * zero, Polynomial{2, 1} * Polynomial{2 + small, 1});
  CHECK(close.terms.size() == 2);
}

TEST_CASE("compliances: a fluid's rate is 0 exactly and once, and what gives way to nothing at once") {
  const WorkingDigits working(40);
  // 2 + 3/p + 5/(p + 7)
  const Polynomial rate{7, 1}, flow{0, 1};
  const Polynomial numerator = 2 * flow * rate + 3 * rate + 5 * flow;
  const Compliance fluid = compliance(numerator, flow * rate);
  REQUIRE(fluid.terms.size() == 2);
  for (const ComplianceTerm& term : fluid.terms) {
    CHECK((term.rate.re == 0 || near(term.rate.re, 7)));
    CHECK(near(term.amplitude.re, term.rate.re == 0 ? 3 : 5));
  }
  CHECK_THROWS_AS((void)compliance(numerator, flow * flow * rate), nipref::data::BadInput);
  const Compliance creeping = compliance({3}, {14, 18});
  CHECK(creeping.at_once == 0);
  REQUIRE(creeping.terms.size() == 1);
  CHECK(near(creeping.terms[0].amplitude.re, Float(1) / 6));
}

TEST_CASE("compliances: a twofold rate is refused by name") {
  const WorkingDigits working(40);
  const Polynomial twice{2, 1}, zero{5, 1};
  CHECK_REFUSED(compliance(zero * zero, twice * twice), "Q = ");
}
