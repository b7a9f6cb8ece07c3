#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {
namespace {

constexpr long half_panels_per_unit = 8;
constexpr double ratio = 28;  ///< ratio of one coefficient's bound to the next one's
constexpr long watched = 3;   ///< the last coefficients of a panel, which are compared with their bound

/// The middle of a panel, in half panels.
long middle_of_panel(long index) { return 2 * index + 1; }

/// A bound of the n-th Chebyshev coefficient of the interpolation: twice 2 M/28^n, because the aliased coefficients,
/// which are far smaller, are included.
Interval coefficient_bound(double variation, long n, mpfr_prec_t precision) {
  Interval result(4 * variation, precision);
  for (long k = 0; k < n; ++k) result = result / static_cast<long>(ratio);
  return result;
}

/// Chebyshev coefficients of the derivative: T_n' = 2n (T_{n-1} + T_{n-3} + ...), with T_0 halved.
std::vector<Float> slope_of(const std::vector<Float>& coefficients) {
  std::vector<Float> slope(coefficients.size() + 1);
  for (std::size_t n = coefficients.size(); n-- > 1;)
    slope[n - 1] = slope[n + 1] + 2 * static_cast<long>(n) * coefficients[n];
  slope[0] /= 2;
  return slope;
}

}  // namespace

SmoothKernel::SmoothKernel(NormalKernel kernel, int digits, KernelShape shape)
    : kernel_(std::move(kernel)),
      shape_(shape),
      nats_(digits * std::numbers::ln10),
      points_(2 + std::lround(
                      std::ceil((nats_ + std::log(4 * shape.variation / (ratio - 1))) / std::log(ratio)))) {}

/// The values at the nodes of a panel, beginning at its upper end.
std::vector<Interval> SmoothKernel::node_values(long index, const Cosines& cosines) const {
  std::vector<Interval> values;
  for (long k = 0; k < points_; ++k) {
    const Interval node = (cosines(2 * k + 1) + middle_of_panel(index)) / half_panels_per_unit;
    const Float near = middle_of(node);
    Interval value = kernel_(to_exact(near), nats_);
    if (shape_.logarithmic) value = value + log(interval_of(near));
    values.push_back(value.widened(2 * distance_from(near, node)));
  }
  return values;
}

SmoothKernel::Panel SmoothKernel::make_panel(long index) {
  const mpfr_prec_t precision = working_bits();
  const Cosines cosines(points_, precision);
  const std::vector<Interval> values = node_values(index, cosines);
  Coefficients coefficients;
  // The errors of the interpolation and of the coefficients, and 17 N (n + 1) |c_n| units for each coefficient: 16 for
  // the rounding of Clenshaw's sum and 1 for that of its argument, which is at most a unit and counts n^2 |c_n|.
  Interval error = coefficient_bound(shape_.variation, points_ - 1, precision) / static_cast<long>(ratio - 1);
  const Interval unit = interval_of(std::numeric_limits<Float>::epsilon());
  for (long n = 0; n < points_; ++n) {
    Interval coefficient(precision);
    for (long k = 0; k < points_; ++k) {
      coefficient = coefficient + values[static_cast<std::size_t>(k)] * cosines(n * (2 * k + 1));
    }
    coefficient = (n == 0 ? 1 : 2) * coefficient / points_;
    if (n >= points_ - watched &&
        sign_of(abs(coefficient) - coefficient_bound(shape_.variation, n, precision)) > 0) {
      throw std::logic_error("kernel values that no analytic function has");
    }
    const Float near = middle_of(coefficient);
    error = error + distance_from(near, coefficient) +
            (17 * points_ * (n + 1)) * (magnitude_of(coefficient) * unit);
    coefficients.push_back(near);
  }
  const Float bound = upper_end(error);
  if (bound > error_) error_ = bound;
  Coefficients slope = slope_of(coefficients);
  return {std::move(coefficients), std::move(slope)};
}

template <class Evaluate>
Float SmoothKernel::in_panel(const Float& alpha, const Evaluate& evaluate) {
  // The product is exact. The distance from the middle is exact except next to alpha = 0.
  Float place = zero_of_bits(std::max(bits_of(alpha), working_bits()));
  mpfr_mul_si(raw(place), raw(alpha), half_panels_per_unit, MPFR_RNDN);
  mpfr_abs(raw(place), raw(place), MPFR_RNDN);
  const long index = mpfr_get_si(raw(place), MPFR_RNDD) / 2;
  auto panel = panels_.find(index);
  if (panel == panels_.end()) panel = panels_.emplace(index, make_panel(index)).first;
  mpfr_sub_si(raw(place), raw(place), middle_of_panel(index), MPFR_RNDN);
  return evaluate(panel->second, place);
}

Float SmoothKernel::operator()(const Float& alpha) {
  return in_panel(alpha, [](const Panel& panel, const Float& x) { return chebyshev_sum(panel.value, x); });
}

Float SmoothKernel::slope(const Float& alpha) {
  return half_panels_per_unit *
         in_panel(alpha, [](const Panel& panel, const Float& x) { return chebyshev_sum(panel.slope, x); });
}

Interval SmoothKernel::over(const Interval& alpha) {
  const Float near = middle_of(alpha);
  const Interval value = interval_of((*this)(near));
  return value.widened(interval_of(error_) + 2 * distance_from(near, alpha));
}

}  // namespace nipref::ref
