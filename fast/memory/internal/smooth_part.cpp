#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/memory/internal/smooth_part.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast::internal {
namespace {

constexpr double negligible = 1e-18;  ///< error of kernels that is neglected; their size is 1

/// The coefficient c'_k = c'_(k + 2) + 2 (k + 1) c_(k + 1)/half_width of the derivative, from its later coefficients.
/// Both vectors end with two zeros.
template <typename Coefficient>
Coefficient slope_coefficient(const std::vector<Coefficient>& of, const std::vector<Coefficient>& slope,
                              std::size_t k) {
  return slope[k + 2] + 2 * static_cast<double>(k + 1) / Series<Coefficient>::half_width * of[k + 1];
}

/// The series of a function that is analytic for |Im w| < 2.
Series<double> through_chebyshev_points(double (*value)(double w)) {
  constexpr std::size_t points =
      36;  // 3.48^-36 < 1e-19, for singularities at +-2 i; even, so that none is at 0
  // In double the rounding error of the angles, up to 110, would be that of the series.
  const auto cosine = [](std::size_t of) {
    return static_cast<double>(std::cos(std::numbers::pi_v<long double> * of / (2 * points)));
  };
  std::vector<double> result(points);
  for (std::size_t j = 0; j < points; ++j) {
    const double here = 2.0 / points * value(Series<double>::half_width * cosine(2 * j + 1));
    for (std::size_t k = 0; k < points; ++k) result[k] += here * cosine(k * (2 * j + 1));
  }
  return {result, negligible};
}

double smooth_I1(double w) {
  double at[] = {w};
  regular_I1(at, at);
  return at[0];
}
double smooth_I3(double w) { return I3(w); }

/// The integral of numerator(x)/D over x > 0 by Gauss's rule on panels up to x = 24, where x/D is below 1e-19. The
/// poles of 1/D next to them, 1.125 +- 2.106 i, are on an ellipse about the first panel whose half axes sum to 3.1 half
/// panels, so that the error is 3.1^-40 = 2e-20.
double integral_over_D(const auto& numerator) {
  constexpr double panel = 3, last = 24;
  const auto integrand = [&](double x) { return numerator(x) / (std::sinh(2 * x) + 2 * x); };
  double sum = 0;
  for (double from = 0; from < last; from += panel)
    sum += boost::math::quadrature::gauss<double, 20>::integrate(integrand, from, from + panel);
  return sum;
}

// With D = sinh 2x + 2x, I1'(w) + 1/w is the integral of (2x + 1 - e^-2x) sin(w x)/D over x > 0, and I3'(w) that of
// 2x cos(w x)/D. They are computed as such, because a derivative of the series of I1 or I3 would multiply the rounding
// errors of its coefficients c_k by up to 2 k.
double slope_of_smooth_I1(double w) {
  return integral_over_D([w](double x) { return (2 * x - std::expm1(-2 * x)) * std::sin(w * x); });
}
double slope_of_I3(double w) {
  return integral_over_D([w](double x) { return 2 * x * std::cos(w * x); });
}

template <typename Rate>
Series<Rate> sum_of_derivatives(const Series<double>& f, Rate rate) {
  std::vector<Rate> result(f.terms() + 2), slope(result.size());
  const Rate step = 1.0 / rate;
  for (std::size_t k = f.terms(); k-- > 0;) {
    slope[k] = slope_coefficient(result, slope, k);
    result[k] = (f.coefficient(k) + slope[k]) * step;
  }
  return {result, negligible * std::abs(step)};
}

/// The coefficients of e^(-r (1 - w/1.25)), which are Bessel functions, are below 2^-60 from number (84 r)^(1/2) on.
Series<double> integral_to_end(const Series<double>& f, double rate) {
  constexpr double half_width = Series<double>::half_width;
  const double r = half_width * rate;
  const std::size_t terms = f.terms() + static_cast<std::size_t>(std::ceil(std::sqrt(84 * r)));
  std::vector<double> a(terms + 1), b(terms + 1), result(terms);
  for (std::size_t k = terms; k-- > 1;) {
    const double pivot = 2 * static_cast<double>(k) + r * b[k + 1];
    b[k] = r / pivot;
    a[k] = -(half_width * (f.coefficient(k - 1) - f.coefficient(k + 1)) + r * a[k + 1]) / pivot;
  }
  // at_end is P(1.25) by the recurrence from P_0 = 0; free_at_end is how much P_0 = 1 adds.
  double given = 0, free = 1, at_end = 0, free_at_end = 0.5;
  for (std::size_t k = 1; k < terms; ++k) {
    at_end += given = a[k] + b[k] * given;
    free_at_end += free *= b[k];
  }
  result[0] = -at_end / free_at_end;
  for (std::size_t k = 1; k < terms; ++k) result[k] = a[k] + b[k] * result[k - 1];
  return {result, negligible};
}

Series<double> memory_polynomial(const Series<double>& f, double rate) {
  return rate < polynomial_from ? integral_to_end(f, rate) : sum_of_derivatives(f, rate);
}
Series<Complex> memory_polynomial(const Series<double>& f, Complex rate) {
  return sum_of_derivatives(f, rate);
}

}  // namespace

template <typename Coefficient>
Series<Coefficient>::Series(std::vector<Coefficient> coefficients, double negligible)
    : coefficients_(std::move(coefficients)) {
  for (double tail = 0; coefficients_.size() > 1; coefficients_.pop_back()) {
    tail += std::abs(coefficients_.back());
    if (tail > negligible) break;
  }
}

template <typename Coefficient>
Coefficient Series<Coefficient>::operator()(double w) const {
  const double t = w / half_width;
  Coefficient here = 0, above = 0;
  for (std::size_t k = terms() - 1; k > 0; --k)
    above = std::exchange(here, 2 * t * here - above + coefficients_[k]);
  return t * here - above + 0.5 * coefficients_[0];
}

const Series<double>& smooth_part(Kernel kernel) {
  static const Series<double> of_I1 = through_chebyshev_points(smooth_I1),
                              of_I3 = through_chebyshev_points(smooth_I3);
  return kernel == Kernel::I1 ? of_I1 : of_I3;
}

const Series<double>& slope_of_smooth_part(Kernel kernel) {
  static const Series<double> of_I1 = through_chebyshev_points(slope_of_smooth_I1),
                              of_I3 = through_chebyshev_points(slope_of_I3);
  return kernel == Kernel::I1 ? of_I1 : of_I3;
}

template <typename Rate>
SmoothMemory<Rate>::SmoothMemory(const Series<double>& f, Rate rate)
    : rate_(rate), polynomial_(memory_polynomial(f, rate)), at_nearest_(polynomial_(nearest)) {}

template <typename Rate>
Rate SmoothMemory<Rate>::from(double w) const {
  const Rate kept = faded_exp(rate_ * (nearest - w));
  return kept == 0.0 ? polynomial_(w) : polynomial_(w) - kept * at_nearest_;
}

template class Series<double>;
template class SmoothMemory<double>;
template class SmoothMemory<Complex>;

}  // namespace nipref::fast::internal
