#include <algorithm>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include <nipref/fast/material/internal/partial_fractions.hpp>

namespace nipref::fast::internal {
namespace {

using QuadComplex = boost::multiprecision::cpp_complex_quad;
using Roots = std::vector<QuadComplex>;

struct ValueAndSlope {
  QuadComplex value, slope;
};

ValueAndSlope evaluate(const QuadPolynomial& polynomial, const QuadComplex& p) {
  ValueAndSlope at;
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
    at.slope = at.slope * p + at.value;
    at.value = at.value * p + *c;
  }
  return at;
}

/// c + b p + a p^2 without the cancellation of -b + sqrt(b^2 - 4 a c).
Roots quadratic_roots(const Quad& a, const Quad& b, const Quad& c) {
  const QuadComplex root = sqrt(QuadComplex(b * b - 4 * a * c));
  const QuadComplex q = -(b + (b < 0 ? -root : root)) / 2;
  if (q == QuadComplex(0)) return {QuadComplex(0), QuadComplex(0)};
  return {q / a, c / q};
}

/// All roots at once by the method of Ehrlich and Aberth. It starts from points on a circle that encloses the roots
/// (Fujiwara's bound).
Roots aberth_roots(const QuadPolynomial& polynomial) {
  const std::size_t degree = polynomial.size() - 1;
  double radius = 0;
  for (std::size_t k = 0; k < degree; ++k)
    radius = std::max(radius, 2 * std::pow(std::fabs(static_cast<double>(polynomial[k] / polynomial.back())),
                                           1.0 / static_cast<double>(degree - k)));
  Roots roots;
  // The angle 0.2 keeps any two from starting as each other's conjugates.
  for (std::size_t k = 0; k < degree; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.2) / static_cast<double>(degree);
    roots.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  constexpr int most_rounds = 500;
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (QuadComplex& root : roots) {
      const auto [value, slope] = evaluate(polynomial, root);
      if (value == QuadComplex(0)) continue;
      QuadComplex push = 0;
      for (const QuadComplex& other : roots) {
        if (other != root) push += QuadComplex(1) / (root - other);
      }
      const QuadComplex step = QuadComplex(1) / (slope / value - push);
      root -= step;
      change = std::max(change, static_cast<double>(abs(step) / abs(root)));
    }
    if (change < 1e-33) break;
  }
  return roots;
}

/// The coefficients are real: makes real roots exactly real and the others exact conjugate pairs. Rounding splits a
/// double root by less than `real_to`; either a zero of the numerator cancels one of the two, or they are refused.
Roots in_pairs(const Roots& roots) {
  constexpr double real_to = 1e-13;
  Roots paired;
  for (const QuadComplex& root : roots) {
    if (abs(root.imag()) <= real_to * abs(root)) {
      paired.emplace_back(root.real());
    } else if (root.imag() > 0) {
      paired.push_back(root);
      paired.push_back(conj(root));
    }
  }
  return paired;
}

Roots roots_of(const QuadPolynomial& p) {
  if (p.size() == 1) return {};
  if (p[0] == 0) {
    Roots roots = roots_of({p.begin() + 1, p.end()});
    roots.emplace_back(0);
    return roots;
  }
  if (p.size() == 2) return {QuadComplex(-p[0] / p[1])};
  return in_pairs(p.size() == 3 ? quadratic_roots(p[2], p[1], p[0]) : aberth_roots(p));
}

bool near(const QuadComplex& a, const QuadComplex& b, double tolerance) {
  return abs(a - b) <= tolerance * std::max<Quad>(abs(a), abs(b));
}

void cancel(Roots& zeros, Roots& poles) {
  std::erase_if(poles, [&](const QuadComplex& pole) {
    const auto zero =
        std::ranges::find_if(zeros, [&](const QuadComplex& z) { return near(z, pole, 0x1p-51); });
    if (zero == zeros.end()) return false;
    zeros.erase(zero);
    return true;
  });
}

void check_simple(const Roots& poles, std::string_view name) {
  for (std::size_t i = 0; i < poles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (near(poles[i], poles[j], 1e-6))
        throw data::NoMaterial(
            name, static_cast<double>(poles[i].real()),
            "must not be a repeated root of the operators: t e^(-rate t) is not among the terms");
    }
  }
}

std::complex<double> rounded(const QuadComplex& z) {
  return {static_cast<double>(z.real()), static_cast<double>(z.imag())};
}

/// gain prod (pole - z)/prod (pole - other pole)
QuadComplex residue(const Quad& gain, const Roots& zeros, const Roots& poles, std::size_t k) {
  const auto from_zero = [&](std::size_t j) {
    return j < zeros.size() ? QuadComplex(poles[k] - zeros[j]) : QuadComplex(1);
  };
  QuadComplex value = gain * from_zero(k);
  for (std::size_t j = 0; j < poles.size(); ++j) {
    if (j != k) value *= from_zero(j) / (poles[k] - poles[j]);
  }
  return value;
}

}  // namespace

QuadPolynomial product(const QuadPolynomial& a, const QuadPolynomial& b) {
  QuadPolynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

QuadPolynomial sum(const QuadPolynomial& a, const QuadPolynomial& b) {
  QuadPolynomial c(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) c[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) c[i] += b[i];
  return c;
}

data::MaterialFunction partial_fractions(const std::vector<QuadPolynomial>& factors,
                                         const QuadPolynomial& denominator, std::string_view name) {
  Quad gain = 1 / denominator.back();
  Roots zeros;
  std::size_t degree = 0;
  for (const QuadPolynomial& factor : factors) {
    gain *= factor.back();
    degree += factor.size() - 1;
    const Roots roots = roots_of(factor);
    zeros.insert(zeros.end(), roots.begin(), roots.end());
  }
  const std::size_t most = denominator.size() - 1;
  if (degree > most || degree + 1 < most) {
    throw data::NoMaterial(
        name, "of degree " + std::to_string(most),
        "must make the compliance's denominator of the numerator's degree, " + std::to_string(degree) +
            ", or one more: the material gives way not without bound, and at once or by a dashpot");
  }
  Roots poles = roots_of(denominator);
  if (zeros.size() != degree || poles.size() != most)
    throw data::NoMaterial(name, "(its roots)",
                           "must come in conjugate pairs: some are repeated or nearly so");
  cancel(zeros, poles);
  check_simple(poles, name);
  data::MaterialFunction function{degree < most ? 0 : static_cast<double>(gain), {}};
  for (std::size_t k = 0; k < poles.size(); ++k) {
    std::complex<double> amplitude = rounded(residue(gain, zeros, poles, k));
    if (poles[k].imag() == 0) amplitude = amplitude.real();
    function.terms.push_back({amplitude, 0.0 - rounded(poles[k])});  // no -0
  }
  // Rounding must not make the amplitudes of a conjugate pair different.
  for (data::RelaxationTerm& term : function.terms) {
    if (term.rate.imag() <= 0) continue;
    const auto other = std::ranges::find(function.terms, std::conj(term.rate), &data::RelaxationTerm::rate);
    other->amplitude = std::conj(term.amplitude);
  }
  return function;
}

}  // namespace nipref::fast::internal
