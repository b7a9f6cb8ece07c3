#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/sheet/internal/transform.hpp>

namespace nipref::ref {
namespace {

/// Digits that the slope of an interpolation loses against its values, see SmoothKernel::slope().
constexpr int digits_of_slope = 4;

}  // namespace

Interval stretch_interval(const Exact& alpha, double nats) {
  const Interval finite_part = transform(Symbol::I6_alpha_part, alpha, nats);
  const mpfr_prec_t precision = finite_part.precision();
  return finite_part - Interval::pi(precision) / 4 * Interval(alpha, precision);
}

SheetKernels::SheetKernels(int digits, GrippedKernels from)
    : nats_(digits * std::numbers::ln10),
      far_(std::ceil(nats_ / 2.1) + 2),
      normal_(std::move(from.normal), digits + digits_of_slope, I1_shape),
      coupling_(std::move(from.coupling), digits + digits_of_slope, I3_shape),
      stretch_(std::move(from.stretch), digits + digits_of_slope, I3_integral_shape) {}

Float SheetKernels::normal(const Float& alpha) {
  const Float distance = abs(alpha);
  return distance < far_ ? normal_(distance) - log(distance) : Float(0);
}

Float SheetKernels::smooth_normal(const Float& alpha) {
  const Float distance = abs(alpha);
  return distance < far_ ? normal_(distance) : log(distance);
}

Float SheetKernels::smooth_normal_slope(const Float& alpha) {
  const Float distance = abs(alpha);
  const Float slope = distance < far_ ? normal_.slope(distance) : 1 / distance;
  return alpha < 0 ? -slope : slope;
}

Float SheetKernels::coupling(const Float& alpha) {
  const Float distance = abs(alpha);
  const Float value = distance < far_ ? coupling_(distance) : pi() / 4;
  return alpha < 0 ? -value : value;
}

Float SheetKernels::coupling_slope(const Float& alpha) {
  const Float distance = abs(alpha);
  return distance < far_ ? coupling_.slope(distance) : Float(0);
}

Float SheetKernels::stretch(const Float& alpha) {
  const Float distance = abs(alpha);
  return distance < far_ ? stretch_(distance) : stretch_(far_) - pi() / 4 * (distance - far_);
}

}  // namespace nipref::ref
