// Numbers of claims, limits and errata: each has an error that covers, and no more digits than the error justifies.
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <nipref/verify/formulas/propagated.hpp>
#include <nipref/verify/seeds/internal/solved.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::Propagated;
using Wide = boost::multiprecision::cpp_bin_float_50;

namespace {

void check_covers(const Propagated& number, const Wide& truth) {
  CAPTURE(verify::stated_text(number), truth.str());
  CHECK(boost::multiprecision::abs(Wide(number.value()) - truth) <= number.error());
}

}  // namespace

TEST_CASE("arithmetic carries errors on: all that the operands may be is in the result's") {
  const std::vector<Propagated> numbers{{0.3, 1e-9},   0.7,         {2.5, 1e-3},
                                        {0.015625, 0}, {0.9, 0.05}, {1e-6, 1e-9}};
  struct Unary {
    Propagated (*mine)(const Propagated&);
    std::function<Wide(const Wide&)> truth;
  };
  const std::vector<Unary> functions{{verify::sqrt, [](const Wide& x) { return Wide(sqrt(x)); }},
                                     {verify::exp, [](const Wide& x) { return Wide(exp(x)); }},
                                     {verify::expm1, [](const Wide& x) { return Wide(exp(x) - 1); }},
                                     {verify::log, [](const Wide& x) { return Wide(log(x)); }},
                                     {verify::sinh, [](const Wide& x) { return Wide(sinh(x)); }},
                                     {verify::cosh, [](const Wide& x) { return Wide(cosh(x)); }},
                                     {verify::tanh, [](const Wide& x) { return Wide(tanh(x)); }},
                                     {verify::sin, [](const Wide& x) { return Wide(sin(x)); }},
                                     {verify::cos, [](const Wide& x) { return Wide(cos(x)); }},
                                     {verify::tan, [](const Wide& x) { return Wide(tan(x)); }},
                                     {verify::atan, [](const Wide& x) { return Wide(atan(x)); }}};
  const auto ends = [](const Propagated& x) {
    return std::vector<Wide>{Wide(x.value()) - x.error(), Wide(x.value()), Wide(x.value()) + x.error()};
  };
  for (const Propagated& a : numbers) {
    for (const Wide& x : ends(a)) {
      for (const auto& [mine, truth] : functions) check_covers(mine(a), truth(x));
      if (a.value() + a.error() < 1) check_covers(verify::atanh(a), boost::multiprecision::atanh(x));
      for (const Propagated& b : numbers) {
        for (const Wide& y : ends(b)) {
          check_covers(a + b, x + y);
          check_covers(a - b, x - y);
          check_covers(a * b, x * y);
          check_covers(a / b, x / y);
          check_covers(verify::hypot(a, b), sqrt(x * x + y * y));
          check_covers(verify::pow(a, b), pow(x, y));
        }
      }
    }
  }
  // The double of 0.1 is up to half a unit off, that of 0.375 is exact. If a divisor may be 0, the error is infinite.
  CHECK(Propagated(0.1).error() > 0);
  CHECK(Propagated(0.375).error() == 0);
  CHECK(std::isinf((1 / Propagated(0.5, 0.5)).error()));
}

TEST_CASE("what is said of a number ends with its error's first digit, the error holds what is left out") {
  CHECK(verify::stated_text({2.4929584293488993, 2.5e-7}) == "2.4929584 +- 2.8e-07");
  CHECK(verify::stated_text({1234567.0, 765.0}) == "1.2346e+06 +- 8.0e+02");
  CHECK(verify::stated_text({3e-5, 1e-3}) == "0 +- 1.1e-03");
  CHECK(verify::stated_text(Propagated::exact(0.1803)) == "0.1803");
  CHECK(verify::stated({1.0, INFINITY}).error == "infinite");
}

TEST_CASE("slopes, zeros, maxima and integrals lie within their errors") {
  struct Case {
    const char* formula;
    Wide truth;
    double most;  ///< largest error allowed
  };
  for (const auto& [formula, truth, most] :
       {Case{"derivative(x, 1, 0.25, sin(x) + within(1e-13))", cos(Wide(1)), 1e-10},
        {"sign_change(x, 1, 2, x*x - 2 + within(1e-11))", sqrt(Wide(2)), 1e-10},
        {"place_of_largest(x, 1, 3, sin(x) + within(1e-14))", Wide(std::numbers::pi) / 2, 1e-5},
        {"largest(x, 1, 3, sin(x) + within(1e-14))", 1, 1},
        {"integral(x, 0, 1, 1/sqrt(x))", 2, 1},
        {"smooth_integral(x, 0, 1, exp(x))", exp(Wide(1)) - 1, 1},
        {"hilbert(t, 0.25, -1, 1, sqrt((1 - t)*(1 + t)))", -0.25, 1}}) {
    CAPTURE(formula);
    const Propagated found = verify::Formulas().value(formula);
    check_covers(found, truth);
    CHECK(found.error() < most);
  }
}
