#include <Eigen/Eigenvalues>
#include <cmath>
#include <utility>

#include <nipref/fast/half_space/response.hpp>

namespace nipref::fast {

PressureWave::PressureWave(const LineResponse& y, const std::array<Vector, 3>& matrix) : PressureWave(y) {
  Eigen::Matrix3cd g;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) g(static_cast<int>(i), static_cast<int>(k)) = matrix[i][k];
  const Eigen::Vector3cd values = Eigen::ComplexSchur<Eigen::Matrix3cd>(g, false).matrixT().diagonal();
  decays = {values[0], values[1], values[2]};
  // The decays farthest apart become first and last, as a second divided difference is divided by their distance.
  const auto apart = [&](std::size_t i, std::size_t k) { return std::abs(decays[i] - decays[k]); };
  if (apart(0, 1) > apart(0, 2)) std::swap(decays[1], decays[2]);
  if (apart(1, 2) > apart(0, 2)) std::swap(decays[0], decays[1]);
  count = 3;
  for (std::size_t j = 0; j + 1 < count; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      shares[j + 1][i] = -decays[j] * shares[j][i];
      for (std::size_t k = 0; k < 3; ++k) shares[j + 1][i] += matrix[i][k] * shares[j][k];
    }
  }
}

}  // namespace nipref::fast
