#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {

Float chebyshev_sum(const std::vector<Float>& coefficients, const Float& x) {
  Float now, last, next;
  Float twofold = 2 * x;
  for (std::size_t n = coefficients.size(); n-- > 0;) {
    const Float& factor = n == 0 ? x : twofold;
    mpfr_mul(next.get(), factor.get(), now.get(), MPFR_RNDN);
    mpfr_sub(next.get(), next.get(), last.get(), MPFR_RNDN);
    mpfr_add(next.get(), next.get(), coefficients[n].get(), MPFR_RNDN);
    mpfr_swap(last.get(), now.get());
    mpfr_swap(now.get(), next.get());
  }
  return now;
}

}  // namespace nipref::ref
