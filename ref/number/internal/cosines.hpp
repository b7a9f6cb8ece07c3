#pragma once
#include <vector>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// Enclosures of cos(k pi/(2n)) for whole k, n > 0.
class Cosines {
 public:
  Cosines(long n, mpfr_prec_t precision) {
    const Interval pi = Interval::pi(precision);
    for (long k = 0; k < 4 * n; ++k) {
      // The first quarter of the period gives the others.
      if (k < n)
        values_.push_back(cos(k * pi / (2 * n)));
      else if (k == n)
        values_.emplace_back(0L, precision);
      else
        values_.push_back(k <= 2 * n ? -values_[static_cast<std::size_t>(2 * n - k)]
                                     : values_[static_cast<std::size_t>(4 * n - k)]);
    }
  }

  [[nodiscard]] const Interval& operator()(long k) const {
    const long period = static_cast<long>(values_.size());
    const long rest = k % period;
    return values_[static_cast<std::size_t>(rest < 0 ? rest + period : rest)];
  }

 private:
  std::vector<Interval> values_;
};

}  // namespace nipref::ref
