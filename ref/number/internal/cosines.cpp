#include <nipref/ref/number/internal/cosines.hpp>

namespace nipref::ref {

Cosines::Cosines(long n, mpfr_prec_t precision) {
  values_.reserve(static_cast<std::size_t>(4 * n));
  const Interval pi = Interval::pi(precision);
  for (long k = 0; k < 4 * n; ++k) {
    // The first quarter of the period gives the others.
    if (k < n)
      values_.push_back(cos(k * pi / (2 * n)));
    else if (k == n)
      values_.emplace_back(0L, precision);
    else
      values_.push_back(k <= 2 * n ? -(*this)(2 * n - k) : (*this)(4 * n - k));
  }
}

}  // namespace nipref::ref
