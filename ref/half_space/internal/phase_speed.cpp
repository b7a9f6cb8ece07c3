#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/internal/interval_float.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

namespace nipref::ref {
namespace {

using Small = Eigen::Matrix3d;

/// q + s (r + r^T) + s^2 t at rest, in floating point.
template <class AnyMatrix>
struct AcousticPencil {
  AnyMatrix q, r, t;

  template <class Scalar>
  [[nodiscard]] AnyMatrix at(const Scalar& s) const {
    return q + s * (r + r.transpose()) + s * s * t;
  }
};

AcousticPencil<Matrix> multiprecision_pencil(const AcousticMatrices& x) {
  return {middle(x.q).re, middle(x.r).re, middle(x.t).re};
}

AcousticPencil<Small> double_pencil(const AcousticMatrices& x) {
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

AcousticMatrices at_rest(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t precision) {
  return acoustic_matrices(solid, psi, Interval(precision));
}

/// The s = tan(phi) of the scan with the smallest eigenvalue, and its neighbours.
struct Valley {
  double left, bottom, right;
  double eigenvalue;
};

Valley scan(const AcousticPencil<Small>& pencil) {
  constexpr int steps = 360;
  const auto s_at = [](int k) { return std::tan(std::numbers::pi * (k / double{steps} - 0.5)); };
  Valley best{0, 0, 0, INFINITY};
  Eigen::SelfAdjointEigenSolver<Small> solver;
  for (int k = 2; k <= steps - 2; ++k) {
    solver.computeDirect(pencil.at(s_at(k)), Eigen::EigenvaluesOnly);
    const double eigenvalue = solver.eigenvalues()(0);
    if (eigenvalue < best.eigenvalue) best = {s_at(k - 1), s_at(k), s_at(k + 1), eigenvalue};
  }
  return best;
}

/// Eigenvector of the smallest eigenvalue at s.
template <class AnyMatrix, class Scalar>
auto lowest_vector(const AcousticPencil<AnyMatrix>& pencil, const Scalar& s) {
  const Eigen::SelfAdjointEigenSolver<AnyMatrix> solver(pencil.at(s));
  return solver.eigenvectors().col(0).eval();
}

/// Where the smallest eigenvalue stops falling: bisection by the sign of its derivative, x.((r + r^T) + 2 s
/// t).x.
template <class AnyMatrix, class Scalar>
Scalar lowest_point(const AcousticPencil<AnyMatrix>& pencil, Scalar left, Scalar right, int bisections) {
  for (int step = 0; step < bisections; ++step) {
    const Scalar s = (left + right) / 2;
    const auto x = lowest_vector(pencil, s);
    const Scalar half_slope = x.dot(pencil.r * x) + s * x.dot(pencil.t * x);
    (half_slope < 0 ? left : right) = s;
  }
  return (left + right) / 2;
}

/// Rayleigh's quotient x.(q + s (r + r^T) + s^2 t).x/x.x, whose upper end bounds the limiting inertia.
Interval rayleigh_quotient(const AcousticMatrices& matrices, const Float& s, const Vector& x) {
  const mpfr_prec_t precision = matrices.q.precision();
  const Interval si = point(s, precision);
  Interval numerator(precision);
  Interval denominator(precision);
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval xi = point(x(static_cast<Eigen::Index>(i)), precision);
    denominator = denominator + square(xi);
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval entry =
          matrices.q(i, k).real + 2 * (si * matrices.r(i, k).real) + square(si) * matrices.t(i, k).real;
      numerator = numerator + xi * point(x(static_cast<Eigen::Index>(k)), precision) * entry;
    }
  }
  return numerator / denominator;
}

Float power_of_two(mpfr_prec_t exponent) { return ldexp(Float(1), static_cast<int>(exponent)); }

/// det M in intervals; nothing where the impedance is not proven.
std::optional<Interval> determinant(const ExactStiffness& solid, const SurfaceDirection& psi,
                                    const Float& inertia, mpfr_prec_t precision) {
  const auto impedance = surface_impedance(acoustic_matrices(solid, psi, point(inertia, precision)));
  if (!impedance) return std::nullopt;
  return hermitian_determinant(*impedance);
}

/// w = sqrt(1 - inertia/limiting): near the limiting speed M is smooth in w.
constexpr double nearest_w = 1.0 / (1 << 20);

/// [root - d, root + d] with det M > 0 at the left and < 0 at the right, for the smallest d = root 2^-k, k <=
/// bits, that proves it.
Interval proven_bracket(const ExactStiffness& solid, const SurfaceDirection& psi, const Float& root,
                        mpfr_prec_t bits, mpfr_prec_t precision) {
  for (mpfr_prec_t k = bits; k > bits / 2; k -= 4) {
    const Float distance = root * power_of_two(-k);
    const Float left = root - distance;
    const Float right = root + distance;
    const auto before = determinant(solid, psi, left, precision);
    const auto after = determinant(solid, psi, right, precision);
    if (before && after && mpfi_is_strictly_pos(before->get()) > 0 &&
        mpfi_is_strictly_neg(after->get()) > 0) {
      return {to_real(left), to_real(right), precision};
    }
  }
  throw std::logic_error("the surface wave's speed has no proof");
}

double determinant(const AcousticPencil<Small>& pencil, double inertia) {
  const Small q = pencil.q - inertia * Small::Identity();
  const auto impedance = barnett_lothe_impedance<Eigen::MatrixXd>(q, pencil.r, pencil.t, 1e-7, 60);
  if (!impedance) return -1;
  Eigen::Matrix3cd complex;
  complex.real() = impedance->re;
  complex.imag() = impedance->im;
  return complex.determinant().real();
}

}  // namespace

Interval limiting_inertia(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t bits) {
  const Valley valley = scan(double_pencil(at_rest(solid, psi, 64)));
  constexpr int most_attempts = 3;
  // The proof below needs Im s, which is of the order of the square root of the distance, several times over.
  mpfr_prec_t precision = 3 * bits + 64;
  for (int attempt = 0; attempt < most_attempts; ++attempt, precision *= 2) {
    const WorkingDigits working(digits_of(precision));
    const AcousticMatrices matrices = at_rest(solid, psi, precision);
    const auto pencil = multiprecision_pencil(matrices);
    const Float s =
        lowest_point(pencil, Float(valley.left), Float(valley.right), static_cast<int>(bits) + 16);
    const Interval quotient = rayleigh_quotient(matrices, s, lowest_vector(pencil, s));
    const Float below = middle(quotient) * (1 - power_of_two(-bits));
    if (surface_impedance(acoustic_matrices(solid, psi, point(below, precision)))) {
      Real above(precision);
      mpfi_get_right(above.get(), quotient.get());
      return {to_real(below), above, precision};
    }
  }
  throw std::logic_error("the limiting speed has no proof");
}

std::optional<Interval> surface_wave_inertia(const ExactStiffness& solid, const SurfaceDirection& psi,
                                             mpfr_prec_t bits) {
  const mpfr_prec_t precision = 2 * bits + 64;
  const WorkingDigits working(digits_of(precision));
  const Float limit = middle(limiting_inertia(solid, psi, 64));
  const auto inertia = [&](const Float& w) { return Float(limit * (1 - w * w)); };
  const auto f = [&](const Float& w) {
    const auto value = determinant(solid, psi, inertia(w), precision);
    if (!value) throw std::logic_error("no impedance below the limiting speed");
    return middle(*value);
  };
  if (!(f(Float(nearest_w)) < 0)) return std::nullopt;
  const Float w = bracketed_root(f, Float(1), Float(nearest_w), power_of_two(-bits - 8));
  return proven_bracket(solid, psi, inertia(w), bits, precision);
}

double approximate_critical_inertia(const ExactStiffness& solid, const SurfaceDirection& psi) {
  const auto pencil = double_pencil(at_rest(solid, psi, 64));
  const Valley valley = scan(pencil);
  const double s = lowest_point(pencil, valley.left, valley.right, 40);
  const double limit =
      Eigen::SelfAdjointEigenSolver<Small>(pencil.at(s), Eigen::EigenvaluesOnly).eigenvalues()(0);
  const auto f = [&](double w) { return determinant(pencil, limit * (1 - w * w)); };
  constexpr double nearest = 1e-4;
  if (!(f(nearest) < 0)) return limit;
  const double w = bracketed_root(f, 1.0, nearest, 1e-13);
  return limit * (1 - w * w);
}

}  // namespace nipref::ref
