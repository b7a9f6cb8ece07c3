#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// From here on the asymptotic series has double accuracy.
constexpr double asymptotic_from = 40;

/// 1/(2z) sum_k (2k - 1)!!/(2 z^2)^k up to its smallest term, and what is added to it beside the real axis.
Complex asymptotic_dawson(Complex square, Complex z) {
  const Complex step = 0.5 / square;
  const double step_size = std::abs(step);
  Complex term = 1, sum = 1;
  double size = 1;
  for (double factor = 1; factor * step_size < 1 && size > 1e-17; factor += 2) {
    term *= factor * step;
    size *= factor * step_size;
    sum += term;
  }
  sum /= 2.0 * z;
  if (square.imag() == 0) return sum;
  return sum + Complex(0, std::copysign(std::sqrt(std::numbers::pi) / 2, square.imag())) *
                   internal::faded_exp(square);
}

/// h(s) = D(z)/z of s = z^2 on a ray of s up to asymptotic_from, between even |s|: Taylor polynomials in |s|/2 about 0, and
/// in |s| about the middles of the others. By 2 s h' = 1 - (1 + 2 s) h; its homogeneous solution e^-s/sqrt s decays, and so
/// do errors.
using Table = std::vector<std::vector<Complex>>;

using Extended = std::complex<long double>;
using Terms = std::vector<Extended>;

bool goes_on(const Terms& terms) { return terms.size() < 20 || std::abs(terms.back()) > 1e-22L; }

/// The terms of sum (-2 s)^k/(2k + 1)!!
Terms power_series(Extended s) {
  Terms terms{1};
  while (goes_on(terms))
    terms.push_back(-2.0L * s * terms.back() / (2.0L * static_cast<long double>(terms.size()) + 1));
  return terms;
}

/// Those of the Taylor series about s for h(s + step).
Terms taylor_series(Extended s, Extended value, Extended step) {
  Terms terms{value, (1.0L - (1.0L + 2.0L * s) * value) * step / (2.0L * s)};
  while (goes_on(terms)) {
    const auto k = static_cast<long double>(terms.size() - 1);
    const Extended before = terms[terms.size() - 2];
    terms.push_back(-((1 + 2 * k + 2.0L * s) * terms.back() + 2.0L * step * before) * step /
                    (2.0L * s * (k + 1)));
  }
  return terms;
}

/// In double, without what is less than its rounding.
std::vector<Complex> rounded(Terms terms) {
  while (std::abs(terms.back()) < 1e-18L * std::abs(terms.front())) terms.pop_back();
  return {terms.begin(), terms.end()};
}

Table table_on_ray(const double& angle) {
  const Extended direction = std::polar(1.0L, static_cast<long double>(angle));
  const auto sum = [](const Terms& terms) {
    return std::accumulate(terms.rbegin(), terms.rend(), Extended(0));
  };
  Table table{rounded(power_series(2.0L * direction))};
  Extended value = sum(power_series(3.0L * direction));
  for (int middle = 3; middle < asymptotic_from; middle += 2) {
    const Extended s = static_cast<long double>(middle) * direction;
    table.push_back(rounded(taylor_series(s, value, direction)));
    value = sum(taylor_series(s, value, 2.0L * direction));
  }
  return table;
}

}  // namespace

struct LayerPressure::DawsonOnRay {
  Table table;

  [[nodiscard]] Complex ratio(double size) const {
    const auto number = static_cast<std::size_t>(size / 2);
    const double x = number == 0 ? size / 2 : size - (2 * static_cast<double>(number) + 1);
    const std::vector<Complex>& terms = table[number];
    return std::accumulate(terms.rbegin(), terms.rend(), Complex(0),
                           [x](Complex sum, Complex term) { return sum * x + term; });
  }
};

LayerPressure::LayerPressure(Complex rate) : rate_(rate), root_(std::sqrt(rate)) {
  static Cache<double, DawsonOnRay> rays(
      [](const double& angle) { return DawsonOnRay{table_on_ray(angle)}; });
  ray_ = rays.at(std::arg(rate));
}

Complex LayerPressure::operator()(double e) const {
  const Complex square = rate_ * e, z = root_ * std::sqrt(e);
  const double size = std::abs(square);
  const Complex dawson = size >= asymptotic_from ? asymptotic_dawson(square, z) : z * ray_->ratio(size);
  return -2 / std::sqrt(std::numbers::pi) * rate_ * dawson;
}

}  // namespace nipref::fast
