#include <algorithm>

#include <nipref/ref/number/internal/panel_quadrature.hpp>

namespace nipref::ref {
namespace {

Interval rational(const mpq_class& value, mpfr_prec_t precision) { return {Exact(value), precision}; }

/// The least k >= 0 with |x| <= 2^k.
unsigned long bits_above(const mpq_class& x) {
  if (abs(x) <= 1) return 0;
  const mpz_class whole = abs(x.get_num()) / x.get_den();
  return mpz_sizeinbase(whole.get_mpz_t(), 2);
}

mpq_class halved(mpq_class x, unsigned long times) {
  mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), times);
  return x;
}

/// int_0^1 e^{-y s} ds = sum_n (-y)^n/(n+1)! for |y| <= 1/2, where the terms from the N-th on, N > last, add
/// up to at most 2 |y|^N/(N+1)! <= 2^-last/last!.
ComplexInterval one_panel(const ComplexInterval& minus_y, mpfr_prec_t bits) {
  // `size` is a lower bound of log2(2^last last!).
  long last = 0;
  for (mpfr_prec_t size = 0; size < bits; size += static_cast<mpfr_prec_t>(bits_above(last))) ++last;
  ComplexInterval sum{Interval(1L, bits), Interval(0L, bits)};
  for (long n = last; n >= 1; --n) {
    sum = sum * minus_y;
    sum.real = sum.real / (n + 1) + 1;
    sum.imag = sum.imag / (n + 1);
  }
  Interval remainder(1L, bits);
  mpfi_div_2ui(remainder.get(), remainder.get(), static_cast<unsigned long>(bits));
  return {sum.real.widened(remainder), sum.imag.widened(remainder)};
}

}  // namespace

ComplexInterval wave(const mpq_class& decay, const mpq_class& angle, mpfr_prec_t bits) {
  const auto extra = static_cast<mpfr_prec_t>(std::max(bits_above(decay), bits_above(angle)));
  const Interval size = exp(-rational(decay, bits + extra));
  const Interval phase = rational(angle, bits + extra);
  Interval cosine(bits + extra);
  Interval sine(bits + extra);
  mpfi_cos(cosine.get(), phase.get());
  mpfi_sin(sine.get(), phase.get());
  return {size * cosine, size * sine};
}

ComplexInterval damped_wave_integral(const mpq_class& rate, const mpq_class& frequency,
                                     const mpq_class& length, mpfr_prec_t bits) {
  const mpq_class decay = rate * length;
  const mpq_class angle = frequency * length;
  const unsigned long doublings = bits_above(decay + abs(angle)) + 1;
  // Each product of complex intervals may widen them by half a bit.
  const mpfr_prec_t precision = bits + static_cast<mpfr_prec_t>(2 * doublings) + 64;
  const ComplexInterval minus_y{rational(-halved(decay, doublings), precision),
                                rational(halved(angle, doublings), precision)};
  ComplexInterval sum = one_panel(minus_y, precision);
  for (unsigned long left = doublings; left >= 1; --left) {
    ComplexInterval q = wave(halved(decay, left), halved(angle, left), precision);
    q.real = q.real + 1;
    sum = sum * q;
  }
  const Interval panel = rational(halved(length, doublings), precision);
  return {sum.real * panel, sum.imag * panel};
}

}  // namespace nipref::ref
