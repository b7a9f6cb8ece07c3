#include <nipref/ref/material/moduli.hpp>
#include <nipref/ref/material/rational_solid.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

using namespace nipref::ref;
using nipref::data::BadInput;
using nipref::test::exact;

namespace {

constexpr int digits = 40;
using Float60 = nipref::test::Decimal<60>;

Float60 number(const Enclosure& x) { return Float60(x.value_text()); }

std::vector<Exact> exacts(const std::vector<std::string>& texts) {
  std::vector<Exact> result;
  for (const std::string& text : texts) result.push_back(exact(text));
  return result;
}

void check_holds(const Enclosure& found, const Float60& truth) {
  Float60 off = number(found) - truth;
  if (off < 0) off = -off;
  CHECK(off <= Float60(found.error_text()));
}

}  // namespace

TEST_CASE("rational solids: equal roots have the terms t e^-t that their formula has, proven") {
  // theta1 = (p + 2)^2/(2 (p + 1)^2): e^-t (1 + t/2)
  const auto solid =
      exact_operators(exacts({"4", "4", "1"}), exacts({"1", "2", "1"}), exacts({"1"}), exacts({"10"}));
  for (const std::string t : {"1e-30", "0.7", "30", "1000"}) {
    const Float60 time(t);
    check_holds(fading_part(solid.theta1, exact(t), digits), exp(-time) * (1 + time / 2));
    // 1/(2 theta1) = (p + 1)^2/(p + 2)^2, over p: 1/4 and e^-2t (3/4 - t/2)
    check_holds(relaxation(solid.shear, exact(t), digits), (1 + exp(-2 * time) * (3 - 2 * time)) / 4);
  }
}

TEST_CASE("rational solids: a complex pair turns while it fades, proven") {
  // theta1 = (p^2 + 4 p + 5)/(2 (p^2 + 2 p + 2)): e^-t (cos t + sin t/2)
  const auto solid =
      exact_operators(exacts({"5", "4", "1"}), exacts({"2", "2", "1"}), exacts({"1"}), exacts({"10"}));
  for (const std::string t : {"0.001", "2", "100"}) {
    const Float60 time(t);
    check_holds(fading_part(solid.theta1, exact(t), digits), exp(-time) * (cos(time) + sin(time) / 2));
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

TEST_CASE("rational solids: springs and dashpots by operators, with what both have cancelled") {
  using nipref::data::SpringModel;
  const ExactModulus shear{SpringModel::standard_linear, exact("2"), exact("3"), exact("5")},
      bulk{SpringModel::standard_linear, exact("7"), exact("4"), exact("0.6")};
  // Each times p + 1, which nobody sees.
  const auto solid = exact_operators(exacts({"5", "10", "5"}), exacts({"6", "16", "10"}),
                                     exacts({"11", "11.6", "0.6"}), exacts({"28", "32.2", "4.2"}));
  for (const std::string t : {"0", "1e-12", "0.4", "77"}) {
    const auto same = [&](const Enclosure& x, const Enclosure& y) {
      CHECK(abs(number(x) - number(y)) <= Float60(x.error_text()) + Float60(y.error_text()));
    };
    same(fading_part(solid.theta1, exact(t), digits), theta1(shear, exact(t), digits));
    same(fading_part(solid.theta2, exact(t), digits), theta2(shear, bulk, exact(t), digits));
    same(relaxation(solid.shear, exact(t), digits), relaxation(shear, exact(t), digits));
    same(creep(solid.dilatation, exact(t), digits), creep(bulk, exact(t), digits));
    same(loss(solid.dilatation, exact(t), digits), loss(bulk, exact(t), digits));
  }
}

TEST_CASE("rational solids: the thesis's misprint, and an elastic one in disguise, which is exactly that") {
  const auto misprint = exact_single_time(exact("1"), exact("0.375"), exact("0.5"), 2);
  // 4/(9 tau) e^(-2 t/tau) where it should be e^(-t/tau)
  check_holds(fading_part(misprint.theta2, exact("0.25"), digits), Float60(8) / 9 * exp(Float60(-1)));
  check_holds(fading_part(misprint.theta1, exact("0.25"), digits), Float60(8) / 3 * exp(Float60("-0.5")));
  const auto disguised =
      exact_operators(exacts({"0.1", "0.3"}), exacts({"0.1", "0.3"}), exacts({"1", "3"}), exacts({"2", "6"}));
  CHECK(mpfr_zero_p(raw(fading_part(disguised.theta2, exact("2"), digits).value)) != 0);
  CHECK(mpfr_zero_p(raw(loss(disguised.shear, exact("2"), digits).value)) != 0);
  CHECK(number(relaxation(disguised.dilatation, exact("2"), digits)) == 2);
}

TEST_CASE("rational solids: creep that grows is a number up to 1000 digits, then refused as what it is") {
  // theta1 = 1 and theta2 = 6/(p + 1) make 6K = (p - 1)/2 and the creep 12 (e^t - 1).
  const auto unstable =
      exact_prony({exact("1"), exacts({"0"}), exacts({"1"})}, {exact("0"), exacts({"6"}), exacts({"1"})});
  check_holds(creep(unstable.dilatation, exact("3"), digits), 12 * (exp(Float60(3)) - 1));
  CHECK(mpfr_get_exp(raw(creep(unstable.dilatation, exact("2299"), digits).value)) ==
        3321);  // 2299/ln 2 + log2 12
  CHECK_THROWS_WITH_AS(creep(unstable.dilatation, exact("2301"), digits),
                       doctest::Contains("t = 2301: must be at most 2.3e+03: the material is unstable"),
                       BadInput);
}

TEST_CASE("rational solids: bad constants are refused by name") {
  const ExactSeries good{exact("1"), exacts({"1"}), exacts({"1"})};
  const auto prony_with = [&](const std::string& instantaneous, const std::string& rate) {
    return exact_prony({exact(instantaneous), exacts({"1"}), exacts({rate})}, good);
  };
  CHECK_THROWS_WITH_AS(prony_with("-1", "1"), doctest::Contains("theta1_instantaneous = -1"), BadInput);
  CHECK_THROWS_WITH_AS(prony_with("1", "-2"), doctest::Contains("theta1_rate = -2"), BadInput);
  CHECK_THROWS_WITH_AS(exact_operators(exacts({"1", "1"}), exacts({"1"}), exacts({"1"}), exacts({"1"})),
                       doctest::Contains("Q = of degree 0: must be of the degree of P, 1, or of one more"),
                       BadInput);
  CHECK_THROWS_WITH_AS(exact_single_time(exact("1"), exact("1"), exact("0"), 2), doctest::Contains("tau = 0"),
                       BadInput);
  CHECK_THROWS_WITH_AS(creep(prony_with("1", "1").shear, exact("-1"), digits), doctest::Contains("t = -1"),
                       BadInput);
  CHECK_THROWS_WITH_AS(fading_part(prony_with("1", "1").theta1, exact("1e9"), digits),
                       doctest::Contains("t = 1000000000"), BadInput);
}
