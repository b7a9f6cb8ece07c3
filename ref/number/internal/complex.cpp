#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

ComplexInterval exp(const ComplexInterval& x) {
  const Interval size = exp(x.re);
  if (mpfi_is_zero(x.im.get()) > 0) return {size, x.im};
  // Those of the middle of the angle, which change no more than it does, take half the time of MPFI's.
  const mpfr_prec_t bits = x.im.precision();
  Float angle = zero_of_bits(bits), cosine = angle, sine = angle;
  mpfi_mid(raw(angle), x.im.get());
  mpfr_sin_cos(raw(sine), raw(cosine), raw(angle), MPFR_RNDN);
  const Interval off = magnitude_of(x.im - interval_of(angle));
  const auto around = [&](Float& below) {
    Float above = below;
    mpfr_nextbelow(raw(below));
    mpfr_nextabove(raw(above));
    return Interval(below, above, bits).widened(off);
  };
  return {size * around(cosine), size * around(sine)};
}

ComplexInterval rounded(const ComplexInterval& x, mpfr_prec_t bits) {
  ComplexInterval result{Interval(bits), Interval(bits)};
  mpfi_set(result.re.get(), x.re.get());
  mpfi_set(result.im.get(), x.im.get());
  return result;
}

}  // namespace nipref::ref
