#include <cmath>
#include <type_traits>

#include <nipref/ref/nip/internal/singular_integrals.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {
namespace {

// Of Floats where m is real.
template <class Number>
using Sequence = std::vector<Number>;

/// t^m
template <class Number>
Number power(const Float& t, const Number& m) {
  return t == 0 ? Number() : Number(exp(m * log(t)));
}

/// Integrals of t^m T_k f from the first three of t^(m+j) f and from those of (t^{m+1} P_k)' f.
template <class Number, class OfDerivative>
Sequence<Number> continued(const Number& m, const Number (&powers)[3], int count,
                           const OfDerivative& of_derivative) {
  Sequence<Number> result{powers[0], powers[1] * Float(2) - powers[0],
                          powers[2] * Float(8) - powers[1] * Float(8) + powers[0]};
  const Number one(1), next = m + one;
  for (int k = 2; k + 1 < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Number before = one - next / Float(k - 1), after = one + next / Float(k + 1);
    result.push_back((of_derivative(k) - result[at] * Float(2) - before * result[at - 1]) / after);
  }
  return result;
}

/// P_k at t by the values of T.
Float end_polynomial(const std::vector<Float>& chebyshev, int k) {
  const auto at = static_cast<std::size_t>(k);
  return chebyshev[at + 1] / (k + 1) - chebyshev[at - 1] / (k - 1);
}

template <class Number>
Sequence<Number> plain_moments(const Number& m, int count) {
  const Number one(1), powers[]{one / (m + one), one / (m + Number(2)), one / (m + Number(3))};
  return continued(m, powers, count, [](int k) { return Number(Float(1) / (k + 1) - Float(1) / (k - 1)); });
}

/// int_0^x t^m T_k
template <class Number>
Sequence<Number> moments_up_to(const Number& m, const Float& x, int count) {
  std::vector<Float> chebyshev(static_cast<std::size_t>(count) + 1);
  chebyshev_values(2 * x - 1, chebyshev);
  const Number end = power(x, m) * x;
  const Number powers[]{end / (m + Number(1)), end * x / (m + Number(2)), end * (x * x) / (m + Number(3))};
  return continued(m, powers, count, [&](int k) { return Number(end * end_polynomial(chebyshev, k)); });
}

/// sum_{j >= 0} x^{j+1}/(j + 1 + shift), |x| <= 3/4
template <class Number>
Number fading_sum(const Float& x, const Number& shift) {
  const Float least = ldexp(Float(1), -working_bits() - 4);
  Number sum;
  Float term = x;
  for (int j = 1; abs(term) > least; ++j, term *= x) sum = sum + Number(term) / (shift + Number(j));
  return sum;
}

/// int_0^1 t^m/(x - t) dt, a principal value, -1/2 <= x <= 3/2, x not 0 or 1.
template <class Number>
Number inverse_integral(const Number& m, const Float& x) {
  if constexpr (std::is_same_v<Number, Float>)
    if (m == 0) return log(abs(x / (x - 1)));
  if (x < Float(1) / 2) {
    // int_0^inf t^{m-1}/(t - x) dt = -pi x^{m-1} cot(pi m), for x < 0 with 1/sin for cot and |x|; less what is from 1 on.
    const Number angle = m * pi(), up = x > 0 ? cos(angle) : Number(1);
    const Number whole = up / sin(angle) * pi() * power(Float(abs(x)), m);
    return whole + fading_sum<Number>(x, -m) - Number(1) / m;
  }
  // Up to a place before x by powers of t/x, from there to 1 by those of 1 - t.
  const Float border = x < 1 ? Float(x / 2) : Float(1) / 2, rest = 1 - border, beyond = x - 1;
  Number sum = power(border, m) * fading_sum(border / x, m);
  const Float least = ldexp(Float(1), -working_bits() - 4);
  // int_0^rest y^n/(y + beyond) dy, and the coefficient of y^n in (1 - y)^m.
  Float integral = log(abs((rest + beyond) / beyond)), power_of_rest = rest;
  Number coefficient(1);
  for (int n = 0; power_of_rest > least; ++n) {
    sum = sum + coefficient * integral;
    integral = power_of_rest / (n + 1) - beyond * integral;
    power_of_rest *= rest;
    coefficient = coefficient * (Number(n) - m) / Float(n + 1);
  }
  return sum;
}

/// Digits that the recurrence of 1/(x - t) loses.
int lost_digits(const Float& x, int count) {
  const double size = std::fabs(2 * static_cast<double>(x) - 1);
  return size > 1 ? static_cast<int>(2 * count * std::log10(size + std::sqrt(size * size - 1))) + 2 : 0;
}

template <class Number>
std::vector<ComplexFloat> rounded(const Sequence<Number>& sequence) {
  std::vector<ComplexFloat> result;
  for (const Number& value : sequence) {
    const ComplexFloat x(value);
    result.emplace_back(at_working_precision(x.re), at_working_precision(x.im));
  }
  return result;
}

}  // namespace

SingularIntegrals::SingularIntegrals(const ComplexFloat& exponent, int count)
    : plain_(plain_moments(exponent, count)) {}

SingularIntegrals::SingularIntegrals(const ComplexFloat& exponent, const Float& x, int count) {
  if (exponent.is_real())
    compute(exponent.re, x, count);
  else
    compute(exponent, x, count);
}

template <class Number>
void SingularIntegrals::compute(const Number& m, const Float& x, int count) {
  Sequence<Number> plain, logarithm, sign, inverse;
  {
    const WorkingDigits more(digits_of(working_bits()) + lost_digits(x, count) + 4);
    plain = plain_moments(m, count + 1);
    const bool at_border = x == 0 || x == 1;
    const Float turn = 2 * (2 * x - 1);
    inverse.push_back(at_border ? Number() : inverse_integral(m, x));
    inverse.push_back((inverse[0] * x - plain[0]) * Float(2) - inverse[0]);
    for (std::size_t k = 1; k <= static_cast<std::size_t>(count); ++k)
      inverse.push_back(inverse[k] * turn - inverse[k - 1] - plain[k] * Float(4));
    // Of t^{m+1} T_k/(x - t).
    const auto shifted = [&](int k) -> Number {
      return inverse[static_cast<std::size_t>(k)] * x - plain[static_cast<std::size_t>(k)];
    };
    const Float at_one = x == 1 ? Float(0) : log(abs(x - 1));
    Number over = inverse[0], powers[3];
    for (int j = 0; j < 3; ++j) {
      const Number next = m + Number(j + 1);
      over = over * x - Number(1) / next;
      powers[j] = (Number(at_one) + over) / next;
    }
    logarithm = continued(m, powers, count, [&](int k) -> Number {
      return shifted(k + 1) / Float(k + 1) - shifted(k - 1) / Float(k - 1) +
             Number(at_one * (Float(1) / (k + 1) - Float(1) / (k - 1)));
    });
    if (x > 0 && x < 1) {
      sign = moments_up_to(m, x, count);
      for (std::size_t k = 0; k < sign.size(); ++k) sign[k] = sign[k] * Float(2) - plain[k];
    } else {
      for (const Number& moment : plain) sign.push_back(x > 0 ? moment : Number(-moment));
    }
  }
  plain_ = rounded(plain);
  logarithm_ = rounded(logarithm);
  sign_ = rounded(sign);
  inverse_ = rounded(inverse);
}

}  // namespace nipref::ref
