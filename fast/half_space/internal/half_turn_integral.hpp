#pragma once
#include <array>
#include <cstddef>
#include <numbers>

#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/number/internal/adaptive_panels.hpp>

namespace nipref::fast {

/// int f dpsi over half a turn for a vector f(Direction) of this period. The errors of each component are the rounding of
/// the integral of |f| and that of the directions, which counts where f varies. If f is not piecewise analytic, the
/// estimates include the truncation error; see adapt_panels.
template <std::size_t count, typename Integrand>
std::array<Estimate, count> half_turn_integral(Integrand&& integrand) {
  constexpr double quarter = std::numbers::pi / 2;
  const auto of_angle = [&](double psi) { return integrand(Direction::of_angle(psi)); };
  return internal::adapt_panels<count>(of_angle, -quarter, quarter).integral;
}

}  // namespace nipref::fast
