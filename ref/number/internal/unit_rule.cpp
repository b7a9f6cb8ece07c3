#include <cmath>
#include <numbers>

#include <nipref/ref/number/internal/unit_rule.hpp>

namespace nipref::ref {

UnitRule gauss_rule(int points) {
  constexpr int newton_steps = 7;  // from 1e-3 to more than any precision here
  UnitRule rule;
  for (int i = 0; i < points; ++i) {
    Float x = std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));
    Float slope;
    for (int step = 0; step < newton_steps; ++step) {
      Float last = 1, now = x;  // Legendre's polynomials
      for (int n = 1; n < points; ++n) {
        Float next = ((2 * n + 1) * x * now - n * last) / (n + 1);
        last = std::move(now);
        now = std::move(next);
      }
      slope = points * (last - x * now) / (1 - x * x);
      x -= now / slope;
    }
    rule.from_left.push_back((1 - x) / 2);
    rule.from_right.push_back((1 + x) / 2);
    rule.weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

UnitRule double_exponential_rule(double nats, int degree) {
  // On Im t = 1 the polynomials are at most about (3.9 + 4)^degree. The error of the trapezoidal sum is e^{-2 pi/step}
  // times that.
  const double step = 2 * std::numbers::pi / (nats + 2.07 * degree);
  const double last = std::asinh((nats + 8) / std::numbers::pi);
  const int half = static_cast<int>(std::ceil(last / step));
  const Float here = step;
  UnitRule rule;
  for (int i = -half; i <= half; ++i) {
    const Float t = i * here;
    const Float growth = exp(pi() * sinh(t));
    const Float left = growth / (1 + growth), right = 1 / (1 + growth);
    rule.from_left.push_back(left);
    rule.from_right.push_back(right);
    rule.weight.push_back(here * pi() * cosh(t) * left * right);
  }
  return rule;
}

}  // namespace nipref::ref
