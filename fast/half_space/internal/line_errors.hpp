#pragma once
#include <algorithm>
#include <cmath>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast::internal {

/// The relative error of compliances, couplings and critical speeds: six roundings of 2^-53. Of a response, numerator and
/// denominator have two words; each is rounded once, then come two quotients and, for two bodies, a sum. A critical speed
/// is a limit, which is rounded down and counts as two, times a factor with up to four.
inline constexpr double response_rounding = 6 * 0x1p-53;

/// f of the distances to both ends of a line. The errors of the distances are at most `distance_error`. As f increases
/// with both distances, its values at the ends of their ranges bound the error. f is 0 outside the contact; its own error
/// must be at most six roundings, such as those of two quotients, two powers and a product.
template <class Function>
Estimate between_ends(double ahead, double behind, double distance_error, const Function& f) {
  const auto changed = [&](double change) {
    const double a = ahead + change, b = behind + change;
    return a > 0 && b > 0 ? f(a, b) : 0.0;
  };
  const double value = changed(0);
  return {value,
          std::max(changed(distance_error) - value, value - changed(-distance_error)) + 6 * 0x1p-53 * value};
}

}  // namespace nipref::fast::internal
