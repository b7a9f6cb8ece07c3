#include <algorithm>
#include <cmath>
#include <limits>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/ulp.hpp>

namespace nipref::verify {

double ulp_of(double scale) {
  using Limits = std::numeric_limits<double>;
  constexpr int lowest_exponent = Limits::min_exponent - Limits::digits;  // -1074
  if (!std::isfinite(scale)) throw data::BadInput("scale", scale, "must be a finite number");
  if (scale == 0) return Limits::denorm_min();
  const int exponent = std::ilogb(scale) - (Limits::digits - 1);
  return std::ldexp(1.0, std::max(exponent, lowest_exponent));
}

}  // namespace nipref::verify
