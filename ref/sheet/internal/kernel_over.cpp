#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/sheet/internal/kernel_over.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

Enclosure kernel_at(PlainKernel kernel, const Exact& alpha, int digits) {
  if (kernel == PlainKernel::I1) return I1(alpha, digits);
  return kernel == PlainKernel::I3 ? I3(alpha, digits) : I6(alpha, Exact(0.0), digits);
}

}  // namespace

Interval kernel_over(PlainKernel kernel, const Interval& alpha, int residue_terms, int digits) {
  if (mpfi_has_zero(alpha.get()) > 0)
    throw data::BadInput("y", mpfi_get_d(alpha.get()), "must not be the place of a line load");
  if (residue_terms > 0) return plain_series(kernel, alpha, residue_terms);
  const Interval size = abs(alpha), slope = 2 * (size + 1L) / size;
  const Float middle = middle_of(alpha);
  const Enclosure value = kernel_at(kernel, to_exact(middle), digits);
  return interval_of(value.value, alpha.precision())
      .widened(interval_of(value.error))
      .widened(slope * distance_from(middle, alpha));
}

}  // namespace nipref::ref
