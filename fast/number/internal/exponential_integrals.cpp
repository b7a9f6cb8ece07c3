#include <array>
#include <boost/math/special_functions/expint.hpp>
#include <cmath>
#include <numbers>

#include <nipref/fast/number/internal/exponential_integrals.hpp>

namespace nipref::fast::internal {
namespace {

using Double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

/// From here on the divergent series sum k!/(+-x)^k reaches e^-x < 2^-53 before it diverges.
constexpr double asymptotic_from = 50;

/// x e^x E1(x) for x = 1/step > 0, x e^-x Ei(x) for step < 0.
double asymptotic(double step) {
  double sum = 1;
  for (int k = 22; k >= 1; --k) sum = 1 - k * step * sum;
  return sum;
}

constexpr int ein_terms = 18;

/// 1/((k + 1) (k + 1)!).
constexpr std::array<double, ein_terms> ein_coefficients() {
  std::array<double, ein_terms> coefficients{};
  double factorial = 1;
  for (int k = 0; k < ein_terms; ++k) {
    factorial *= k + 1;
    coefficients[static_cast<std::size_t>(k)] = 1 / ((k + 1) * factorial);
  }
  return coefficients;
}

/// sum (-x)^k/((k + 1) (k + 1)!), |x| <= 1: even and odd powers side by side.
double ein_series(double x) {
  static constexpr auto c = ein_coefficients();
  const double square = x * x;
  double even = 0, odd = 0;
  for (std::size_t k = ein_terms; k > 0; k -= 2) {
    odd = odd * square + c[k - 1];
    even = even * square + c[k - 2];
  }
  return even - x * odd;
}

}  // namespace

double phi1(double x) { return x < 1e-17 ? 1 : -std::expm1(-x) / x; }

std::complex<double> phi1(std::complex<double> z) {
  if (std::abs(z) < 0.5) {
    std::complex<double> sum = 0;
    for (int k = 12; k >= 0; --k) sum = 1.0 - z * sum / (k + 2.0);
    return sum;
  }
  const double faded = std::exp(-z.real());
  const double half = std::sin(z.imag() / 2);
  return std::complex<double>(-std::expm1(-z.real()) + 2 * faded * half * half, faded * std::sin(z.imag())) /
         z;
}

double ein_ratio(double x) {
  if (x <= 1) return ein_series(x);
  const double far = x < 700 ? boost::math::expint(1, x, Double()) : 0;
  return (far + (std::log(x) + std::numbers::egamma)) / x;
}

double faded_ein_ratio(double x) {
  if (x <= 1) return std::exp(-x) * ein_series(-x);
  if (x >= asymptotic_from) return asymptotic(-1 / x) / x / x;
  return std::exp(-x) * (boost::math::expint(x, Double()) - (std::log(x) + std::numbers::egamma)) / x;
}

double scaled_E1(double x) {
  if (x >= asymptotic_from) return asymptotic(1 / x) / x;
  return std::exp(x) * boost::math::expint(1, x, Double());
}

}  // namespace nipref::fast::internal
