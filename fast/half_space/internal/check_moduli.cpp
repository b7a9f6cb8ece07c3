#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/internal/check_moduli.hpp>

namespace nipref::fast::internal {

void check_moduli(const data::Stiffness& solid) {
  using Voigt = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const Voigt matrix = Eigen::Map<const Voigt>(solid.voigt.front().data());
  const auto values =
      Eigen::SelfAdjointEigenSolver<Voigt>(matrix, Eigen::EigenvaluesOnly).eigenvalues();  // they ascend
  if (values[5] <= farthest_moduli * values[0]) return;
  throw data::BadInput(
      "solid", "(as given)",
      fmt::format("must have moduli nearer to each other: no eigenvalue of its matrix more than "
                  "{:g} times the smallest",
                  farthest_moduli));
}

}  // namespace nipref::fast::internal
