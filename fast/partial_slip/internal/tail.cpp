#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>

#include <nipref/fast/partial_slip/internal/tail.hpp>

namespace nipref::fast {
namespace {

using std::numbers::pi;

/// For moments a_k of a positive measure on [0, 1], sum_k (-1)^k a_k, k >= 0, is sum_k (-1)^k factor_k a_k over 22
/// terms to (3 + sqrt 8)^-22 = 1e-17. (Cohen, Rodriguez Villegas, Zagier 2000, algorithm 1)
const std::array<double, 22>& factors_of_alternating_sum() {
  static const auto all = [] {
    std::array<double, 22> factors{};
    const auto n = static_cast<double>(factors.size());
    const double d = std::cosh(n * std::log(3 + std::sqrt(8.0)));
    double b = -1, c = -d;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const auto k = static_cast<double>(i);
      c = b - c;
      factors[i] = (i % 2 == 0 ? 1 : -1) * c / d;
      b *= (k + n) * (k - n) / ((k + 0.5) * (k + 1));
    }
    return factors;
  }();
  return all;
}

}  // namespace

Tail::Tail(const Powers& powers, double step)
    : decays_(powers * step), spacing_(std::max(1, static_cast<int>(std::lround(1 / step)))) {
  Square values;
  for (int node = 0; node < terms; ++node)
    values.row(node) = (node * spacing_ * decays_).exp().matrix().transpose();
  of_powers_ = values.inverse();
}

Tail::Parts Tail::sinc_sum(double steps) const {
  Powers sum = Powers::Zero(), powers = Powers::Ones();
  const Powers ratios = (-decays_).exp();
  double place = steps;
  for (std::size_t k = 0; k < factors_of_alternating_sum().size(); ++k) {
    place += 1;
    powers *= ratios;
    sum += (k % 2 == 0 ? 1 : -1) * factors_of_alternating_sum()[k] / place * powers;
  }
  return -std::sin(pi * steps) / pi * (of_powers_.transpose() * sum.matrix());
}

}  // namespace nipref::fast
