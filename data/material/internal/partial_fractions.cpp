#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/internal/partial_fractions.hpp>

namespace nipref::data {
namespace {

using Complex = std::complex<double>;
using Roots = std::vector<Complex>;

struct ValueAndSlope {
  Complex value, slope;
};

ValueAndSlope evaluate(const Polynomial& polynomial, Complex p) {
  ValueAndSlope at{0, 0};
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
    at.slope = at.slope * p + at.value;
    at.value = at.value * p + *c;
  }
  return at;
}

/// c + b p + a p^2 without the cancellation of -b + sqrt(b^2 - 4 a c).
Roots quadratic_roots(double a, double b, double c) {
  const Complex root = std::sqrt(Complex(b * b - 4 * a * c));
  const Complex q = -0.5 * (b + std::copysign(1.0, b) * root);
  if (q == 0.0) return {0.0, 0.0};
  return {q / a, c / q};
}

/// All roots at once by the method of Ehrlich and Aberth, from points on a circle that holds them
/// (Fujiwara's bound).
Roots aberth_roots(const Polynomial& polynomial) {
  const std::size_t degree = polynomial.size() - 1;
  double radius = 0;
  for (std::size_t k = 0; k < degree; ++k)
    radius = std::max(radius, 2 * std::pow(std::fabs(polynomial[k] / polynomial.back()),
                                           1.0 / static_cast<double>(degree - k)));
  Roots roots;
  for (std::size_t k = 0; k < degree;
       ++k)  // turned a little, so that no two start as each other's conjugates
    roots.push_back(std::polar(
        radius, 2 * std::numbers::pi * (static_cast<double>(k) + 0.2) / static_cast<double>(degree)));
  constexpr int most_rounds = 500;
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (Complex& root : roots) {
      const auto [value, slope] = evaluate(polynomial, root);
      if (value == 0.0) continue;
      Complex push = 0;
      for (const Complex& other : roots) {
        if (other != root) push += 1.0 / (root - other);
      }
      const Complex step = 1.0 / (slope / value - push);
      root -= step;
      change = std::max(change, std::abs(step) / std::abs(root));
    }
    if (change < 1e-16) break;
  }
  return roots;
}

/// Real roots exactly real, the others in exact pairs: the coefficients are real.
Roots in_pairs(const Roots& roots) {
  constexpr double real_to = 1e-13;
  Roots paired;
  for (const Complex& root : roots) {
    if (std::fabs(root.imag()) <= real_to * std::abs(root)) {
      paired.emplace_back(root.real());
    } else if (root.imag() > 0) {
      paired.push_back(root);
      paired.push_back(std::conj(root));
    }
  }
  return paired;
}

Roots roots_of(const Polynomial& p) {
  if (p.size() == 1) return {};
  if (p[0] == 0) {
    Roots roots = roots_of({p.begin() + 1, p.end()});
    roots.emplace_back(0);
    return roots;
  }
  if (p.size() == 2) return {-p[0] / p[1]};
  return in_pairs(p.size() == 3 ? quadratic_roots(p[2], p[1], p[0]) : aberth_roots(p));
}

bool near(Complex a, Complex b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

void cancel(Roots& zeros, Roots& poles) {
  std::erase_if(poles, [&](Complex pole) {
    const auto zero = std::ranges::find_if(zeros, [&](Complex z) { return near(z, pole, 1e-12); });
    if (zero == zeros.end()) return false;
    zeros.erase(zero);
    return true;
  });
}

void check_simple(const Roots& poles, std::string_view name) {
  for (std::size_t i = 0; i < poles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (near(poles[i], poles[j], 1e-6))
        throw BadInput(name, poles[i].real(),
                       "must not be a repeated root of the operators: t e^(-rate t) is not among the terms");
    }
  }
}

/// gain prod (pole - z)/prod (pole - other pole)
Complex residue(double gain, const Roots& zeros, const Roots& poles, std::size_t k) {
  const auto from_zero = [&](std::size_t j) { return j < zeros.size() ? poles[k] - zeros[j] : 1.0; };
  Complex value = gain * from_zero(k);
  for (std::size_t j = 0; j < poles.size(); ++j) {
    if (j != k) value *= from_zero(j) / (poles[k] - poles[j]);
  }
  return value;
}

}  // namespace

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

Polynomial sum(const Polynomial& a, const Polynomial& b) {
  Polynomial c(std::max(a.size(), b.size()), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) c[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) c[i] += b[i];
  return c;
}

MaterialFunction partial_fractions(const std::vector<Polynomial>& factors, const Polynomial& denominator,
                                   std::string_view name) {
  double gain = 1 / denominator.back();
  Roots zeros;
  std::size_t degree = 0;
  for (const Polynomial& factor : factors) {
    gain *= factor.back();
    degree += factor.size() - 1;
    const Roots roots = roots_of(factor);
    zeros.insert(zeros.end(), roots.begin(), roots.end());
  }
  const std::size_t most = denominator.size() - 1;
  if (degree > most || degree + 1 < most) {
    throw BadInput(
        name, "of degree " + std::to_string(most),
        "must make the compliance's denominator of the numerator's degree, " + std::to_string(degree) +
            ", or one more: the material gives way not without bound, and at once or by a dashpot");
  }
  Roots poles = roots_of(denominator);
  if (zeros.size() != degree || poles.size() != most)
    throw BadInput(name, "(its roots)", "must come in conjugate pairs: some are repeated or nearly so");
  cancel(zeros, poles);
  check_simple(poles, name);
  MaterialFunction function{degree < most ? 0 : gain, {}};
  for (std::size_t k = 0; k < poles.size(); ++k) {
    Complex amplitude = residue(gain, zeros, poles, k);
    if (poles[k].imag() == 0) amplitude = amplitude.real();
    function.terms.push_back({amplitude, 0.0 - poles[k]});  // no -0
  }
  // Rounding must not part the two of a pair.
  for (RelaxationTerm& term : function.terms) {
    if (term.rate.imag() <= 0) continue;
    const auto other = std::ranges::find(function.terms, std::conj(term.rate), &RelaxationTerm::rate);
    other->amplitude = std::conj(term.amplitude);
  }
  return function;
}

}  // namespace nipref::data
