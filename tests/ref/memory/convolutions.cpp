#include <nipref/ref/memory/convolutions.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

// The thesis's closed forms (AII.6, AII.9, AII.13, AII.18), in so many digits that what cancels in them does
// not matter, against the quadrature of the reference path.

using namespace nipref::ref;
using nipref::data::BadInput;
using nipref::test::exact;

namespace {

using Float250 = nipref::test::Decimal<250>;

struct Case {
  std::string lambda, a, b, t, T;
};

/// The four integrals by their closed forms; lambda = a and b = 0 at once are not for them.
struct Closed {
  explicit Closed(const Case& x) : lambda(x.lambda), a(x.a), b(x.b), t(x.t), T(x.T) {}

  Float250 lambda, a, b, t, T;

  [[nodiscard]] Float250 before(bool sine) const {
    if (T <= 0) return 0;
    const Float250 k = lambda + a;
    const Float250 square = k * k + b * b;
    const Float250 origin = wave(k, T, sine) * exp(-lambda * t - a * T);
    if (t > T) return ((sine ? b : k) * exp(-lambda * (t - T)) - origin) / square;
    return (wave(k, T - t, sine) * exp(-a * (T - t)) - origin) / square;
  }

  [[nodiscard]] Float250 after(bool sine) const {
    if (T >= t) return 0;
    const Float250 k = lambda - a;
    const Float250 square = k * k + b * b;
    const Float250 now = wave(k, T - t, sine) * exp(-a * (t - T));
    if (T >= 0) return (now - (sine ? b : k) * exp(-lambda * (t - T))) / square;
    return (now - wave(k, T, sine) * exp(-lambda * t + a * T)) / square;
  }

  [[nodiscard]] Float250 steps(const Float250& gamma0, const Float250& gamma) const {
    const Float250 side = T > t ? 1 : T < t ? -1 : 0;
    const Float250 since = T < 0 ? t : T < t ? t - T : Float250(0);
    const Float250 until = t - since;
    return gamma0 * side +
           gamma / lambda * (exp(-lambda * since) * (1 - exp(-lambda * until)) - (1 - exp(-lambda * since)));
  }

 private:
  [[nodiscard]] Float250 wave(const Float250& k, const Float250& x, bool sine) const {
    return sine ? Float250(k * sin(b * x) + b * cos(b * x)) : Float250(k * cos(b * x) - b * sin(b * x));
  }
};

void check_agrees(const Enclosure& reference, const Float250& closed) {
  const Float250 value(reference.value_text());
  Float250 bound;
  mpfr_set(bound.backend().data(), raw(reference.error), MPFR_RNDU);
  const Float250 faded("1e-200000000");
  CHECK(abs(value - closed) <= bound + abs(closed) * Float250("1e-32"));
  CHECK(bound <= abs(closed) * Float250("1e-30") + faded);
}

void check_case(const Case& x) {
  CAPTURE(x.lambda);
  CAPTURE(x.a);
  CAPTURE(x.b);
  CAPTURE(x.t);
  CAPTURE(x.T);
  const Closed closed(x);
  const auto value = [&](auto J) {
    return J(exact(x.lambda), exact(x.a), exact(x.b), exact(x.t), exact(x.T), 30);
  };
  check_agrees(value(J1), closed.before(true));
  check_agrees(value(J2), closed.before(false));
  check_agrees(value(J3), closed.after(true));
  check_agrees(value(J4), closed.after(false));
  check_agrees(J5(exact("0.75"), exact("-2.5"), exact(x.lambda), exact(x.t), exact(x.T), 30),
               closed.steps(Float250("0.75"), Float250("-2.5")));
  check_agrees(J6(exact("-0.75"), exact("2.5"), exact(x.lambda), exact(x.t), exact(x.T), 30),
               closed.steps(Float250("-0.75"), Float250("2.5")));
}

/// T before, at and after both ends of 0 .. t = 2.
const std::vector<std::string> times{"-40", "-3",  "-1e-6", "0", "1e-9", "0.7", "1.999999999999",
                                     "2",   "2.5", "1e3"};

}  // namespace

TEST_CASE("memory integrals are their closed forms, T of either sign") {
  for (const std::string& T : times) {
    check_case({"0.9", "2.1", "3.3", "2", T});
    check_case({"7", "2.1", "3.3", "2", T});
  }
}

TEST_CASE("memory integrals from the slowest to the fastest of rates") {
  for (const char* T : {"-0.5", "0.3", "2.5"}) {
    for (const char* lambda : {"1e-12", "1e-3", "2.0999999999999", "2.1000000000001", "2.1", "1e4", "1e12"})
      check_case({lambda, "2.1", "5.4", "2", T});
    check_case({"0.4", "1e-12", "1e-12", "2", T});
    check_case({"0.4", "1e12", "1e12", "2", T});
    check_case({"1e-12", "1e-12", "3", "1e-12", T});
  }
}

TEST_CASE("memory integrals of the sheet's thousandth root, fifty half thicknesses away") {
  for (const char* T : {"-50", "0.01", "25", "50", "100"}) check_case({"4.4", "4.3738", "3139.998", "50", T});
}

TEST_CASE("memory integrals at random arguments") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-5, 5);
  const auto draw = [&] { return std::to_string(std::pow(10.0, exponent(random)) + 1e-6); };
  for (int i = 0; i < 100; ++i) {
    const std::string sign = i % 2 == 0 ? "-" : "";
    check_case({draw(), draw(), draw(), draw(), sign + draw()});
  }
}

TEST_CASE("memory integrals are exactly 0 where nothing is integrated") {
  const Exact zero = exact("0"), one = exact("1"), two = exact("2"), before = exact("-1");
  const auto is_zero = [](const Enclosure& x) {
    return x.to_double() == 0 && mpfr_zero_p(raw(x.error)) != 0;
  };
  CHECK(is_zero(J1(one, one, one, one, before, 20)));
  CHECK(is_zero(J2(one, one, one, one, zero, 20)));
  CHECK(is_zero(J3(one, one, one, one, two, 20)));
  CHECK(is_zero(J4(one, one, one, one, one, 20)));
  CHECK(is_zero(J1(one, one, zero, one, two, 20)));
  CHECK(is_zero(J2(one, one, one, zero, two, 20)));
  CHECK(is_zero(J5(zero, one, one, zero, two, 20)));
  CHECK(is_zero(J5(one, zero, one, one, one, 20)));
  // Nothing fades and the load has passed half the time ago.
  CHECK(is_zero(J6(zero, one, zero, two, one, 20)));
}

TEST_CASE("memory integrals without decay are elementary") {
  CHECK(J2(exact("0"), exact("0"), exact("0"), exact("2"), exact("1.5"), 20).to_double() == 1.5);
  CHECK(J4(exact("3"), exact("3"), exact("0"), exact("0.25"), exact("0"), 20).to_double() ==
        doctest::Approx(0.25 * std::exp(-0.75)).epsilon(1e-15));
  CHECK(J5(exact("1"), exact("2"), exact("0"), exact("2"), exact("1.5"), 20).to_double() == 1);
}

TEST_CASE("memory integrals refuse what is outside their domain") {
  const Exact one = exact("1"), negative = exact("-1"), large = exact("1e16");
  CHECK_THROWS_AS(J1(negative, one, one, one, one, 20), BadInput);
  CHECK_THROWS_AS(J2(one, negative, one, one, one, 20), BadInput);
  CHECK_THROWS_AS(J3(one, one, negative, one, one, 20), BadInput);
  CHECK_THROWS_AS(J4(one, one, one, negative, one, 20), BadInput);
  CHECK_THROWS_AS(J1(large, one, one, one, one, 20), BadInput);
  CHECK_THROWS_AS(J5(one, one, negative, one, one, 20), BadInput);
  CHECK_THROWS_AS(J6(one, one, one, negative, one, 20), BadInput);
  CHECK_THROWS_AS(J6(one, one, one, one, one, 15), BadInput);
}
