#pragma once
#include <vector>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// Enclosures of cos(k pi/(2n)) for whole k, n > 0.
class Cosines {
 public:
  Cosines(long n, mpfr_prec_t precision);

  [[nodiscard]] const Interval& operator()(long k) const {
    const long period = static_cast<long>(values_.size());
    const long rest = k % period;
    return values_[static_cast<std::size_t>(rest < 0 ? rest + period : rest)];
  }

 private:
  std::vector<Interval> values_;
};

}  // namespace nipref::ref
