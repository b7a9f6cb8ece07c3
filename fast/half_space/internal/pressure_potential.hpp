#pragma once
#include <array>
#include <complex>
#include <cstddef>

namespace nipref::fast::internal {

/// C(z) = int_-1^1 (1 - t^2)/(t - z) dt = (1 - z^2) L(z) - 2 z, L(z) = ln((z - 1)/(z + 1)), for Im z > 0, or on the real
/// axis as the limit from there; or divided differences of both.
struct PressurePotential {
  std::complex<double> parabola, logarithm;
};

/// The first `count` of those at z[0], on z[0] and z[1], and on all three, of which z[0] and z[2] are farthest apart; where
/// two are wanted, z[2] is z[1]. More than one only where Im z > 0. Their errors are some roundings of themselves; of the
/// third, where it is divided by z[0] - z[2], some roundings of the second over that.
std::array<PressurePotential, 3> pressure_potentials(const std::array<std::complex<double>, 3>& z,
                                                     std::size_t count);

}  // namespace nipref::fast::internal
