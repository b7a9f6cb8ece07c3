#include <cmath>
#include <numbers>

#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {

Float chebyshev_sum(std::span<const Float> coefficients, const Float& x) {
  Float now, last, next;
  Float twofold = 2 * x;
  for (std::size_t n = coefficients.size(); n-- > 0;) {
    const Float& factor = n == 0 ? x : twofold;
    mpfr_mul(raw(next), raw(factor), raw(now), MPFR_RNDN);
    mpfr_sub(raw(next), raw(next), raw(last), MPFR_RNDN);
    mpfr_add(raw(next), raw(next), raw(coefficients[n]), MPFR_RNDN);
    mpfr_swap(raw(last), raw(now));
    mpfr_swap(raw(now), raw(next));
  }
  return now;
}

void chebyshev_values(const Float& x, std::vector<Float>& values) {
  const Float twofold = 2 * x;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k < 2) {
      values[k] = k == 0 ? Float(1) : x;
      continue;
    }
    mpfr_mul(raw(values[k]), raw(twofold), raw(values[k - 1]), MPFR_RNDN);
    mpfr_sub(raw(values[k]), raw(values[k]), raw(values[k - 2]), MPFR_RNDN);
  }
}

std::vector<Float> chebyshev_points(int count) {
  std::vector<Float> points;
  for (int i = 0; i < count; ++i) {
    const Float half = sin((2 * i + 1) * pi() / (4 * count));
    points.push_back(half * half);
  }
  return points;
}

UnitRule gauss_rule(int points) {
  constexpr int newton_steps = 7;  // The first error is about 1e-3; each step squares it.
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
