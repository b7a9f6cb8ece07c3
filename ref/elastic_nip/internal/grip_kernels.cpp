#include <nipref/ref/elastic_nip/internal/grip_kernels.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/transform.hpp>

namespace nipref::ref {
namespace {

/// What I6 is of alpha beside I1, see I6_eta_interval.
Interval stretch_interval(const Exact& alpha, double nats) {
  const Interval finite_part = transform(Symbol::I6_alpha, alpha, nats);
  const mpfr_prec_t precision = finite_part.precision();
  return finite_part - Interval::pi(precision) / 4 * Interval(alpha, precision);
}

}  // namespace

GripKernels::GripKernels(int digits)
    : normal(I1_interval, digits, I1_shape),
      coupling(I3_interval, digits, I3_shape),
      stretch(stretch_interval, digits, I3_integral_shape) {}

}  // namespace nipref::ref
