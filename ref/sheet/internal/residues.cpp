#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {
namespace {

/// The N for which the truncation error is below e^{-nats}/4.
long terms_needed(double x, double nats) {
  const double needed = (nats + std::log(4.0 * 7)) / (std::numbers::pi * x) - 0.5;
  return std::max(0L, static_cast<long>(std::ceil(needed)));
}

/// The number n of a root and the precision.
using PoleKey = std::pair<long, mpfr_prec_t>;

SheetPole make_pole(const PoleKey& key) {
  const ComplexInterval z = sheet_root_interval(key.first, key.second);
  return {z, inverse({cosh(z.re) * cos(z.im), sinh(z.re) * sin(z.im)})};
}

std::size_t size_of_pole(const SheetPole& pole) {
  return static_cast<std::size_t>(8 * pole.z.re.precision()) / CHAR_BIT;
}

/// sign z^p/cosh^q z.
struct PowersOfPole {
  int sign, p, q;

  [[nodiscard]] ComplexInterval at(const SheetPole& pole) const {
    const mpfr_prec_t precision = pole.z.re.precision();
    ComplexInterval result{Interval(static_cast<long>(sign), precision), Interval(precision)};
    for (int k = 0; k < q; ++k) result = result * pole.sech;
    if (p > 0) return result * pole.z;
    return p < 0 ? result * inverse(pole.z) : result;
  }
};

/// Twice the residue, 2 c_n.
ComplexInterval twice_residue(Symbol symbol, const SheetPole& pole) {
  // In the order of Symbol.
  constexpr std::array<PowersOfPole, 7> all{
      {{1, 1, 4}, {1, 0, 2}, {-1, 0, 3}, {1, 0, 1}, {1, -1, 2}, {1, -1, 1}, {-1, 1, 3}}};
  return all[static_cast<std::size_t>(symbol)].at(pole);
}

/// 2 c_n e^{i x z_n}
ComplexInterval term(Symbol symbol, const SheetPole& pole, const Exact& magnitude) {
  const Interval x(magnitude, pole.z.re.precision());
  return exp(ComplexInterval{-(x * pole.z.im), x * pole.z.re}) * twice_residue(symbol, pole);
}

/// The factor of a wave e^{i x z} in the memory: 1/(rate - i z) ahead of the load, 1/(rate + i z) behind it.
ComplexInterval fading(const Interval& exact_rate, bool to_come, const ComplexInterval& z) {
  Interval rate(z.re.precision());
  mpfi_set(rate.get(), exact_rate.get());
  return to_come ? inverse({rate + z.im, -z.re}) : inverse({rate - z.im, z.re});
}

/// The bits for a term of the size e^{-decay Im z_n} whose relative error is frequency |z_n| times that of z_n.
mpfr_prec_t bits_at_root(long n, double decay, double frequency, double nats) {
  const double imaginary = slowest_decay + static_cast<double>(n - 1) * std::numbers::pi;
  return working_precision(std::max(nats - decay * imaginary, 1.0), frequency * (imaginary + 3));
}

/// 1/(e^{-2 pi i z/h} - 1).
ComplexInterval image_factor(const ComplexInterval& z, double step) {
  const mpfr_prec_t precision = z.re.precision();
  const Interval turns = 2 * Interval::pi(precision) / Interval(step, precision);
  const ComplexInterval grown = exp(ComplexInterval{turns * z.im, -(turns * z.re)});
  return inverse({grown.re - 1, grown.im});
}

/// sum over y = (2k + 1) 2 pi/3 < 4 pi lines of (8 pi/3) cosh(x y)/(y (e^{2 pi y/h} - 1)).
Interval passed_poles_of_tanh(const Exact& exact_x, double step, long lines, mpfr_prec_t precision) {
  const Interval x(exact_x, precision);
  const Interval two_pi = 2 * Interval::pi(precision);
  Interval sum(precision);
  for (long k = 1; k < 6 * lines; k += 2) {
    const Interval y = k * two_pi / 3;
    sum = sum + 4 * cosh(x * y) / (k * expm1(two_pi * y / Interval(step, precision)));
  }
  return sum;
}

/// -2 pi Im s for an even symbol, 2 pi Re s for an odd one, where s = sum c_n f_n e^{i x z_n} with factors |f_n| <= 1.
template <class Factor>
Interval sum_over_roots(Symbol symbol, const Exact& exact_x, double nats, Factor with_factor) {
  const double x = exact_x.approximate();
  const bool odd = is_odd(symbol);
  const long terms = terms_needed(x, nats);
  Interval sum(mpfr_prec_t{64});
  for (long n = terms; n >= 1; --n) {
    const auto root = sheet_pole(n, term_precision(n, x, nats));
    const ComplexInterval next = with_factor(term(symbol, *root, exact_x), root->z);
    sum = sum + (odd ? next.re : next.im);
  }
  const Interval series = Interval::pi(sum.precision()) * (odd ? sum : -sum);
  const Interval tail =
      series_remainder * exp(-((2 * terms + 1) * (Interval::pi(64) * Interval(exact_x, 64)) / 2));
  return series.widened(tail);
}

}  // namespace

ComplexInterval plain_coefficient(PlainKernel kernel, const SheetPole& pole) {
  // z/cosh^4 z + 1/(z cosh^2 z) = 1/z at the roots.
  if (kernel == PlainKernel::I6_alpha_part) return inverse(pole.z);
  const ComplexInterval coefficient = twice_residue(kernel, pole);
  return kernel == PlainKernel::I6_eta_part ? -coefficient : coefficient;
}

void check_residue_terms(int terms) {
  if (terms >= 1 && terms <= most_residue_terms) return;
  throw data::BadInput("terms", std::to_string(terms),
                       "must be from 1 to " + std::to_string(most_residue_terms));
}

bool is_negligible(int n, const Interval& x, mpfr_prec_t precision, Interval& bound) {
  bound = 1100 * exp(-((2L * n - 1) * (Interval::pi(x.precision()) * x) / 2));
  return mpfr_zero_p(bound.upper()) != 0 || mpfr_get_exp(bound.upper()) < -precision;
}

std::shared_ptr<const SheetPole> sheet_pole(long n, mpfr_prec_t precision) {
  static Cache<PoleKey, SheetPole> kept(make_pole, size_of_pole);
  const auto bits = static_cast<unsigned long>(precision);
  const unsigned long grain = std::bit_floor(bits) / 4;
  return kept.at({n, static_cast<mpfr_prec_t>((bits + grain - 1) / grain * grain)});
}

mpfr_prec_t term_precision(long n, double x, double nats) { return bits_at_root(n, x, x, nats); }

// Measured: the trapezoidal rule takes the time of about nats^2/10^4 terms, or of nats/25 if it passes poles.
bool residues_are_cheaper(double x, double nats) {
  return x >= 1 && static_cast<double>(terms_needed(x, nats)) <= std::min(1e-4 * nats, 0.04) * nats;
}

Interval residue_series(Symbol symbol, const Exact& x, double nats) {
  const Interval series = sum_over_roots(
      symbol, x, nats, [](const ComplexInterval& term, const ComplexInterval&) { return term; });
  if (!is_odd(symbol)) return series;
  return Interval::pi(std::max(series.precision(), working_precision(nats, 1))) / 4 + series;
}

Interval passed_poles(Symbol symbol, const Exact& exact_x, double step, long lines, double nats) {
  const double x = exact_x.approximate();
  const double turns = 2 * std::numbers::pi / step;
  const bool odd = is_odd(symbol);
  Interval sum(mpfr_prec_t{64});
  for (long n = 4 * lines; n >= 1; --n) {
    const auto root = sheet_pole(n, bits_at_root(n, turns - x, turns + x, nats));
    const ComplexInterval w = Interval(exact_x, root->z.re.precision()) * root->z;
    sum = sum + ((odd ? sin(w) : cos(w)) * image_factor(root->z, step) * twice_residue(symbol, *root)).im;
  }
  const Interval roots = 2 * Interval::pi(sum.precision()) * sum;
  if (symbol != Symbol::I1) return roots;
  return roots + passed_poles_of_tanh(exact_x, step, lines, working_precision(nats, turns + x));
}

Interval fading_residue_series(Symbol symbol, const Exact& x, const Interval& rate, double nats) {
  const bool to_come = x.sign() > 0;
  const Interval series = sum_over_roots(
      symbol, x.magnitude(), nats,
      [&](const ComplexInterval& term, const ComplexInterval& z) { return term * fading(rate, to_come, z); });
  return !to_come && is_odd(symbol) ? -series : series;
}

ResidueCoefficients residue_coefficients(PlainKernel kernel, int n, int digits) {
  check_root_number(n);
  const auto coefficient = [&](auto part) {
    return enclose(digits, 0, [&](double nats) {
      return part(plain_coefficient(kernel, *sheet_pole(n, working_precision(nats, n))));
    });
  };
  // The term of a sine transform is Re C e^(i z x), the term of a cosine transform is -Im C e^(i z x).
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
