#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/ref/material/internal/polynomial.hpp>

namespace nipref::ref {
namespace {

/// A polynomial with the coefficients rounded to the working precision.
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

/// All zeros to about `unit` of their magnitudes. A value p(z) counts as 0 where it is within the rounding error, or
/// where degree |p/p'|, a bound of the distance from z to a zero, is at most unit^2 |z|.
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

/// Euclid's algorithm.
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

namespace {

using Points = std::vector<ComplexInterval>;

ComplexInterval at(const Polynomial& p, const ComplexInterval& z) {
  const mpfr_prec_t bits = z.re.precision();
  ComplexInterval value{Interval(bits), Interval(bits)};
  for (std::size_t k = p.size(); k-- > 0;) {
    value = value * z;
    value.re = value.re + Interval(p[k], bits);
  }
  return value;
}

/// The product of z_i - z_j over all j != i.
ComplexInterval apart(const Points& points, std::size_t i) {
  const mpfr_prec_t bits = points[i].re.precision();
  ComplexInterval product{Interval(1L, bits), Interval(bits)};
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j != i) product = product * (points[i] - points[j]);
  }
  return product;
}

/// Squares around discs that contain one root each; nothing if some discs overlap.
std::optional<Points> proven_roots(const Polynomial& denominator, mpfr_prec_t bits) {
  const Points near = roots_near(denominator, bits);
  const Exact last(last_of(denominator));
  std::vector<Interval> radii;
  Points roots;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Interval lead = abs(apart(near, i)) * Interval(mpq_class(abs(last.value())), bits);
    if (mpfi_has_zero(lead.get()) > 0) return {};
    radii.push_back(static_cast<long>(near.size()) * (abs(at(denominator, near[i])) / lead));
    roots.push_back({near[i].re.widened(radii[i]), near[i].im.widened(radii[i])});
  }
  for (std::size_t i = 0; i < near.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Interval between = abs(near[i] - near[j]) - radii[i] - radii[j];
      if (sign_of(between) <= 0) return {};
    }
  }
  return roots;
}

}  // namespace

std::vector<OscillatingTerm> partial_fractions(const Polynomial& numerator, const Polynomial& denominator,
                                               mpfr_prec_t bits) {
  std::optional<Points> roots = proven_roots(denominator, bits);
  while (!roots) roots = proven_roots(denominator, bits *= 2);
  std::vector<OscillatingTerm> terms;
  for (std::size_t i = 0; i < roots->size(); ++i) {
    const ComplexInterval& root = (*roots)[i];
    const ComplexInterval slope = Interval(last_of(denominator), bits) * apart(*roots, i);
    terms.push_back({at(numerator, root) * inverse(slope), -root});
  }
  return terms;
}

bool has_repeated_root(const Polynomial& denominator) {
  Polynomial slope = denominator.prime(), factor = denominator;
  if (slope.is_zero()) return false;
  cancel(slope, factor);
  return factor.size() < denominator.size();
}

namespace {

/// Arithmetic with polynomials of z modulo a polynomial of degree n >= 1. The coefficient of z^n of that polynomial is
/// 1; `divisor` has its other coefficients. A remainder has n coefficients. Proofs: ref/README.md, Lemma 12.
struct Remainders {
  using Polynomial = std::vector<Interval>;

  Polynomial divisor;
  mpfr_prec_t bits;

  [[nodiscard]] Polynomial times_z(Polynomial x) const {
    const Interval last = x.back();
    for (std::size_t i = x.size(); i-- > 1;) x[i] = x[i - 1] - last * divisor[i];
    x[0] = -(last * divisor[0]);
    return x;
  }
  [[nodiscard]] Polynomial product(const Polynomial& x, const Polynomial& y) const {
    Polynomial sum(x.size(), Interval(bits));
    for (std::size_t k = y.size(); k-- > 0;) {
      sum = times_z(std::move(sum));
      for (std::size_t i = 0; i < x.size(); ++i) sum[i] = sum[i] + y[k] * x[i];
    }
    return sum;
  }
  /// The remainder of e^(z/2).
  [[nodiscard]] Polynomial exponential() const {
    Polynomial term(divisor.size(), Interval(bits));
    term[0] = Interval(1L, bits);
    Polynomial sum = term;
    double left = static_cast<double>(bits);
    for (long k = 1; left > 0; ++k) {
      left -= std::log2(2.0 * static_cast<double>(k));
      term = times_z(std::move(term));
      for (std::size_t i = 0; i < sum.size(); ++i) {
        term[i] = term[i] / (2 * k);
        sum[i] = sum[i] + term[i];
      }
    }
    const Interval rest = sum_of_magnitudes(term);
    for (Interval& coefficient : sum) coefficient = coefficient.widened(rest);
    return sum;
  }
};

}  // namespace

Interval inverse_transform(const Polynomial& numerator, const Polynomial& denominator, const mpq_class& t,
                           mpfr_prec_t bits) {
  const double turns = log2_root_bound(denominator) + Exact(t).log2_magnitude() + 1e-9;
  const auto halvings = static_cast<unsigned>(std::max(0.0, std::ceil(turns + 1)));
  const std::size_t n = denominator.size() - 1;
  // The intervals lose about n + 1 bits in each squaring.
  bits += static_cast<mpfr_prec_t>((n + 1) * halvings);
  mpq_class step = 2 * t;  // z = p step
  mpq_div_2exp(step.get_mpq_t(), step.get_mpq_t(), halvings);
  Remainders modulo{{}, bits};
  Remainders::Polynomial above(n, Interval(bits));
  mpq_class factor = 1 / last_of(denominator);
  for (std::size_t k = n; k-- > 0; factor *= step) {
    if (k < numerator.size()) above[k] = Interval(mpq_class(numerator[k] * factor), bits);
    modulo.divisor.insert(modulo.divisor.begin(), Interval(mpq_class(denominator[k] * factor * step), bits));
  }
  Remainders::Polynomial power = modulo.exponential();
  for (unsigned k = 0; k < halvings; ++k) power = modulo.product(power, power);
  return modulo.product(power, above).back();
}

double slowest_rate(const Polynomial& denominator) {
  double slowest = INFINITY;
  for (const ComplexInterval& root : roots_near(denominator, 200))
    slowest = std::min(slowest, -mpfr_get_d(root.re.lower(), MPFR_RNDD));
  return slowest;
}

}  // namespace nipref::ref
