#include <array>
#include <cmath>
#include <numbers>

#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// From here on the asymptotic series has double accuracy.
constexpr double asymptotic_from = 40;

/// 1/(2z) sum_k (2k - 1)!!/(2 z^2)^k up to its smallest term.
Complex asymptotic_series(Complex square, Complex z) {
  Complex term = 1, sum = 1;
  for (int k = 1; k < 40; ++k) {
    const Complex next = term * (2.0 * k - 1) / (2.0 * square);
    if (std::abs(next) >= std::abs(term) || std::abs(next) < 1e-17) break;
    term = next;
    sum += term;
  }
  return sum / (2.0 * z);
}

/// By Rybicki's sum of sampled Gaussians (Computers in Physics 3, 1989), whose error is e^(-(pi/2h)^2); x below
/// sqrt(asymptotic_from).
double real_dawson(double x) {
  constexpr double step = 0.25;
  constexpr int pairs = 13;
  static const auto faded = [] {
    std::array<double, pairs> values{};
    for (int i = 0; i < pairs; ++i)
      values[static_cast<std::size_t>(i)] = std::exp(-std::pow((2 * i + 1) * step, 2));
    return values;
  }();
  if (x < 0.2) {
    const double square = x * x;
    double sum = 1, term = 1;
    for (int k = 1; k < 10; ++k) sum += term *= -2 * square / (2 * k + 1);
    return x * sum;
  }
  const double nearest = 2 * std::round(x / (2 * step)), rest = x - nearest * step;
  const double up = std::exp(2 * rest * step), square = up * up;
  double rising = up, falling = 1 / up, sum = 0;
  for (int i = 0; i < pairs; ++i) {
    const double n = 2 * i + 1;
    sum += faded[static_cast<std::size_t>(i)] * (rising / (nearest + n) + falling / (nearest - n));
    rising *= square;
    falling /= square;
  }
  return std::exp(-rest * rest) / std::sqrt(std::numbers::pi) * sum;
}

}  // namespace

Complex dawson_of_square(Complex square) {
  const Complex z = std::sqrt(square);
  if (std::abs(square) < asymptotic_from) {
    if (square.imag() == 0) return real_dawson(z.real());
    static const GaussRule rule = gauss_legendre(48);
    Complex sum = 0;
    for (std::size_t i = 0; i < rule.at.size(); ++i)
      sum += rule.weight[i] * std::exp(-square * (1 - rule.at[i] * rule.at[i]));
    return z * sum;
  }
  Complex result = asymptotic_series(square, z);
  if (square.imag() != 0)
    result += Complex(0, std::copysign(std::sqrt(std::numbers::pi) / 2, square.imag())) * std::exp(-square);
  return result;
}

Complex layer_pressure(Complex rate, double e) {
  return -2 / std::sqrt(std::numbers::pi) * rate * dawson_of_square(rate * e);
}

}  // namespace nipref::fast
