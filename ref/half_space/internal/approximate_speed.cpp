#include <cmath>
#include <numbers>

#include <nipref/ref/half_space/internal/acoustic_pencil.hpp>
#include <nipref/ref/half_space/internal/barnett_lothe.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

// Approximations of the phase speeds in double, from which the proofs start.

namespace nipref::ref {
namespace {

using Square = DenseMatrix<double>;
using Pencil = AcousticPencil<double>;

Valley scan(const Pencil& pencil) {
  constexpr int steps = 360;
  const auto s_at = [](int k) { return std::tan(std::numbers::pi * (k / double{steps} - 0.5)); };
  Valley best{0, 0, HUGE_VAL};
  for (int k = 2; k <= steps - 2; ++k) {
    const double eigenvalue = pencil.lowest_value(s_at(k));
    if (eigenvalue < best.eigenvalue) best = {s_at(k - 1), s_at(k + 1), eigenvalue};
  }
  return best;
}

double determinant(const Pencil& pencil, double inertia) {
  const Square q = pencil.q - inertia * Square::Identity(3, 3);
  const auto impedance = barnett_lothe_impedance(q, pencil.r, pencil.t, 1e-7, 60);
  if (!impedance) return -1;
  Eigen::Matrix3cd hermitian;
  hermitian.real() = impedance->re;
  hermitian.imag() = impedance->im;
  return hermitian.determinant().real();
}

}  // namespace

Valley lowest_valley(const AcousticMatrices& matrices) { return scan(pencil_of<double>(matrices)); }

double approximate_critical_inertia(const ExactStiffness& solid, const SurfaceDirection& psi) {
  const Pencil pencil = pencil_of<double>(acoustic_matrices(solid, psi, Interval(64)));
  const Valley valley = scan(pencil);
  const double limit = pencil.lowest_value(
      lowest_point([&](double at) { return pencil.half_slope(at); }, valley.left, valley.right, 40));
  const auto f = [&](double w) { return determinant(pencil, limit * (1 - w * w)); };
  constexpr double nearest = 1e-4;
  if (!(f(nearest) < 0)) return limit;
  const auto w = bracketed_root(f, 1.0, nearest, 1e-13);
  if (!w) refuse_proof(psi, surface_wave);
  return limit * (1 - *w * *w);
}

}  // namespace nipref::ref
