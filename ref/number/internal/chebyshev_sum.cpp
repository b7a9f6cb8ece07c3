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

}  // namespace nipref::ref
