#include <boost/multiprecision/mpfr.hpp>

#include <nipref/fast/memory/convolutions.hpp>

#include "support/test.hpp"

using namespace nipref::fast;

TEST_SUITE_BEGIN("fast memory");

namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300>,
                                           boost::multiprecision::et_off>;

struct Pair {
  Real cosine, sine;
};

/// e^(-exponent + i phase) int_0^length e^(-(rate - i b) s) ds, as it stands: 300 digits bear any
/// cancellation.
Pair closed_form(const Real& exponent, const Real& phase, const Real& rate, const Real& b,
                 const Real& length) {
  const Real size = exp(-exponent);
  const Real square = rate * rate + b * b;
  const Real end = exp(-rate * length);
  const Real rise = 1 - end * cos(b * length), slant = end * sin(b * length);
  const Real re = (rise * rate + slant * b) / square, im = (rise * b - slant * rate) / square;
  return {size * (cos(phase) * re - sin(phase) * im), size * (cos(phase) * im + sin(phase) * re)};
}

Real faded(const Real& rate, const Real& length) { return (1 - exp(-rate * length)) / rate; }

/// Within 4 ulp of a scale, the smaller unit of its binade, or of what underflows.
void check(double value, const Real& exact, const Real& scale) {
  CHECK(abs(value - exact) <= 4 * 0x1p-53 * scale + 0x1p-1073);
}

void check_all(double lambda, double a, double b, double t, double T) {
  CAPTURE(lambda);
  CAPTURE(a);
  CAPTURE(b);
  CAPTURE(t);
  CAPTURE(T);
  const Real l = lambda, A = a, B = b, now = t, pass = T;
  if (T > 0) {
    const Real m = t < T ? now : pass;
    const Real exponent = t < T ? Real(A * (pass - now)) : Real(l * (now - pass));
    const Real phase = t < T ? Real(B * (pass - now)) : Real(0);
    const Pair exact = closed_form(exponent, phase, l + A, B, m);
    const Real scale = exp(-exponent) * faded(l + A, m);
    check(J2(lambda, a, b, t, T), exact.cosine, scale);
    check(J1(lambda, a, b, t, T), exact.sine, B * T < 1 ? Real(abs(exact.sine)) : scale);
  } else {
    CHECK(J1(lambda, a, b, t, T) == 0);
    CHECK(J2(lambda, a, b, t, T) == 0);
  }
  if (T < t) {
    const Real m = T > 0 ? Real(now - pass) : now;
    const Real behind = now - pass;
    const Pair exact = closed_form(A * behind, -B * behind, l - A, B, m);
    const Real scale = exp(-A * behind) * faded(l - A, m);
    check(J4(lambda, a, b, t, T), exact.cosine, scale);
    check(J3(lambda, a, b, t, T), exact.sine, B * behind < 1 ? Real(abs(exact.sine)) : scale);
  } else {
    CHECK(J3(lambda, a, b, t, T) == 0);
    CHECK(J4(lambda, a, b, t, T) == 0);
  }
  const Real passed = T < 0 ? Real(0) : T > t ? now : pass;
  const Real before = exp(-l * (now - passed)) * faded(l, passed), after = faded(l, now - passed);
  const int sign = (T > t) - (T < t);
  check(J5(2, lambda, lambda, t, T), 2 * sign + l * (before - after), 2 + l * (before + after));
}

}  // namespace

TEST_CASE("J1 to J5 are their closed forms, 4 ulp of scale over 24 decades of the rate") {
  std::mt19937_64 generator(5);
  const auto log_uniform = [&](double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(generator));
  };
  for (int i = 0; i < 400; ++i) {
    const double a = log_uniform(0.5, 60), b = log_uniform(1e-3, 50);
    const double lambda = i % 3 == 0 ? log_uniform(1e-12, 1e12) : log_uniform(1e-2, 1e2);
    const double t = log_uniform(1e-6, 30), T = log_uniform(1e-6, 30);
    check_all(lambda, a, b, t, i % 2 == 0 ? T : -T);
  }
}

TEST_CASE("J at the hard places") {
  for (const double T : {-300.0, -2.0, -1e-100, 1e-100, 1e-9, 2.0, 2 - 0x1p-51, 2 + 0x1p-51, 300.0}) {
    check_all(1.5, 2.1, 1.1, 2, T);                    // T -> 0 from both sides, T -> t from both sides
    check_all(2.1, 2.1 * (1 + 0x1p-52), 1.1, 2, T);    // lambda near a
    check_all(1e-12, 1e-12 * (1 + 1e-9), 1e-5, 2, T);  // nothing fades and nothing turns
    check_all(1.5, 2.1, 1.1, 1e-100, T);               // t -> 0
    check_all(2.0, 2.0 * (1 + 0x1p-52), 1e4, 300, T);  // phases of 3e6
  }
}

TEST_CASE("memory is a semigroup: what was there fades, what is new is added") {
  // Over [0, t]: J(t) = e^(-lambda (t - t1)) J(t1) + what the load has done in [t1, t], the same J begun at
  // t1.
  const double lambda = 0.7, a = 2.1, b = 1.1, t = 3;
  for (const double T : {-1.0, 0.5, 2.0, 4.0}) {
    for (const double t1 : {0.25, 1.0, 2.5}) {
      const double faded = std::exp(-lambda * (t - t1));
      for (const auto J : {J1, J2, J3, J4}) {
        CHECK(
            J(lambda, a, b, t, T) ==
            doctest::Approx(faded * J(lambda, a, b, t1, T) + J(lambda, a, b, t - t1, T - t1)).epsilon(1e-14));
      }
      CHECK(
          J6(0, 3, lambda, t, T) ==
          doctest::Approx(faded * J6(0, 3, lambda, t1, T) + J6(0, 3, lambda, t - t1, T - t1)).epsilon(1e-14));
    }
  }
}

TEST_CASE("J5 under the load: no sign there, and nothing remembered before the start") {
  CHECK(J5(7, 0, 1, 2, 2) == 0);
  CHECK(J5(7, 5, 1, 0, 3) == 7);
  CHECK(J5(7, 5, 1, 0, -3) == -7);
  CHECK(J5(0, 5, 0, 2, 1) == 0);  // a rate of 0: as long before as after
  CHECK(J5(0, 5, 0, 2, 3) == 10);
  CHECK(J6(7, 5, 1, 2, 0.5) == J5(7, 5, 1, 2, 0.5));
}

TEST_CASE("bad input to J names its argument") {
  using nipref::data::BadInput;
  const double nan = std::nan(""), infinity = HUGE_VAL;
  CHECK_THROWS_WITH_AS(J1(-1, 1, 1, 1, 1), "lambda = -1: must be from 0 to 1e150", BadInput);
  CHECK_THROWS_AS(J2(1, -1, 1, 1, 1), BadInput);
  CHECK_THROWS_AS(J3(1, 1, nan, 1, 1), BadInput);
  CHECK_THROWS_AS(J4(1, 1, 1, -1e-300, 1), BadInput);
  CHECK_THROWS_AS(J4(1, 1, 1, 1, -infinity), BadInput);
  CHECK_THROWS_AS(J5(nan, 1, 1, 1, 1), BadInput);
  CHECK_THROWS_AS(J6(1, infinity, 1, 1, 1), BadInput);
}

TEST_SUITE_END();
