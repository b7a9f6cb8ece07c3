#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// From here on the asymptotic series has double accuracy.
constexpr double asymptotic_from = 40;

/// The series 1/(2z) sum_k (2k - 1)!!/(2 z^2)^k up to its smallest term, plus an exponential off the real axis.
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

/// h(s) = D(z)/z = int_0^1 e^(-s (1 - t^2)) dt, s = z^2, on a ray of s up to |s| = asymptotic_from: Taylor polynomials
/// about odd |s|, each between even |s|. Their coefficients are such integrals with powers of 1 - t^2 as factors.
using Table = std::vector<std::vector<Complex>>;

/// Computes a table in extended precision and drops coefficients less than the rounding of a double. Gauss's rule of 40
/// nodes has an error of 1e-19 at |s| = 40, because the Chebyshev coefficients of the integrand are at most those of
/// e^(10 (1 + x)^2) over e^40, or, if it oscillates, of e^(10 i (1 + x)^2).
Table table_on_ray(const double& angle) {
  using Rule = boost::math::quadrature::gauss<long double, 40>;
  using Extended = std::complex<long double>;
  const Extended direction = std::polar(1.0L, static_cast<long double>(angle));
  std::vector<std::vector<Extended>> sums(static_cast<std::size_t>(asymptotic_from / 2),
                                          std::vector<Extended>(22));
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    for (const long double x : {-Rule::abscissa()[i], Rule::abscissa()[i]}) {
      const Extended power = -(1 - x) * (3 + x) / 4 * direction;  // t = (1 + x)/2
      const Extended step = std::exp(2.0L * power);
      Extended faded = Rule::weights()[i] / 2 * std::exp(power);
      for (auto& terms : sums) {
        Extended term = faded;
        for (Extended& sum : terms) {
          sum += term;
          term *= power;
        }
        faded *= step;
      }
    }
  }
  Table table;
  for (auto& terms : sums) {
    long double factorial = 1;
    for (std::size_t k = 1; k < terms.size(); ++k) terms[k] /= factorial *= static_cast<long double>(k);
    while (std::abs(terms.back()) < 1e-18L * std::abs(terms.front())) terms.pop_back();
    table.emplace_back(terms.begin(), terms.end());
  }
  return table;
}

}  // namespace

LayerPressure::LayerPressure(Complex rate) : rate_(rate), root_(std::sqrt(rate)) {
  static Cache<double, Table> rays(table_on_ray);
  ray_ = rays.at(std::arg(rate));
}

Complex LayerPressure::operator()(double e) const {
  const Complex square = rate_ * e, z = root_ * std::sqrt(e);
  const double size = std::abs(square), to_pressure = -2 / std::sqrt(std::numbers::pi);
  if (size >= asymptotic_from) return to_pressure * rate_ * asymptotic_dawson(square, z);
  const auto number = static_cast<std::size_t>(size / 2);
  const double x = size - (2 * static_cast<double>(number) + 1);
  const std::vector<Complex>& terms = (*ray_)[number];
  return to_pressure * rate_ *
         (z * std::accumulate(terms.rbegin(), terms.rend(), Complex(0),
                              [x](Complex sum, Complex term) { return sum * x + term; }));
}

}  // namespace nipref::fast
