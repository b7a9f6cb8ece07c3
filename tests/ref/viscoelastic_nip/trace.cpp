// Functions of the position along a sheet, and their integrals with fading memories, against closed forms.
#include <nipref/ref/viscoelastic_nip/internal/trace.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

namespace {

using Root = TracePanel::Root;

constexpr double nats = 60;
constexpr double enough = 1e-24;

bool is_near(const ComplexFloat& x, const ComplexFloat& y) { return abs(x - y) <= enough * (1 + abs(y)); }

}  // namespace

TEST_CASE("ref: memories of all rates make of an exponential what the closed form says") {
  const WorkingDigits working(30);
  const auto falling = [](const Float& x) -> Float { return exp(-x); };
  const Trace trace({{0, 1, Root::none, 30}, {1, 3, Root::none, 40}}, falling, nats);
  CHECK(trace.end() == 4);
  const ComplexFloat one(1);
  for (const ComplexFloat& rate :
       {ComplexFloat(2), ComplexFloat(Float(1) / 1000), ComplexFloat(4000), ComplexFloat(3, 20)}) {
    for (const Float& x : {Float(1) / 7, Float(1), Float(5) / 2, Float(4)}) {
      CAPTURE(rate.re, x);
      const Float left = exp(-x);
      const ComplexFloat faded = (exp(-(rate * x)) - ComplexFloat(left)) / (one - rate);
      CHECK(is_near(trace.faded(rate, x), faded));
      CHECK(is_near(trace.faded_integral(rate, x), (ComplexFloat(1 - left) - faded) / rate));
    }
    // Behind its panels the function is 0.
    const ComplexFloat at_end = (exp(-(rate * Float(4))) - ComplexFloat(exp(Float(-4)))) / (one - rate);
    CHECK(is_near(trace.faded(rate, 5), at_end * exp(-rate)));
  }
  const Float x = 3;
  CHECK(is_near(trace.faded({}, x), ComplexFloat(1 - exp(-x))));
  CHECK(is_near(trace.faded_integral({}, x), ComplexFloat(x - 1 + exp(-x))));
  CHECK(is_near(trace.faded(one, -1), {}));
}

TEST_CASE("ref: a trace with square roots at its ends is integrated as they are") {
  const WorkingDigits working(30);
  const auto root = [](const Float& x) -> Float { return sqrt(x < 1 ? x : Float(2 - x)); };
  const Trace trace({{0, 1, Root::left, 4}, {1, 1, Root::right, 4}}, root, nats);
  const auto power = [](const Float& x) -> Float { return 2 * x * sqrt(x) / 3; };
  for (const Float& x : {Float(1) / 9, Float(1) / 2, Float(1)})
    CHECK(is_near(trace.faded({}, x), ComplexFloat(power(x))));
  for (const Float& x : {Float(3) / 2, Float(2)})
    CHECK(is_near(trace.faded({}, x), ComplexFloat(2 * power(1) - power(2 - x))));
  // int_0^1 e^(-r (1 - t)) sqrt t dt: as r grows, e^(-r w) weighs the Taylor series of the root at 1.
  const ComplexFloat rate(1e9);
  const Float weight = 1 / rate.re;
  CHECK(abs(trace.faded(rate, 1).re - weight * (1 - weight / 2)) <= weight * weight * weight);
}

TEST_CASE("ref: the faded integral of a power is that of the closed form") {
  const WorkingDigits working(30);
  CHECK(is_near(faded_power({}, 3, 0), ComplexFloat(3)));
  CHECK(is_near(faded_power({}, 3, 2), ComplexFloat(Float(9) / 2)));
  CHECK(is_near(faded_power(ComplexFloat(2), 3, 0), ComplexFloat((1 - exp(Float(-6))) / 2)));
  // int_0^3 e^(-2 (3 - t)) t dt = (2 * 3 - 1 + e^-6)/4
  CHECK(is_near(faded_power(ComplexFloat(2), 3, 1), ComplexFloat((5 + exp(Float(-6))) / 4)));
  const ComplexFloat slow(1e-12, 2e-12);
  CHECK(is_near(faded_power(slow, 1, 0), ComplexFloat(1) - slow / Float(2) + slow * slow / Float(6)));
}
