#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/ref/material/internal/inverse_transform.hpp>

namespace nipref::ref {
namespace {

/// Polynomials of z modulo one of degree n >= 1, whose last coefficient is 1 and whose others are `divisor`; they have n
/// coefficients. Proofs: ref/README.md, Lemma 12.
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
  /// e^(z/2)
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
  // About what intervals lose in so many squarings.
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
