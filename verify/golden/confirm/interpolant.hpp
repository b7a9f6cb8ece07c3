#pragma once
#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {

/// The interpolant of a smooth function on an interval at Chebyshev points. If their number is even, no point is in the
/// middle of the interval.
class Interpolant {
 public:
  Interpolant(const Float& from, const Float& to, int points, const std::function<Float(const Float& x)>& f)
      : middle_((from + to) / 2), half_((to - from) / 2) {
    const auto count = static_cast<std::size_t>(points);
    std::vector<Float> values, cosine;
    for (int m = 0; m < 4 * points; ++m) cosine.push_back(cos(pi() * m / (2 * points)));
    for (std::size_t k = 0; k < count; ++k) values.push_back(f(middle_ + half_ * cosine[2 * k + 1]));
    for (std::size_t n = 0; n < count; ++n) {
      Float sum = 0;
      for (std::size_t k = 0; k < count; ++k) sum += values[k] * cosine[n * (2 * k + 1) % (4 * count)];
      coefficients_.push_back(2 * sum / points);
    }
    coefficients_[0] /= 2;
    slopes_.assign(count, Float(0));
    for (std::size_t n = count - 1; n > 0; --n)
      slopes_[n - 1] = (n + 1 < count ? slopes_[n + 1] : Float(0)) + 2 * n * coefficients_[n] / half_;
    slopes_[0] /= 2;
  }

  Float operator()(const Float& x) const { return sum(coefficients_, x); }
  [[nodiscard]] Float slope(const Float& x) const { return sum(slopes_, x); }

 private:
  /// Sums the Chebyshev series by Clenshaw's recurrence.
  [[nodiscard]] Float sum(const std::vector<Float>& coefficients, const Float& x) const {
    const Float u = (x - middle_) / half_, twice = 2 * u;
    Float last = 0, before = 0;
    for (std::size_t n = coefficients.size() - 1; n > 0; --n) {
      const Float next = coefficients[n] + twice * last - before;
      before = last;
      last = next;
    }
    return coefficients[0] + u * last - before;
  }

  Float middle_, half_;
  std::vector<Float> coefficients_, slopes_;
};

}  // namespace nipref::verify::confirm
