#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

namespace nipref::ref {
namespace {

/// q + s (r + r^T) + s^2 t at rest, in floating point.
template <class Scalar>
struct AcousticPencil {
  using Square = DenseMatrix<Scalar>;
  using EigenSolver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Scalar, 3, 3>>;
  Square q, r, t;

  explicit AcousticPencil(const AcousticMatrices& x)
      : q(middle(x.q).re.cast<Scalar>()),
        r(middle(x.r).re.cast<Scalar>()),
        t(middle(x.t).re.cast<Scalar>()) {}

  [[nodiscard]] Square at(const Scalar& s) const { return q + s * (r + r.transpose()) + s * s * t; }
  [[nodiscard]] Scalar lowest_value(const Scalar& s) const {
    return EigenSolver(at(s), Eigen::EigenvaluesOnly).eigenvalues()(0);
  }
  /// The eigenvector of the smallest eigenvalue.
  [[nodiscard]] Square lowest_vector(const Scalar& s) const {
    return EigenSolver(at(s)).eigenvectors().col(0);
  }
};
using RoughPencil = AcousticPencil<double>;

/// An interval about the s = tan(phi) at which the smallest eigenvalue is smallest, from a scan of half a turn.
struct Valley {
  double left, right;

  explicit Valley(const RoughPencil& pencil) {
    constexpr int steps = 360;
    const auto s_at = [](int k) { return std::tan(std::numbers::pi * (k / double{steps} - 0.5)); };
    double lowest = HUGE_VAL;
    for (int k = 2; k <= steps - 2; ++k) {
      const double eigenvalue = pencil.lowest_value(s_at(k));
      if (eigenvalue < lowest) lowest = eigenvalue, left = s_at(k - 1), right = s_at(k + 1);
    }
  }
  /// The s of the minimum, to half of the bits, and the eigenvalue there, to all bits. If the scan has seen only
  /// rounding errors, because moduli differ too much, there need not be a minimum; the search ends after `bits` steps.
  template <class Scalar>
  [[nodiscard]] std::pair<Scalar, Scalar> lowest_point(const AcousticPencil<Scalar>& pencil,
                                                       mpfr_prec_t bits) const {
    const auto value = [&](const Scalar& s) { return pencil.lowest_value(s); };
    auto most_steps = static_cast<std::uintmax_t>(bits);
    return boost::math::tools::brent_find_minima(value, Scalar(left), Scalar(right),
                                                 static_cast<int>(bits / 2), most_steps);
  }
};

AcousticMatrices at_rest(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t precision) {
  return acoustic_matrices(solid, psi, Interval(precision));
}

/// The Rayleigh quotient x.(q + s (r + r^T) + s^2 t).x/x.x, whose upper end is an upper bound of the limiting inertia.
Interval rayleigh_quotient(const AcousticMatrices& matrices, const Float& s, const Vector& x) {
  const mpfr_prec_t precision = matrices.q.precision();
  const Interval si = interval_of(s, precision);
  Interval numerator(precision);
  Interval denominator(precision);
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval xi = interval_of(x(static_cast<Matrix::Index>(i)), precision);
    denominator = denominator + square(xi);
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval entry =
          matrices.q(i, k).re + 2 * (si * matrices.r(i, k).re) + square(si) * matrices.t(i, k).re;
      numerator = numerator + xi * interval_of(x(static_cast<Matrix::Index>(k)), precision) * entry;
    }
  }
  return numerator / denominator;
}

double determinant(const RoughPencil& pencil, double inertia) {
  const auto impedance = barnett_lothe_impedance<double>(
      pencil.q - inertia * RoughPencil::Square::Identity(3, 3), pencil.r, pencil.t, 1e-7, 60);
  if (!impedance) return -1;
  Eigen::Matrix3cd hermitian;
  hermitian.real() = impedance->re;
  hermitian.imag() = impedance->im;
  return hermitian.determinant().real();
}

/// The inertia limit (1 - w^2), nearest < w < 1, at which the determinant is 0. Nothing unless it is < 0 at `nearest`.
template <class Scalar, class Determinant>
std::optional<Scalar> wave_inertia(const SurfaceDirection& psi, const Scalar& limit,
                                   const Determinant& determinant_at, const Scalar& nearest,
                                   const Scalar& tolerance) {
  const auto inertia = [&](const Scalar& w) -> Scalar { return limit * (1 - w * w); };
  const auto f = [&](const Scalar& w) { return determinant_at(inertia(w)); };
  if (!(f(nearest) < 0)) return std::nullopt;
  const auto w = bracketed_root(f, Scalar(1), nearest, tolerance);
  if (!w) refuse_proof(psi, surface_wave);
  return inertia(*w);
}

Float power_of_two(mpfr_prec_t exponent) { return ldexp(Float(1), exponent); }

/// det M as an interval. Moduli that differ by many powers of ten need a few times the precision. Nothing if the
/// impedance is not proven with that either.
std::optional<Interval> determinant(const ExactStiffness& solid, const SurfaceDirection& psi,
                                    const Float& inertia, mpfr_prec_t precision) {
  constexpr int most_attempts = 3;
  for (int attempt = 0; attempt < most_attempts; ++attempt, precision *= 2) {
    const auto impedance = surface_impedance(acoustic_matrices(solid, psi, interval_of(inertia, precision)));
    if (impedance) return hermitian_determinant(*impedance);
  }
  return std::nullopt;
}

/// The smallest number of bits for which the bracket of a root is below the limiting speed.
constexpr mpfr_prec_t fewest_bits = 48;

}  // namespace

void refuse_proof(const SurfaceDirection& psi, const char* what) {
  throw data::BadInput(
      "solid", "(as given)",
      fmt::format("must be one whose {} in the direction psi = {:.6g} degrees can be proven: no "
                  "moduli many powers of ten apart, no surface wave next to the limiting speed",
                  what, psi.degrees()));
}

Interval limiting_inertia(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t bits) {
  const Valley valley(RoughPencil(at_rest(solid, psi, 64)));
  constexpr int most_attempts = 3;
  // The proof below contains powers of Im s, which is of the order of the square root of the distance to the limit.
  mpfr_prec_t precision = 3 * bits + 64;
  for (int attempt = 0; attempt < most_attempts; ++attempt, precision *= 2) {
    const WorkingDigits working(digits_of(precision));
    const AcousticMatrices matrices = at_rest(solid, psi, precision);
    const AcousticPencil<Float> pencil(matrices);
    const Float s = valley.lowest_point(pencil, precision).first;
    const Interval quotient = rayleigh_quotient(matrices, s, pencil.lowest_vector(s));
    const Float below = middle_of(quotient) * (1 - power_of_two(-bits));
    if (surface_impedance(acoustic_matrices(solid, psi, interval_of(below, precision)))) {
      Float above = zero_of_bits(precision);
      mpfi_get_right(raw(above), quotient.get());
      return {below, above, precision};
    }
  }
  refuse_proof(psi, "limiting speed");
}

std::optional<Interval> surface_wave_inertia(const ExactStiffness& solid, const SurfaceDirection& psi,
                                             mpfr_prec_t wanted_bits) {
  const mpfr_prec_t bits = std::max(wanted_bits, fewest_bits), precision = 3 * bits + 64;
  const WorkingDigits working(digits_of(precision));
  const Float limit = middle_of(limiting_inertia(solid, psi, bits + 24));
  // The surface wave is arbitrarily close to the limiting speed near directions in which the limiting wave has a
  // traction-free surface.
  const auto root = wave_inertia<Float>(
      psi, limit,
      [&](const Float& inertia) {
        const auto value = determinant(solid, psi, inertia, precision);
        if (!value) refuse_proof(psi, surface_wave);
        return middle_of(*value);
      },
      power_of_two(-bits / 2 - 4), power_of_two(-bits - 8));
  if (!root) return std::nullopt;
  const auto proven = proven_bracket(*root, *root * power_of_two(-bits), *root * power_of_two(-bits / 2), 16,
                                     1, [&](const Float& at) {
                                       const auto value = determinant(solid, psi, at, precision);
                                       return value ? sign_of(*value) : 0;
                                     });
  if (!proven) refuse_proof(psi, surface_wave);
  return proven;
}

double approximate_critical_inertia(const ExactStiffness& solid, const SurfaceDirection& psi) {
  const RoughPencil pencil(at_rest(solid, psi, 64));
  const double limit = Valley(pencil).lowest_point(pencil, std::numeric_limits<double>::digits).second;
  const auto determinant_at = [&](double inertia) { return determinant(pencil, inertia); };
  return wave_inertia<double>(psi, limit, determinant_at, 1e-4, 1e-13).value_or(limit);
}

bool is_subcritical(const ExactStiffness& solid, const SurfaceDirection& psi,
                    const std::function<Interval(mpfr_prec_t precision)>& inertia) {
  for (const mpfr_prec_t precision : {128, 256, 512}) {
    const auto impedance = surface_impedance(acoustic_matrices(solid, psi, inertia(precision)));
    if (impedance && is_positive_definite(*impedance)) return true;
  }
  return false;
}

}  // namespace nipref::ref
