#pragma once
#include <algorithm>
#include <cmath>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast::internal {

/// The relative error of compliances and couplings.
inline constexpr double response_rounding = 0x1.8p-51;

/// f of the distances to both ends of a line. The errors of the distances are at most `distance_error`. As f increases
/// with both distances, its values at the ends of their ranges bound the error. f is 0 outside the contact.
template <class Function>
Estimate between_ends(double ahead, double behind, double distance_error, const Function& f) {
  const auto changed = [&](double change) {
    const double a = ahead + change, b = behind + change;
    return a > 0 && b > 0 ? f(a, b) : 0.0;
  };
  const double value = changed(0);
  return {value, std::max(changed(distance_error) - value, value - changed(-distance_error)) +
                     response_rounding * value};
}

}  // namespace nipref::fast::internal
