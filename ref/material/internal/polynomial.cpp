#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/material/internal/polynomial.hpp>

namespace nipref::ref {
namespace {

/// The coefficients to the working precision.
struct FloatPolynomial {
  std::vector<Float> coefficients;

  explicit FloatPolynomial(const Polynomial& exact) {
    for (const mpq_class& c : exact.data()) coefficients.push_back(to_float(c));
  }
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  /// Value and slope.
  [[nodiscard]] std::pair<ComplexFloat, ComplexFloat> at(const ComplexFloat& z) const {
    ComplexFloat value, slope;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
      slope = slope * z + value;
      value = value * z + ComplexFloat(*c);
    }
    return {std::move(value), std::move(slope)};
  }
};

/// Points on a circle that contains all zeros, rotated a little so that no two are conjugate.
std::vector<ComplexFloat> first_guesses(int n, const Float& radius) {
  std::vector<ComplexFloat> guesses;
  for (int k = 0; k < n; ++k)
    guesses.push_back(exp(ComplexFloat(0, 2 * std::numbers::pi * (k + 0.2) / n)) * radius);
  return guesses;
}

/// The sum of the magnitudes of the terms of p(z).
Float size_of_terms(const FloatPolynomial& p, const ComplexFloat& z) {
  const Float size = abs(z);
  Float sum = 0;
  for (auto c = p.coefficients.rbegin(); c != p.coefficients.rend(); ++c) sum = sum * size + abs(*c);
  return sum;
}

/// A value is taken for 0 where it is a rounding error, or changes the zero by less than `unit`.
std::vector<ComplexFloat> approximate_zeros(const Polynomial& exact, const Float& unit) {
  constexpr int lost_bits = 4;
  const FloatPolynomial p(exact);
  const Float rounding = ldexp(Float(1), lost_bits - working_bits());
  const auto slope_over_value = [&](const ComplexFloat& z) -> std::optional<ComplexFloat> {
    const auto [value, slope] = p.at(z);
    if (abs(value) <= rounding * size_of_terms(p, z) ||
        p.degree() * abs(value) <= unit * unit * abs(slope) * abs(z))
      return std::nullopt;
    return slope / value;
  };
  return zeros_by_steps(first_guesses(p.degree(), exp2(Float(log2_root_bound(exact)))), slope_over_value,
                        unit);
}

}  // namespace

/// By Euclid's algorithm.
void cancel(Polynomial& numerator, Polynomial& denominator) {
  Polynomial common = numerator, rest = denominator;
  while (!rest.is_zero()) common = std::exchange(rest, common % rest);
  numerator /= common;
  denominator /= common;
}

double log2_root_bound(const Polynomial& p) {
  double largest = -HUGE_VAL;
  const double last = Exact(last_of(p)).log2_magnitude();
  for (std::size_t k = 0; k + 1 < p.size(); ++k)
    largest =
        std::max(largest, (Exact(p[k]).log2_magnitude() - last) / static_cast<double>(p.size() - 1 - k));
  return 1 + largest;
}

std::vector<ComplexFloat> zeros_by_steps(
    std::vector<ComplexFloat> zeros,
    const std::function<std::optional<ComplexFloat>(const ComplexFloat& z)>& slope_over_value,
    const Float& unit) {
  constexpr int most_rounds = 2000;
  Float largest = unit + 1;
  for (int round = 0; round < most_rounds && largest > unit; ++round) {
    largest = 0;
    for (ComplexFloat& zero : zeros) {
      const auto slope = slope_over_value(zero);
      if (!slope) continue;
      ComplexFloat push;
      for (const ComplexFloat& other : zeros) {
        const ComplexFloat apart = zero - other;
        if (abs(apart) > 0) push = push + ComplexFloat(1) / apart;
      }
      const ComplexFloat step = ComplexFloat(1) / (*slope - push);
      zero = zero - step;
      largest = std::max(largest, Float(abs(step) / abs(zero)));
    }
  }
  return zeros;
}

std::vector<ComplexInterval> roots_near(Polynomial p, mpfr_prec_t bits) {
  const WorkingDigits working(static_cast<int>(static_cast<double>(bits) * 0.302) + 10);
  std::vector<ComplexInterval> roots;
  for (; p.size() > 1 && p[0] == 0; p >>= 1) roots.push_back({Interval(bits), Interval(bits)});
  for (const ComplexFloat& root : approximate_zeros(p, ldexp(Float(1), -bits)))
    roots.push_back({interval_of(root.re, std::max(bits, bits_of(root.re))),
                     interval_of(root.im, std::max(bits, bits_of(root.im)))});
  return roots;
}

}  // namespace nipref::ref
