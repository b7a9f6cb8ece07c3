#include <nipref/ref/material/rational_solid.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

using namespace nipref::ref;
using nipref::test::exact;
using nipref::test::exacts;

namespace {

constexpr int forty_digits = 40;
using Float60 = nipref::test::Decimal<60>;

Float60 number(const Enclosure& x) { return Float60(x.value_text()); }

void check_holds(const Enclosure& found, const Float60& truth) {
  CHECK(abs(number(found) - truth) <= Float60(found.error_text()));
}

}  // namespace

TEST_CASE("rational solids: equal roots have the terms t e^-t that their formula has, proven") {
  // theta1 = (p + 2)^2/(2 (p + 1)^2) has the fading part e^-t (1 + t/2).
  const auto solid =
      exact_operators(exacts({"4", "4", "1"}), exacts({"1", "2", "1"}), exacts({"1"}), exacts({"10"}));
  for (const std::string t : {"1e-30", "0.7", "30", "1000"}) {
    const Float60 time(t);
    check_holds(fading_part(solid.theta1, exact(t), forty_digits), exp(-time) * (1 + time / 2));
    // 1/(2 theta1) = (p + 1)^2/(p + 2)^2; divided by p it is 1/4 and e^-2t (3/4 - t/2) in time.
    check_holds(relaxation(solid.shear, exact(t), forty_digits), (1 + exp(-2 * time) * (3 - 2 * time)) / 4);
  }
}

TEST_CASE("rational solids: roots 1e-30 apart are neither one nor a loss") {
  // 1/2 + 1/2 (1/(p + 1) - 1/(p + 1 + d))/d, of which the difference is t e^-t (1 - d t/2 + ...)
  const std::string near = "1.000000000000000000000000000001";
  const auto solid = exact_prony({exact("0.5"), exacts({"5e29", "-5e29"}), exacts({"1", near})},
                                 {exact("0.1"), exacts({"0"}), exacts({"1"})});
  const Float60 d("1e-30"), t(3);
  check_holds(fading_part(solid.theta1, exact("3"), 30), t * exp(-t) * (1 - d * t / 2) / 2);
}

TEST_CASE("rational solids: creep that grows is a number up to 1000 digits, then refused as what it is") {
  // theta1 = 1 and theta2 = 6/(p + 1) make 6K = (p - 1)/2 and the creep 12 (e^t - 1).
  const auto unstable =
      exact_prony({exact("1"), exacts({"0"}), exacts({"1"})}, {exact("0"), exacts({"6"}), exacts({"1"})});
  check_holds(creep(unstable.dilatation, exact("3"), forty_digits), 12 * (exp(Float60(3)) - 1));
  CHECK(mpfr_get_exp(raw(creep(unstable.dilatation, exact("2299"), forty_digits).value)) ==
        3321);  // 2299/ln 2 + log2 12
  CHECK_REFUSED(creep(unstable.dilatation, exact("2301"), forty_digits),
                "t = 2301: must be at most 2.3e+03: the material is unstable");
}

TEST_CASE("rational solids: bad constants are refused by name") {
  const ExactSeries good{exact("1"), exacts({"1"}), exacts({"1"})};
  const auto prony_with = [&](const std::string& instantaneous, const std::string& rate) {
    return exact_prony({exact(instantaneous), exacts({"1"}), exacts({rate})}, good);
  };
  CHECK_REFUSED(prony_with("-1", "1"), "theta1_instantaneous = -1");
  CHECK_REFUSED(prony_with("1", "-2"), "theta1_rate = -2");
  CHECK_REFUSED(exact_operators(exacts({"1", "1"}), exacts({"1"}), exacts({"1"}), exacts({"1"})),
                "Q = of degree 0: must be of the degree of P, 1, or of one more");
  CHECK_REFUSED(exact_single_time(exact("1"), exact("1"), exact("0"), 2), "tau = 0");
  CHECK_REFUSED(creep(prony_with("1", "1").shear, exact("-1"), forty_digits), "t = -1");
  CHECK_REFUSED(fading_part(prony_with("1", "1").theta1, exact("1e9"), forty_digits), "t = 1000000000");
}
