#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

ResidueCoefficients residue_coefficients(PlainKernel kernel, int n, int digits) {
  check_root_number(n);
  const auto coefficient = [&](auto part) {
    return enclose(digits, 0, [&](double nats) {
      return part(plain_coefficient(kernel, *sheet_pole(n, working_precision(nats, n))));
    });
  };
  // Of a sine transform the term is Re C e^(i z x), of a cosine transform -Im C e^(i z x).
  if (is_odd(kernel)) {
    return {coefficient([](const ComplexInterval& c) { return -c.im; }),
            coefficient([](const ComplexInterval& c) { return c.re; })};
  }
  return {coefficient([](const ComplexInterval& c) { return -c.re; }),
          coefficient([](const ComplexInterval& c) { return -c.im; })};
}

Interval plain_series(PlainKernel kernel, const Interval& alpha, int terms) {
  check_residue_terms(terms);
  const mpfr_prec_t precision = alpha.precision();
  const bool odd = is_odd(kernel), behind = mpfr_sgn(alpha.upper()) < 0;
  const Interval a = behind ? -alpha : alpha, pi = Interval::pi(precision);
  Interval sum(precision), rest(precision);
  for (int n = 1; n <= terms; ++n) {
    if (is_negligible(n, a, precision, rest)) {
      sum = sum.widened(rest);
      break;
    }
    const auto pole = sheet_pole(n, precision + 32);
    const Interval size = exp(-(a * pole->z.im)), angle = a * pole->z.re;
    const ComplexInterval wave = plain_coefficient(kernel, *pole) * ComplexInterval{cos(angle), sin(angle)};
    sum = sum + size * (odd ? wave.re : wave.im);
  }
  if (!odd) {
    const Interval series = -(pi * sum);
    return kernel == PlainKernel::I1 ? series : series - pi * a / 4;
  }
  const Interval value = pi / 4 + pi * sum;
  return behind ? -value : value;
}

}  // namespace nipref::ref
