#include <algorithm>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/internal/partial_fractions.hpp>

namespace nipref::data {
namespace {

using WideComplex = boost::multiprecision::cpp_complex_quad;
using Roots = std::vector<WideComplex>;

struct ValueAndSlope {
  WideComplex value, slope;
};

ValueAndSlope evaluate(const Polynomial& polynomial, const WideComplex& p) {
  ValueAndSlope at;
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
    at.slope = at.slope * p + at.value;
    at.value = at.value * p + *c;
  }
  return at;
}

/// c + b p + a p^2 without the cancellation of -b + sqrt(b^2 - 4 a c).
Roots quadratic_roots(const Wide& a, const Wide& b, const Wide& c) {
  const WideComplex root = sqrt(WideComplex(b * b - 4 * a * c));
  const WideComplex q = -(b + (b < 0 ? -root : root)) / 2;
  if (q == WideComplex(0)) return {WideComplex(0), WideComplex(0)};
  return {q / a, c / q};
}

/// All roots at once by the method of Ehrlich and Aberth, from points on a circle that holds them
/// (Fujiwara's bound).
Roots aberth_roots(const Polynomial& polynomial) {
  const std::size_t degree = polynomial.size() - 1;
  double radius = 0;
  for (std::size_t k = 0; k < degree; ++k)
    radius = std::max(radius, 2 * std::pow(std::fabs(static_cast<double>(polynomial[k] / polynomial.back())),
                                           1.0 / static_cast<double>(degree - k)));
  Roots roots;
  // Turned a little, so that no two start as each other's conjugates.
  for (std::size_t k = 0; k < degree; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.2) / static_cast<double>(degree);
    roots.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  constexpr int most_rounds = 500;
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (WideComplex& root : roots) {
      const auto [value, slope] = evaluate(polynomial, root);
      if (value == WideComplex(0)) continue;
      WideComplex push = 0;
      for (const WideComplex& other : roots) {
        if (other != root) push += WideComplex(1) / (root - other);
      }
      const WideComplex step = WideComplex(1) / (slope / value - push);
      root -= step;
      change = std::max(change, static_cast<double>(abs(step) / abs(root)));
    }
    if (change < 1e-33) break;
  }
  return roots;
}

/// Real roots exactly real, the others in exact pairs: the coefficients are real. Of a double root, which rounding parts by
/// less than this, one may be cancelled; otherwise it is refused.
Roots in_pairs(const Roots& roots) {
  constexpr double real_to = 1e-13;
  Roots paired;
  for (const WideComplex& root : roots) {
    if (abs(root.imag()) <= real_to * abs(root)) {
      paired.emplace_back(root.real());
    } else if (root.imag() > 0) {
      paired.push_back(root);
      paired.push_back(conj(root));
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
  if (p.size() == 2) return {WideComplex(-p[0] / p[1])};
  return in_pairs(p.size() == 3 ? quadratic_roots(p[2], p[1], p[0]) : aberth_roots(p));
}

bool near(const WideComplex& a, const WideComplex& b, double tolerance) {
  return abs(a - b) <= tolerance * std::max<Wide>(abs(a), abs(b));
}

void cancel(Roots& zeros, Roots& poles) {
  std::erase_if(poles, [&](const WideComplex& pole) {
    const auto zero =
        std::ranges::find_if(zeros, [&](const WideComplex& z) { return near(z, pole, 0x1p-51); });
    if (zero == zeros.end()) return false;
    zeros.erase(zero);
    return true;
  });
}

void check_simple(const Roots& poles, std::string_view name) {
  for (std::size_t i = 0; i < poles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (near(poles[i], poles[j], 1e-6))
        throw BadInput(name, static_cast<double>(poles[i].real()),
                       "must not be a repeated root of the operators: t e^(-rate t) is not among the terms");
    }
  }
}

std::complex<double> rounded(const WideComplex& z) {
  return {static_cast<double>(z.real()), static_cast<double>(z.imag())};
}

/// gain prod (pole - z)/prod (pole - other pole)
WideComplex residue(const Wide& gain, const Roots& zeros, const Roots& poles, std::size_t k) {
  const auto from_zero = [&](std::size_t j) {
    return j < zeros.size() ? WideComplex(poles[k] - zeros[j]) : WideComplex(1);
  };
  WideComplex value = gain * from_zero(k);
  for (std::size_t j = 0; j < poles.size(); ++j) {
    if (j != k) value *= from_zero(j) / (poles[k] - poles[j]);
  }
  return value;
}

}  // namespace

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

Polynomial sum(const Polynomial& a, const Polynomial& b) {
  Polynomial c(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) c[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) c[i] += b[i];
  return c;
}

MaterialFunction partial_fractions(const std::vector<Polynomial>& factors, const Polynomial& denominator,
                                   std::string_view name) {
  Wide gain = 1 / denominator.back();
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
  MaterialFunction function{degree < most ? 0 : static_cast<double>(gain), {}};
  for (std::size_t k = 0; k < poles.size(); ++k) {
    std::complex<double> amplitude = rounded(residue(gain, zeros, poles, k));
    if (poles[k].imag() == 0) amplitude = amplitude.real();
    function.terms.push_back({amplitude, 0.0 - rounded(poles[k])});  // no -0
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
