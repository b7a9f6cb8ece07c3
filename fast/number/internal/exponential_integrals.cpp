#include <array>
#include <boost/math/special_functions/expint.hpp>
#include <cmath>
#include <numbers>

#include <nipref/fast/number/internal/exponential_integrals.hpp>

namespace nipref::fast::internal {
namespace {

using Double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

/// From this argument on the terms of the divergent series sum k!/(+-x)^k fall to e^-x < 2^-53 before they grow.
constexpr double asymptotic_from = 50;

/// The asymptotic series of x e^x E1(x) with step = 1/x, or of x e^-x Ei(x) with step = -1/x.
template <class Number>
Number asymptotic(Number step) {
  Number sum = 1;
  for (int k = 22; k >= 1; --k) sum = 1.0 - static_cast<double>(k) * step * sum;
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

/// sum (-x)^k/((k + 1) (k + 1)!), |x| <= 1, with separate sums of even and odd powers.
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

constexpr double pi = std::numbers::pi;

/// gamma + ln z + sum z^k/(k k!) for a given branch of the logarithm.
std::complex<double> ein_and_log(std::complex<double> z, std::complex<double> log) {
  std::complex<double> sum = std::numbers::egamma + log, power = 1;
  const double size = std::abs(z);
  for (int k = 1; k < 30 + 2.2 * size; ++k) {
    power *= z / static_cast<double>(k);
    sum += power / static_cast<double>(k);
  }
  return sum;
}

}  // namespace

double phi1(double x) { return std::fabs(x) < 1e-17 ? 1 : -std::expm1(-x) / x; }

std::complex<double> phi1(std::complex<double> z) {
  if (std::abs(z) < 0.5) {
    std::complex<double> sum = 0;
    for (int k = 12; k >= 0; --k) sum = 1.0 - z * sum / (k + 2.0);
    return sum;
  }
  const double faded = std::exp(-z.real());
  if (faded == 0) return 1.0 / z;
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

/// Uses the asymptotic series, the power series or the continued fraction 1/(z + 1 - 1/(z + 3 - 4/(z + 5 - ...))),
/// evaluated from its end. The error of the fraction falls like e^(-4 Re sqrt(80 z)), also in the left half plane where
/// |z| + Re z > 3, for which scaled_Ei needs it.
std::complex<double> scaled_E1(std::complex<double> z) {
  if (std::abs(z) >= asymptotic_from && z.real() >= 0) return asymptotic(1.0 / z) / z;
  if (std::abs(z) < 2.5) return std::exp(z) * -ein_and_log(-z, std::log(z));
  std::complex<double> rest = 0;
  for (int k = 80; k > 0; --k) rest = static_cast<double>(k) * k * inverse(z + (2.0 * k + 1) - rest);
  return inverse(z + 1.0 - rest);
}

/// Ei(z) = i pi sign(Im z) - E1(-z). Where -z is next to the cut of E1, the power series is used; its terms do not cancel.
std::complex<double> scaled_Ei(std::complex<double> z) {
  const double size = std::abs(z);
  const std::complex<double> beyond_cut =
      z.imag() == 0 ? 0 : std::complex<double>(0, std::copysign(pi, z.imag())) * std::exp(-z);
  if (size >= asymptotic_from) return asymptotic(-1.0 / z) / z + beyond_cut;
  if (size < 2.5 || size - z.real() < 3) return std::exp(-z) * ein_and_log(z, std::log(z));
  return beyond_cut - scaled_E1(-z);
}

}  // namespace nipref::fast::internal
