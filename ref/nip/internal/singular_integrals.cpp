#include <cmath>

#include <nipref/ref/nip/internal/singular_integrals.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {
namespace {

using Sequence = std::vector<ComplexFloat>;

/// t^m
ComplexFloat power(const Float& t, const ComplexFloat& m) {
  return t == 0 ? ComplexFloat() : exp(m * log(t));
}

/// The integrals of t^m T_k f from those of t^(m+j) f, j < 3, and of (t^{m+1} P_k)' f.
template <class OfDerivative>
Sequence continued(const ComplexFloat& m, const ComplexFloat (&powers)[3], int count,
                   const OfDerivative& of_derivative) {
  Sequence result{powers[0], powers[1] * Float(2) - powers[0],
                  powers[2] * Float(8) - powers[1] * Float(8) + powers[0]};
  const ComplexFloat one(1), next = m + one;
  for (int k = 2; k + 1 < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const ComplexFloat before = one - next / Float(k - 1), after = one + next / Float(k + 1);
    result.push_back((of_derivative(k) - result[at] * Float(2) - before * result[at - 1]) / after);
  }
  return result;
}

/// P_k at t from the values of all T_k there.
Float end_polynomial(const std::vector<Float>& chebyshev, int k) {
  const auto at = static_cast<std::size_t>(k);
  return chebyshev[at + 1] / (k + 1) - chebyshev[at - 1] / (k - 1);
}

Sequence plain_moments(const ComplexFloat& m, int count) {
  const ComplexFloat one(1),
      powers[]{one / (m + one), one / (m + ComplexFloat(2)), one / (m + ComplexFloat(3))};
  return continued(m, powers, count,
                   [](int k) { return ComplexFloat(Float(1) / (k + 1) - Float(1) / (k - 1)); });
}

/// int_0^x t^m T_k
Sequence moments_up_to(const ComplexFloat& m, const Float& x, int count) {
  std::vector<Float> chebyshev(static_cast<std::size_t>(count) + 1);
  chebyshev_values(2 * x - 1, chebyshev);
  const ComplexFloat end = power(x, m) * x;
  const ComplexFloat powers[]{end / (m + ComplexFloat(1)), end * x / (m + ComplexFloat(2)),
                              end * (x * x) / (m + ComplexFloat(3))};
  return continued(m, powers, count, [&](int k) { return ComplexFloat(end * end_polynomial(chebyshev, k)); });
}

/// sum_{j >= 0} x^{j+1}/(j + 1 + shift), |x| <= 3/4
ComplexFloat fading_sum(const Float& x, const ComplexFloat& shift) {
  const Float least = ldexp(Float(1), -working_bits() - 4);
  ComplexFloat sum;
  Float term = x;
  for (int j = 1; abs(term) > least; ++j, term *= x)
    sum = sum + ComplexFloat(term) / (shift + ComplexFloat(j));
  return sum;
}

/// int_0^1 t^m/(x - t) dt, a principal value, -1/2 <= x <= 3/2, x not 0 or 1.
ComplexFloat inverse_integral(const ComplexFloat& m, const Float& x) {
  if (abs(m) == 0) return Float(log(abs(x / (x - 1))));
  if (x < Float(1) / 2) {
    // int_0^inf t^{m-1}/(t - x) dt is -pi x^{m-1} cot(pi m) for x > 0, pi |x|^{m-1}/sin(pi m) for x < 0. The part
    // beyond 1 is subtracted.
    const ComplexFloat angle = m * pi(), up = x > 0 ? cos(angle) : ComplexFloat(1);
    const ComplexFloat whole = up / sin(angle) * pi() * power(Float(abs(x)), m);
    return whole + fading_sum(x, -m) - ComplexFloat(1) / m;
  }
  // From 0 to `border` in powers of t/x, from there to 1 in powers of 1 - t.
  const Float border = x < 1 ? Float(x / 2) : Float(1) / 2, rest = 1 - border, beyond = x - 1;
  ComplexFloat sum = power(border, m) * fading_sum(border / x, m);
  const Float least = ldexp(Float(1), -working_bits() - 4);
  // int_0^rest y^n/(y + beyond) dy, and the coefficient of y^n in (1 - y)^m.
  Float integral = log(abs((rest + beyond) / beyond)), power_of_rest = rest;
  ComplexFloat coefficient(1);
  for (int n = 0; power_of_rest > least; ++n) {
    sum = sum + coefficient * integral;
    integral = power_of_rest / (n + 1) - beyond * integral;
    power_of_rest *= rest;
    coefficient = coefficient * (ComplexFloat(n) - m) / Float(n + 1);
  }
  return sum;
}

/// Digits that the recurrence for 1/(x - t) loses.
int lost_digits(const Float& x, int count) {
  const double size = std::fabs(2 * static_cast<double>(x) - 1);
  return size > 1 ? static_cast<int>(2 * count * std::log10(size + std::sqrt(size * size - 1))) + 2 : 0;
}

/// A row for each k with the real and the imaginary part, rounded to the working precision.
Matrix rows_of(const Sequence& sequence, int count) {
  Matrix rows(count, 2);
  for (int k = 0; k < count; ++k) {
    const auto& [re, im] = sequence[static_cast<std::size_t>(k)];
    rows(k, 0) = at_working_precision(re);
    rows(k, 1) = at_working_precision(im);
  }
  return rows;
}

}  // namespace

Matrix plain_integrals(const ComplexFloat& m, int count) { return rows_of(plain_moments(m, count), count); }

SingularIntegrals singular_integrals(const ComplexFloat& m, const Float& x, int count) {
  Sequence plain, logarithm, sign, inverse;
  {
    const WorkingDigits more(digits_of(working_bits()) + lost_digits(x, count) + 4);
    plain = plain_moments(m, count + 1);
    const bool at_border = x == 0 || x == 1;
    const Float turn = 2 * (2 * x - 1);
    inverse.push_back(at_border ? ComplexFloat() : inverse_integral(m, x));
    inverse.push_back((inverse[0] * x - plain[0]) * Float(2) - inverse[0]);
    for (std::size_t k = 1; k <= static_cast<std::size_t>(count); ++k)
      inverse.push_back(inverse[k] * turn - inverse[k - 1] - plain[k] * Float(4));
    // The integral of t^{m+1} T_k/(x - t).
    const auto shifted = [&](int k) -> ComplexFloat {
      return inverse[static_cast<std::size_t>(k)] * x - plain[static_cast<std::size_t>(k)];
    };
    const Float at_one = x == 1 ? Float(0) : log(abs(x - 1));
    ComplexFloat over = inverse[0], powers[3];
    for (int j = 0; j < 3; ++j) {
      const ComplexFloat next = m + ComplexFloat(j + 1);
      over = over * x - ComplexFloat(1) / next;
      powers[j] = (ComplexFloat(at_one) + over) / next;
    }
    logarithm = continued(m, powers, count, [&](int k) -> ComplexFloat {
      return shifted(k + 1) / Float(k + 1) - shifted(k - 1) / Float(k - 1) +
             ComplexFloat(at_one * (Float(1) / (k + 1) - Float(1) / (k - 1)));
    });
    if (x > 0 && x < 1) {
      sign = moments_up_to(m, x, count);
      for (std::size_t k = 0; k < sign.size(); ++k) sign[k] = sign[k] * Float(2) - plain[k];
    } else {
      for (const ComplexFloat& moment : plain) sign.push_back(x > 0 ? moment : -moment);
    }
  }
  return {rows_of(plain, count), rows_of(logarithm, count), rows_of(sign, count), rows_of(inverse, count)};
}

}  // namespace nipref::ref
