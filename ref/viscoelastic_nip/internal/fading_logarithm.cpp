#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/viscoelastic_nip/internal/fading_logarithm.hpp>

namespace nipref::ref {
namespace {

/// Digits by which a number of so many nats is larger than 1, not less than 0.
int digits_of_nats(double nats) { return static_cast<int>(std::ceil(nats / std::numbers::ln10)); }

/// (1/z) sum k!/z^k up to its smallest term, which is below e^{-|z|}; and, to the right of the imaginary axis,
/// what crossing the logarithm's cut adds: E1 on its own sheet is all of it only to the left.
ComplexFloat asymptotic_integral(const ComplexFloat& z, double nats) {
  const ComplexFloat inverse = ComplexFloat(1) / z;
  ComplexFloat term = inverse, sum = inverse;
  const Float least = exp(Float(-nats)) * abs(inverse);
  for (int k = 1; abs(term) > least; ++k) {
    term = term * inverse * k;
    sum = sum + term;
  }
  if (z.re > 0 && !z.is_real()) sum = sum + ComplexFloat(0, z.im > 0 ? pi() : -pi()) * exp(-z);
  return sum;
}

/// gamma + ln z + sum z^k/(k k!), whose terms are as large as e^{|z|}, times e^{-z}.
ComplexFloat integral_by_series(const ComplexFloat& z, double nats) {
  const auto size = static_cast<double>(abs(z)), right = static_cast<double>(z.re);
  const WorkingDigits working(digits_of_nats(nats + size - right + std::log(1 + size)) + 3);
  Float euler;
  mpfr_const_euler(raw(euler), MPFR_RNDN);
  ComplexFloat sum = ComplexFloat(std::move(euler)) + log(z.re > 0 ? z : -z);
  const Float least = exp(Float(right - nats)) / (1 + size);
  ComplexFloat power(1);  // z^k/k!
  for (int k = 1;; ++k) {
    power = power * z / Float(k);
    sum = sum + power / Float(k);
    if (k > size && abs(power) < least) break;
  }
  return exp(-z) * sum;
}

}  // namespace

ComplexFloat scaled_exponential_integral(const ComplexFloat& z) {
  const double nats = static_cast<double>(working_bits()) * std::numbers::ln2 + 4;
  if (static_cast<double>(abs(z)) > nats + 8) return asymptotic_integral(z, nats);
  if (z.is_real()) {
    Float result;
    mpfr_eint(raw(result), raw(z.re), MPFR_RNDN);
    return exp(-z.re) * result;
  }
  const ComplexFloat long_result = integral_by_series(z, nats);
  return {at_working_precision(long_result.re), at_working_precision(long_result.im)};
}

ComplexFloat fading_logarithm(const ComplexFloat& rate, const Float& x) {
  if (rate.re == 0) return x * log(abs(x)) - x;
  return (ComplexFloat(log(abs(x))) - scaled_exponential_integral(rate * x)) / rate;
}

}  // namespace nipref::ref
