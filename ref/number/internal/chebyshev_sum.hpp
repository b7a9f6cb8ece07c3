#pragma once
#include <span>
#include <vector>

#include <nipref/ref/number/float.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// sum_n c_n T_n(x), |x| <= 1, by Clenshaw's recurrence b_n = c_n + 2 x b_{n+1} - b_{n+2}. The rounding error of b_n is
/// at most 4 units in the last place of |c_n| + 2 |b_{n+1}| + |b_{n+2}|. It changes the sum as an equal change of c_n
/// would. |b_n| is at most the sum of (k + 1) |c_k| over all k.
Float chebyshev_sum(std::span<const Float> coefficients, const Float& x);

/// T_0 .. T_{values.size() - 1} at x.
void chebyshev_values(const Float& x, std::vector<Float>& values);

/// The Chebyshev points of [0, 1] in ascending order: sin^2((2i + 1) pi/(4 count)), i = 0 .. count - 1.
std::vector<Float> chebyshev_points(int count);

/// Enclosures of cos(k pi/(2n)) for integers k and n > 0.
class Cosines {
 public:
  Cosines(long n, mpfr_prec_t precision) {
    const Interval pi = Interval::pi(precision);
    for (long k = 0; k < 4 * n; ++k) {
      // The other three quarters of the period follow from the first by symmetry.
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

/// The nodes and weights of a quadrature rule on (0, 1), to the working precision.
struct UnitRule {
  std::vector<Float> from_left;  ///< distance of a node from 0
  std::vector<Float> weight;

  [[nodiscard]] std::size_t size() const { return weight.size(); }
};

/// The Gauss-Legendre rule, which is exact for polynomials up to degree 2 points - 1.
UnitRule gauss_rule(int points);

/// A node x = 1/(1 + e^{-pi sinh t}) of the double exponential rule on (0, 1), which is the trapezoidal rule in t: x
/// and 1 - x, both with a small relative error however close x is to 0 or 1, and dx/dt. (Takahasi and Mori 1974)
struct UnitPoint {
  Float from_left, from_right, slope;

  explicit UnitPoint(const Float& t);
};

}  // namespace nipref::ref
