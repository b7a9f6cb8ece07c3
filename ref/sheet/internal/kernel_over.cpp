#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/sheet/internal/kernel_over.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {
namespace {

Enclosure kernel_at(SheetKernel kernel, const Exact& alpha, int digits) {
  if (kernel == SheetKernel::I1) return I1(alpha, digits);
  return kernel == SheetKernel::I3 ? I3(alpha, digits) : I6(alpha, Exact(0.0), digits);
}

PlainKernel plain(SheetKernel kernel) {
  if (kernel == SheetKernel::I1) return PlainKernel::I1;
  return kernel == SheetKernel::I3 ? PlainKernel::I3 : PlainKernel::I6_alpha_part;
}

}  // namespace

Interval kernel_over(SheetKernel kernel, const Interval& alpha, int residue_terms, int digits) {
  if (mpfi_has_zero(alpha.get()) > 0)
    throw data::BadInput("y", mpfi_get_d(alpha.get()), "must not be the place of a line load");
  if (residue_terms > 0) return plain_series(plain(kernel), alpha, residue_terms);
  const mpfr_prec_t precision = alpha.precision();
  Float middle = zero_of_bits(precision), nearest = zero_of_bits(precision),
        farthest = zero_of_bits(precision);
  mpfi_mid(raw(middle), alpha.get());
  mpfi_mig(raw(nearest), alpha.get());
  mpfi_mag(raw(farthest), alpha.get());
  const Enclosure value = kernel_at(kernel, to_exact(middle), digits);
  Float radius = zero_of_bits(precision);
  mpfi_diam_abs(raw(radius), alpha.get());
  const Interval far = interval_of(farthest, precision),
                 slope = 2 * (far + 1L) / interval_of(nearest, precision);
  return interval_of(value.value, precision)
      .widened(interval_of(value.error, precision))
      .widened(slope * interval_of(radius, precision));
}

}  // namespace nipref::ref
