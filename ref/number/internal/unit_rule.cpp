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
    rule.weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

UnitPoint::UnitPoint(const Float& t) {
  const Float growth = exp(pi() * sinh(t));
  from_right = 1 / (1 + growth);
  from_left = growth * from_right;
  slope = pi() * cosh(t) * from_left * from_right;
}

}  // namespace nipref::ref
