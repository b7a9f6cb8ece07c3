#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/roots.hpp>

namespace nipref::ref {
namespace {

constexpr long largest_index = 1'000'000'000;

/// sin phi and phi + (2n-1) pi for x in an interval.
struct Phase {
  Interval sine;
  Interval y;
};

Phase phase(const Interval& x, long n) {
  const Interval cosine = x / sinh(x);
  return {sqrt(-square(cosine) + 1), acos(cosine) + (2 * n - 1) * Interval::pi(x.precision())};
}

Interval residual(const Interval& x, long n) {
  const Phase p = phase(x, n);
  return cosh(x) * p.sine - p.y;
}

/// Re w of the root w = 2z, by Newton's method for sinh w + w = 0, which doubles the precision in each step. The error
/// of the first guess is below 1, and small for large n.
Float approximate(long n, mpfr_prec_t precision) {
  const double y = (2 * static_cast<double>(n) - 0.5) * std::numbers::pi;
  const double x = std::acosh(y);
  ComplexFloat w(x, y - x / std::sinh(x));
  const auto improve = [&](mpfr_prec_t bits) {
    const WorkingDigits working(digits_of(bits));
    w = {at_working_precision(w.re), at_working_precision(w.im)};
    const ComplexFloat up = exp(w), down = exp(-w);
    w = w - ((up - down) / Float(2) + w) / ((up + down) / Float(2) + ComplexFloat(1));
  };
  constexpr mpfr_prec_t first_precision = 128;
  constexpr int first_steps = 8;
  for (int step = 0; step < first_steps; ++step) improve(first_precision);
  for (mpfr_prec_t reached = first_precision - 32; reached < precision; reached *= 2)
    improve(std::min(2 * reached + 64, precision));
  Float result = zero_of_bits(precision);
  mpfr_set(raw(result), raw(w.re), MPFR_RNDN);
  return result;
}

/// A bracket of Re 2 z_n, with h_n < 0 at its left end and h_n > 0 at its right end.
Interval bracket(const Float& x, long n) {
  const WorkingDigits working(digits_of(bits_of(x)));
  const auto found = proven_bracket(x, ldexp(x, 2 - static_cast<int>(bits_of(x))), x / 4, 2, -1,
                                    [&](const Float& at) { return sign_of(residual(interval_of(at), n)); });
  if (!found) throw std::logic_error("Newton's iteration missed the root of the sheet");
  return *found;
}

}  // namespace

ComplexInterval sheet_root_interval(long n, mpfr_prec_t precision) {
  const Interval twice_z = bracket(approximate(n, precision + 64), n);
  return {twice_z / 2, phase(twice_z, n).y / 2};
}

void check_root_number(long n) {
  if (n < 1 || n > largest_index)
    throw data::BadInput("n", std::to_string(n), "must be a whole number from 1 to 1000000000");
}

SheetRoot sheet_root(long n, int digits) {
  check_root_number(n);
  const auto root = [&](double nats) { return sheet_root_interval(n, working_precision(nats, 1)); };
  return {enclose(digits, 0, [&](double nats) { return root(nats).re; }),
          enclose(digits, 0, [&](double nats) { return root(nats).im; })};
}

}  // namespace nipref::ref
