#include <algorithm>
#include <cmath>
#include <limits>

#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/catalogue/ulp.hpp>

namespace nipref::verify {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr mpfr_prec_t quotient_precision = 64;

/// |x - value| + error, rounded up.
ref::Real distance(double x, const ref::Estimate& truth) {
  ref::Real difference(quotient_precision);
  mpfr_d_sub(difference.get(), x, truth.value.get(), MPFR_RNDA);
  mpfr_abs(difference.get(), difference.get(), MPFR_RNDU);
  mpfr_add(difference.get(), difference.get(), truth.error.get(), MPFR_RNDU);
  return difference;
}

/// distance / unit rounded up, where 0/0 is 0.
double quotient(const ref::Real& distance, mpfr_srcptr unit) {
  if (mpfr_zero_p(distance.get())) return 0;
  ref::Real result(quotient_precision);
  mpfr_div(result.get(), distance.get(), unit, MPFR_RNDU);
  return std::fabs(mpfr_get_d(result.get(), MPFR_RNDU));
}

double quotient(const ref::Real& distance, double unit) {
  ref::Real divisor(quotient_precision);
  mpfr_set_d(divisor.get(), unit, MPFR_RNDN);
  return quotient(distance, divisor.get());
}

}  // namespace

Deviation deviation(double approximation, const ref::Estimate& truth, double envelope) {
  const double scale = std::max(std::fabs(truth.to_double()), envelope);
  if (!std::isfinite(approximation)) return {infinity, infinity, infinity, scale};
  const ref::Real error = distance(approximation, truth);
  return {quotient(error, ulp_of(scale)), quotient(error, truth.value.get()), quotient(error, scale), scale};
}

}  // namespace nipref::verify
