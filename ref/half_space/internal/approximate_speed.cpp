#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/ref/half_space/internal/barnett_lothe.hpp>
#include <nipref/ref/half_space/internal/lowest_point.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>
#include <nipref/ref/half_space/internal/valley.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

// What of the phase speeds is found in double, to start from. The only one of this room's files that includes
// Eigen for it.

namespace nipref::ref {
namespace {

using Small = Eigen::Matrix3d;

/// q + s (r + r^T) + s^2 t at rest.
struct AcousticPencil {
  Small q, r, t;

  [[nodiscard]] Small at(double s) const { return q + s * (r + r.transpose()) + s * s * t; }
  /// Half the derivative of the smallest eigenvalue, x.((r + r^T) + 2 s t).x/2, x its eigenvector.
  [[nodiscard]] double half_slope(double s) const {
    const Eigen::SelfAdjointEigenSolver<Small> solver(at(s));
    const Eigen::Vector3d x = solver.eigenvectors().col(0);
    return x.dot(r * x) + s * x.dot(t * x);
  }
};

AcousticPencil pencil_of(const AcousticMatrices& x) {
  const auto small = [](const IntervalMatrix& entries) {
    Small result;
    for (std::size_t k = 0; k < 9; ++k) {
      result(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3)) =
          mpfi_get_d(entries(k / 3, k % 3).real.get());
    }
    return result;
  };
  return {small(x.q), small(x.r), small(x.t)};
}

Valley scan(const AcousticPencil& pencil) {
  constexpr int steps = 360;
  const auto s_at = [](int k) { return std::tan(std::numbers::pi * (k / double{steps} - 0.5)); };
  Valley best{0, 0, INFINITY};
  Eigen::SelfAdjointEigenSolver<Small> solver;
  for (int k = 2; k <= steps - 2; ++k) {
    solver.computeDirect(pencil.at(s_at(k)), Eigen::EigenvaluesOnly);
    const double eigenvalue = solver.eigenvalues()(0);
    if (eigenvalue < best.eigenvalue) best = {s_at(k - 1), s_at(k + 1), eigenvalue};
  }
  return best;
}

double determinant(const AcousticPencil& pencil, double inertia) {
  const Small q = pencil.q - inertia * Small::Identity();
  const auto impedance = barnett_lothe_impedance<Eigen::MatrixXd>(q, pencil.r, pencil.t, 1e-7, 60);
  if (!impedance) return -1;
  Eigen::Matrix3cd complex;
  complex.real() = impedance->re;
  complex.imag() = impedance->im;
  return complex.determinant().real();
}

}  // namespace

Valley lowest_valley(const AcousticMatrices& matrices) { return scan(pencil_of(matrices)); }

double approximate_critical_inertia(const ExactStiffness& solid, const SurfaceDirection& psi) {
  const AcousticPencil pencil = pencil_of(acoustic_matrices(solid, psi, Interval(64)));
  const Valley valley = scan(pencil);
  const double s =
      lowest_point([&](double at) { return pencil.half_slope(at); }, valley.left, valley.right, 40);
  const double limit =
      Eigen::SelfAdjointEigenSolver<Small>(pencil.at(s), Eigen::EigenvaluesOnly).eigenvalues()(0);
  const auto f = [&](double w) { return determinant(pencil, limit * (1 - w * w)); };
  constexpr double nearest = 1e-4;
  if (!(f(nearest) < 0)) return limit;
  const auto w = bracketed_root(f, 1.0, nearest, 1e-13);
  if (!w) refuse_proof(psi, surface_wave);
  return limit * (1 - *w * *w);
}

}  // namespace nipref::ref
