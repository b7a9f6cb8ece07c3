#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rational_compliance.hpp>

namespace nipref::ref {
namespace {

/// Without the zeros at its end.
void trim(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

/// Quotient, and the remainder in place of the dividend.
Polynomial divide(Polynomial& dividend, const Polynomial& divisor) {
  Polynomial quotient(dividend.size() < divisor.size() ? 0 : dividend.size() - divisor.size() + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = dividend[k + divisor.size() - 1] / divisor.back();
    for (std::size_t j = 0; j < divisor.size(); ++j) dividend[k + j] -= quotient[k] * divisor[j];
  }
  trim(dividend);
  return quotient;
}

/// Euclid's.
Polynomial common_factor(Polynomial a, Polynomial b) {
  while (!b.empty()) {
    (void)divide(a, b);
    std::swap(a, b);
  }
  return a;
}

struct ComplexPolynomial {
  std::vector<Float> coefficients;

  explicit ComplexPolynomial(const Polynomial& exact) {
    for (const mpq_class& c : exact) coefficients.push_back(to_float(Exact(c)));
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

/// On a circle that holds all zeros (Fujiwara), turned a little, so that no two are each other's conjugates.
std::vector<ComplexFloat> first_guesses(const ComplexPolynomial& p) {
  const int n = p.degree();
  Float radius = 0;
  for (int k = 0; k < n; ++k) {
    const auto& c = p.coefficients;
    const Float size = abs(c[static_cast<std::size_t>(k)] / c.back());
    if (size != 0) radius = std::max(radius, Float(2 * pow(size, Float(1) / (n - k))));
  }
  std::vector<ComplexFloat> guesses;
  for (int k = 0; k < n; ++k)
    guesses.push_back(exp(ComplexFloat(0, 2 * std::numbers::pi * (k + 0.2) / n)) * radius);
  return guesses;
}

/// Each within n |p/p'| of one of p's, which is below `unit` of it, and none of these discs with two.
bool are_zeros(const ComplexPolynomial& p, const std::vector<ComplexFloat>& zeros, const Float& unit) {
  return std::ranges::all_of(zeros, [&](const ComplexFloat& zero) {
    const auto [value, slope] = p.at(zero);
    const bool alone = std::ranges::all_of(zeros, [&](const ComplexFloat& other) {
      return &other == &zero || abs(other - zero) > sqrt(unit) * abs(zero);
    });
    return alone && p.degree() * abs(value) <= unit * abs(slope) * abs(zero);
  });
}

/// All zeros at once by the method of Ehrlich and Aberth, checked.
std::vector<ComplexFloat> zeros_of(const ComplexPolynomial& p, const Float& unit) {
  constexpr int most_rounds = 2000;
  std::vector<ComplexFloat> zeros = first_guesses(p);
  Float change = 1;
  for (int round = 0; round < most_rounds && change > 0; ++round) {
    change = 0;
    for (ComplexFloat& zero : zeros) {
      const auto [value, slope] = p.at(zero);
      if (abs(value) == 0 || p.degree() * abs(value) <= unit * unit * abs(slope) * abs(zero)) continue;
      ComplexFloat push;
      for (const ComplexFloat& other : zeros) {
        if (&other != &zero) push = push + ComplexFloat(1) / (zero - other);
      }
      const ComplexFloat step = ComplexFloat(1) / (slope / value - push);
      zero = zero - step;
      const Float relative = abs(step) / abs(zero);
      if (relative > unit) change = std::max(change, relative);
    }
  }
  if (!are_zeros(p, zeros, unit)) {
    throw data::BadInput("nip.material", "(operators)",
                         "must have rates that are apart: two of them are one, or nearly so");
  }
  return zeros;
}

ComplexFloat rounded(const ComplexFloat& x) {
  return {x.re.at_working_precision(), x.im.at_working_precision()};
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

Compliance rational_compliance(Polynomial numerator, Polynomial denominator) {
  trim(numerator);
  trim(denominator);
  const Polynomial common = common_factor(numerator, denominator);
  numerator = divide(numerator, common);
  denominator = divide(denominator, common);
  const mpq_class gain = numerator.back() / denominator.back();

  const mpfr_prec_t bits = mpfr_get_prec(Float().get());
  const Float unit = ldexp(Float(1), -bits - 8);
  std::vector<ComplianceTerm> terms;
  {
    const WorkingDigits working(static_cast<int>(static_cast<double>(2 * bits) * 0.302) + 10);
    const ComplexPolynomial above(numerator), below(denominator);
    for (ComplexFloat zero : zeros_of(below, unit)) {
      if (abs(zero.im) <= unit * abs(zero)) zero.im = 0;
      if (zero.im > 0) continue;  // its conjugate stands for both
      const ComplexFloat residue = above.at(zero).first / below.at(zero).second;
      terms.push_back({residue * Float(zero.is_real() ? 1 : 2), -zero});
    }
  }
  Compliance result{to_float(Exact(gain)), {}};
  for (const ComplianceTerm& term : terms)
    result.terms.push_back({rounded(term.amplitude), rounded(term.rate)});
  return result;
}

}  // namespace nipref::ref
