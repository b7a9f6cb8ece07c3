#pragma once
#include <array>
#include <complex>
#include <cstddef>

namespace nipref::fast::internal {

/// C(z) = int_-1^1 (1 - t^2)/(t - z) dt = (1 - z^2) L(z) - 2 z and L(z) = ln((z - 1)/(z + 1)), for Im z > 0, or on the
/// real axis as the limit from Im z > 0; or divided differences of C and L.
struct PressurePotential {
  std::complex<double> parabola, logarithm;
};

/// The first `count` of: the values at z[0], the divided differences over z[0] and z[1], and those over all three, of which
/// z[0] and z[2] must be farthest apart. If count is 2, z[2] must be z[1]; if it is above 1, Im z > 0. The errors are a few
/// roundings of each result; that of the third, if z[0] != z[2], is a few roundings of the second over z[0] - z[2].
std::array<PressurePotential, 3> pressure_potentials(const std::array<std::complex<double>, 3>& z,
                                                     std::size_t count);

}  // namespace nipref::fast::internal
