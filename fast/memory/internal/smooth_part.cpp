#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/memory/internal/smooth_part.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/sheet/internal/regular_parts.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast::internal {
namespace {

constexpr double negligible = 1e-18;  ///< of kernels, whose size is 1

template <typename Coefficient>
using Coefficients = std::array<Coefficient, Series<Coefficient>::most_terms>;

/// c'_k = c'_(k + 2) + 2 (k + 1) c_(k + 1)/half_width of the derivative c', of which later ones are known.
template <typename Coefficient>
Coefficient slope_coefficient(const Coefficients<Coefficient>& of, const Coefficients<Coefficient>& slope,
                              std::size_t k) {
  const auto at = [k](const auto& all, std::size_t more) {
    return k + more < all.size() ? all[k + more] : Coefficient(0);
  };
  return at(slope, 2) + 2 * static_cast<double>(k + 1) / Series<Coefficient>::half_width * at(of, 1);
}

Series<double> through_chebyshev_points(Kernel kernel) {
  const auto value = [kernel](double w) {
    if (kernel == Kernel::I3) return I3(w);
    double at[] = {w};
    regular_I1(at, at);
    return at[0];
  };
  Coefficients<double> result{};
  constexpr std::size_t points = result.size();  // even, so that none is at 0
  for (std::size_t j = 0; j < points; ++j) {
    const double angle = (static_cast<double>(j) + 0.5) * std::numbers::pi / points;
    const double here = 2.0 / points * value(Series<double>::half_width * std::cos(angle));
    for (std::size_t k = 0; k < points; ++k) result[k] += here * std::cos(static_cast<double>(k) * angle);
  }
  return {result, negligible};
}

Series<double> slope(const Series<double>& series) {
  Coefficients<double> result{};
  for (std::size_t k = result.size(); k-- > 0;)
    result[k] = slope_coefficient(series.coefficients(), result, k);
  return {result, negligible};
}

template <typename Rate>
Series<Rate> memory_polynomial(const Series<double>& f, Rate rate) {
  Coefficients<Rate> result{}, slope{};
  const Rate step = 1.0 / rate;
  for (std::size_t k = f.terms(); k-- > 0;) {
    slope[k] = slope_coefficient(result, slope, k);
    result[k] = (f.coefficients()[k] + slope[k]) * step;
  }
  return {result, negligible * std::abs(step)};
}

double faded_by(double nats) { return std::exp(-nats); }
Complex faded_by(Complex nats) { return faded_exp(nats); }

}  // namespace

template <typename Coefficient>
Series<Coefficient>::Series(const std::array<Coefficient, most_terms>& coefficients, double negligible)
    : coefficients_(coefficients) {
  for (double tail = 0; terms_ > 1; --terms_) {
    tail += std::abs(coefficients_[terms_ - 1]);
    if (tail > negligible) break;
  }
}

template <typename Coefficient>
Coefficient Series<Coefficient>::operator()(double w) const {
  const double t = w / half_width;
  Coefficient here = 0, above = 0;
  for (std::size_t k = terms_ - 1; k > 0; --k)
    above = std::exchange(here, 2 * t * here - above + coefficients_[k]);
  return t * here - above + 0.5 * coefficients_[0];
}

const Series<double>& smooth_part(Kernel kernel) {
  static const Series<double> of_I1 = through_chebyshev_points(Kernel::I1),
                              of_I3 = through_chebyshev_points(Kernel::I3);
  return kernel == Kernel::I1 ? of_I1 : of_I3;
}

const Series<double>& slope_of_smooth_part(Kernel kernel) {
  static const Series<double> of_I1 = slope(smooth_part(Kernel::I1)), of_I3 = slope(smooth_part(Kernel::I3));
  return kernel == Kernel::I1 ? of_I1 : of_I3;
}

template <typename Rate>
SmoothMemory<Rate>::SmoothMemory(const Series<double>& f, Rate rate)
    : rate_(rate), polynomial_(memory_polynomial(f, rate)), at_nearest_(polynomial_(nearest)) {}

template <typename Rate>
Rate SmoothMemory<Rate>::from(double w) const {
  const Rate kept = faded_by(rate_ * (nearest - w));
  return kept == 0.0 ? polynomial_(w) : polynomial_(w) - kept * at_nearest_;
}

template class Series<double>;
template class SmoothMemory<double>;
template class SmoothMemory<Complex>;

}  // namespace nipref::fast::internal
