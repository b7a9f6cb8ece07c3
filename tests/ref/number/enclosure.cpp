#include <type_traits>

#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/roots.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

using namespace nipref::ref;
using nipref::data::BadInput;
using nipref::test::exact;

namespace {

using Float160 = nipref::test::Decimal<160>;

Float160 value(const Enclosure& e) { return Float160(e.value_text()); }
Float160 bound(const Enclosure& e) { return Float160(e.error_text()); }

using Kernel = Enclosure (*)(const Exact&, int);
const std::vector<Kernel> sheet_kernels{I1, I2, I3, I4, I5, I7};
const std::vector<std::string> arguments{
    "1e-300", "0x0.0000000000001p-1022", "1e-12", "-0.1", "0.73", "1.3015", "2.25", "7", "-31", "250"};

/// The promise: the bound is at most 10^-digits min(1, |truth|), and it holds against a far better value.
void check_promise(const Enclosure& coarse, const Enclosure& fine) {
  const Float160 truth = value(fine);
  const Float160 size = abs(truth) < 1 ? Float160(abs(truth)) : Float160(1);
  CHECK(bound(coarse) <= size * pow(Float160(10), -coarse.digits) * Float160("1.000001"));
  CHECK(abs(value(coarse) - truth) <= bound(coarse) + bound(fine));
}

}  // namespace

TEST_CASE("bounds hold and are as small as asked, for every kernel and argument") {
  for (const std::string& text : arguments) {
    CAPTURE(text);
    const Exact x = exact(text);
    for (const Kernel kernel : sheet_kernels) {
      const Enclosure fine = kernel(x, 60);
      for (const int digits : {16, 25, 50}) check_promise(kernel(x, digits), fine);
    }
    for (const char* eta : {"0", "1e-9", "-0.73", "12"}) {
      check_promise(I6(x, exact(eta), 30), I6(x, exact(eta), 50));
    }
  }
}

TEST_CASE("the bound reaches both ends of the interval, wherever its middle was rounded to") {
  for (const long last : {0L, 1L, 2L, 3L}) {
    Interval interval(1L, 53);
    mpfi_put_d(interval.get(), 1 + std::ldexp(static_cast<double>(last), -52));
    const Enclosure made = enclosure_of(interval, 16);
    const double middle = made.to_double(), error = mpfr_get_d(raw(made.error), MPFR_RNDN);
    CHECK(middle - error <= 1);
    CHECK(middle + error >= 1 + std::ldexp(static_cast<double>(last), -52));
  }
}

TEST_CASE("next to a zero of the kernel the digits are those of the value") {
  // I1 changes its sign within the bracket, which is halved until I1 is small at its ends.
  Float160 left("1");
  Float160 right("2");
  const auto at = [](const Float160& x) { return value(I1(exact(x.str(60)), 20)); };
  REQUIRE(at(left) * at(right) < 0);
  for (int halving = 0; halving < 90; ++halving) {
    const Float160 middle = (left + right) / 2;
    (at(middle) * at(left) > 0 ? left : right) = middle;
  }
  const Enclosure coarse = I1(exact(left.str(60)), 30);
  REQUIRE(abs(value(coarse)) < Float160("1e-25"));
  check_promise(coarse, I1(exact(left.str(60)), 60));
}

TEST_CASE("I6 with alpha = eta is as small as its residues, and still good") {
  for (const char* text : {"0.73", "15", "120"})
    check_promise(I6(exact(text), exact(text), 30), I6(exact(text), exact(text), 70));
}

TEST_CASE("ref's kernels are even or odd, and I6 is so in both arguments") {
  const Exact x = exact("1.37");
  const Exact minus_x = exact("-1.37");
  for (const Kernel even : {I1, I7}) CHECK(even(x, 30).value_text() == even(minus_x, 30).value_text());
  for (const Kernel odd : {I2, I3, I4, I5})
    CHECK("-" + odd(x, 30).value_text() == odd(minus_x, 30).value_text());
  CHECK(I6(x, minus_x, 30).value_text() == I6(minus_x, x, 30).value_text());
}

TEST_CASE("error_of is exact: the error of a correctly rounded double is below half a unit") {
  const Enclosure pi_half = I2(exact("1"), 40);
  const double rounded = pi_half.to_double();
  CHECK(pi_half.error_of(rounded) == doctest::Approx(-6.123233995736766e-17).epsilon(1e-12));
}

TEST_CASE("exact zeros are exact") {
  for (const Kernel odd : {I2, I3, I4, I5}) {
    CHECK(odd(exact("0"), 20).value_text() == "0");
    CHECK(odd(exact("0"), 20).error_text() == "0");
  }
  CHECK(us(exact("0"), exact("1"), exact("0.3"), 20).error_text() == "0");
  CHECK(us(exact("1e-3"), exact("1"), exact("0.5"), 20).to_double() < 0);
}

TEST_CASE("what cannot be told from zero is refused, not looked at for ever") {
  int evaluations = 0;
  const auto around_zero = [&](double) {
    ++evaluations;
    return Interval(0L, 64).widened(Interval(1L, 64));
  };
  CHECK_REFUSED(enclose(20, 0, around_zero), "arguments = (as given): ");
  CHECK(evaluations < 20);
  // Small values are told from zero, for example at an argument of thousands of digits near a zero.
  const auto small = [](double nats) {
    return exp(Interval(-11'000L, 20'000)).widened(exp(Interval(-nats, 64)));
  };
  CHECK(enclose(20, 0, small).digits == 20);
  const auto large = [](double) { return exp(Interval(40'000L, 200)); };
  CHECK_REFUSED(enclose(20, 0, large), "so large that 20 digits");
}

TEST_CASE("a proven bound is an estimate, too, but an estimate no proven bound") {
  static_assert(std::is_convertible_v<Enclosure, Estimate>);
  static_assert(!std::is_constructible_v<Enclosure, Estimate>);
  const Enclosure proven = I1(exact("0.73"), 30);
  const Estimate estimated = proven;
  CHECK(estimated.value_text() == proven.value_text());
  CHECK(estimated.error_text() == proven.error_text());
  CHECK(estimated.to_double() == proven.to_double());
  CHECK(estimated.error_of(1) == proven.error_of(1));
}

TEST_CASE("ref's kernels refuse bad input") {
  CHECK_REFUSED(I1(exact("0"), 20), "alpha = 0: must be nonzero: the kernel is infinite there");
  CHECK_THROWS_AS(I1(exact("1000.001"), 20), BadInput);
  for (const int digits : {15, 1001, -3}) {
    CHECK_THROWS_AS(I1(exact("1"), digits), BadInput);
    CHECK_THROWS_AS(I3(exact("0"), digits), BadInput);
    CHECK_THROWS_AS(I2(exact("0"), digits), BadInput);
    CHECK_THROWS_AS(sheet_root(1, digits), BadInput);
  }
}

TEST_CASE("exact numbers are read exactly or not at all") {
  CHECK((exact("0.73").value() == mpq_class(73, 100)));
  CHECK((exact("-1.5e-3").value() == mpq_class(-3, 2000)));
  CHECK((exact("+.5").value() == mpq_class(1, 2)));
  CHECK((exact("0x1.8p-3").value() == mpq_class(3, 16)));
  CHECK((exact("0X.8").value() == mpq_class(1, 2)));
  for (const char* text : {"", "abc", "nan", "inf", "-", ".", "1e", "1e+", "1.2.3", "1,5", "0x", "0xp1", "1 ",
                           " 1", "1e5001", "1e99999999999", "0x1p", "1p3"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(exact(text), BadInput);
  }
  CHECK_THROWS_AS(Exact(std::nan("")), BadInput);
}

TEST_CASE("a number known exactly has no error, but its text may") {
  const auto known = [](double value) {
    Enclosure result{nipref::ref::zero_of_bits(53), nipref::ref::zero_of_bits(64), 16};
    mpfr_set_d(raw(result.value), value, MPFR_RNDN);
    return result;
  };
  CHECK(known(0.5).error_text() == "0");
  CHECK(known(0).error_text() == "0");
  // 0.1000000000000000055511151231257827...
  CHECK(known(0.1).value_text() == "0.1000000000000000056");
  CHECK(Float160(known(0.1).error_text()) >= Float160("4.8e-20"));
  CHECK(Float160(known(0.1).error_text()) < Float160("1e-18"));
}

TEST_CASE("0 has no last place: beside it stands the error alone") {
  Float zero = zero_of_bits(64), error = zero_of_bits(64);
  mpfr_set_zero(raw(zero), 1);
  mpfr_set_d(raw(error), 0x1p-100, MPFR_RNDN);
  const Estimate nothing(zero, error, 16);
  CHECK(nothing.value_text() == "0");
  CHECK(std::stod(nothing.error_text()) == approx(0x1p-100, 0.1));
}
