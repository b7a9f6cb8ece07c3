#include <fmt/format.h>

#include <algorithm>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/acoustic_pencil.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>

namespace nipref::ref {
namespace {

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
          matrices.q(i, k).real + 2 * (si * matrices.r(i, k).real) + square(si) * matrices.t(i, k).real;
      numerator = numerator + xi * interval_of(x(static_cast<Matrix::Index>(k)), precision) * entry;
    }
  }
  return numerator / denominator;
}

Float power_of_two(mpfr_prec_t exponent) { return ldexp(Float(1), exponent); }

/// det M as an interval; nothing where the impedance is proven neither at this precision nor at a few times this
/// precision, which moduli that differ by many powers of ten need.
std::optional<Interval> determinant(const ExactStiffness& solid, const SurfaceDirection& psi,
                                    const Float& inertia, mpfr_prec_t precision) {
  constexpr int most_attempts = 3;
  for (int attempt = 0; attempt < most_attempts; ++attempt, precision *= 2) {
    const auto impedance = surface_impedance(acoustic_matrices(solid, psi, interval_of(inertia, precision)));
    if (impedance) return hermitian_determinant(*impedance);
  }
  return std::nullopt;
}
/// The least number of bits for which a bracket of the root is below the limiting speed.
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
  const Valley valley = lowest_valley(at_rest(solid, psi, 64));
  constexpr int most_attempts = 3;
  // The proof below contains powers of Im s, which is of the order of the square root of the distance to the limit.
  mpfr_prec_t precision = 3 * bits + 64;
  for (int attempt = 0; attempt < most_attempts; ++attempt, precision *= 2) {
    const WorkingDigits working(digits_of(precision));
    const AcousticMatrices matrices = at_rest(solid, psi, precision);
    const AcousticPencil<Float> pencil = pencil_of<Float>(matrices);
    const Float s = lowest_point([&](const Float& at) { return pencil.half_slope(at); }, Float(valley.left),
                                 Float(valley.right), static_cast<int>(bits) + 16);
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
  // Close to a direction in which the limiting wave has a traction-free surface, the surface wave is arbitrarily
  // close to the limiting speed.
  const Float nearest_w = power_of_two(-bits / 2 - 4);
  const auto inertia = [&](const Float& w) { return Float(limit * (1 - w * w)); };
  const auto f = [&](const Float& w) {
    const auto value = determinant(solid, psi, inertia(w), precision);
    if (!value) refuse_proof(psi, surface_wave);
    return middle_of(*value);
  };
  if (!(f(nearest_w) < 0)) return std::nullopt;
  const auto w = bracketed_root(f, Float(1), nearest_w, power_of_two(-bits - 8));
  if (!w) refuse_proof(psi, surface_wave);
  const Float root = inertia(*w);
  const auto proven = proven_bracket(root, root * power_of_two(-bits), root * power_of_two(-bits / 2), 16, 1,
                                     [&](const Float& at) {
                                       const auto value = determinant(solid, psi, at, precision);
                                       return value ? sign_of(*value) : 0;
                                     });
  if (!proven) refuse_proof(psi, surface_wave);
  return proven;
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
