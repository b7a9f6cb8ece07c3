#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/response.hpp>

namespace nipref::ref {
namespace {

constexpr mpfr_prec_t spare_bits = 48;
/// How often the precision is doubled for speeds near the limiting one.
constexpr int most_doublings = 2;

using Components = std::vector<Interval>;

/// Components of LineResponse in its order, from the inverse of the impedance in the axes 1, 2, 3.
Components components(const IntervalMatrix& y, const SurfaceDirection::Cosines& n, const Interval& unit) {
  const ComplexInterval in_line = n.cosine * y(2, 0) + n.sine * y(2, 1);
  const ComplexInterval across = n.cosine * y(2, 1) - n.sine * y(2, 0);
  const Interval mixed = 2 * (n.cosine * n.sine * y(0, 1).re);
  const Interval nn = square(n.cosine) * y(0, 0).re + square(n.sine) * y(1, 1).re + mixed;
  const Interval tt = square(n.sine) * y(0, 0).re + square(n.cosine) * y(1, 1).re - mixed;
  Components result{y(2, 2).re, -in_line.im, -across.im, in_line.re, across.re, nn, tt};
  for (Interval& component : result) component = component / unit;
  return result;
}

/// Whether every interval has an error of at most 10^-digits of `size`.
bool are_narrow(const Components& intervals, const Interval& size, int digits) {
  Interval width(64);
  for (const Interval& each : intervals) width = larger_of(width, magnitude_of(each - each));
  return sign_of(exp(-(digits * log(Interval(10L, 64)))) * size - width) > 0;
}

/// G = t^-1 (M + i r^T) in the axes of the line. Nothing if the error of an entry is above 10^-digits of the largest.
std::optional<Decay> decay_of(const AcousticMatrices& matrices, const IntervalMatrix& impedance,
                              const SurfaceDirection::Cosines& n, int digits) {
  const Interval zero(0L, impedance.precision()), one(1L, impedance.precision());
  const std::array<Interval, 9> entries{n.cosine, n.sine, zero, -n.sine, n.cosine, zero, zero, zero, one};
  const auto axes = IntervalMatrix::real([&](std::size_t i, std::size_t k) { return entries[3 * i + k]; });
  const IntervalMatrix found =
      axes * (hermitian_inverse(matrices.t) * (impedance + times_i(matrices.r.adjoint()))) * axes.adjoint();
  Decay decay;
  Components parts;
  Interval largest(64);
  for (std::size_t k = 0; k < 9; ++k) {
    const ComplexInterval& entry = found(k / 3, k % 3);
    decay.re[k] = middle_of(entry.re);
    decay.im[k] = middle_of(entry.im);
    for (const Interval& part : {entry.re, entry.im}) {
      parts.push_back(part);
      largest = larger_of(largest, abs(part));
    }
  }
  return are_narrow(parts, largest, digits) ? std::optional(decay) : std::nullopt;
}

}  // namespace

LineResponse line_response(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                           const SurfaceDirection& psi, int digits, bool with_decay) {
  std::optional<Components> found;
  std::optional<Decay> decay;
  const auto compliance = [&](double nats) {
    mpfr_prec_t precision = static_cast<mpfr_prec_t>(nats / std::numbers::ln2) + spare_bits;
    for (int doubling = 0; doubling <= most_doublings; ++doubling, precision *= 2) {
      const Interval inertia = inertia_of(solid, speed, cosine_between(motion, psi, precision));
      const AcousticMatrices matrices = acoustic_matrices(solid, psi, inertia);
      const auto impedance = surface_impedance(matrices);
      if (!impedance) continue;
      const auto n = psi.at(precision);
      found = components(hermitian_inverse(*impedance), n, Interval(solid.voigt[2][2], precision));
      Interval diagonal(64);
      for (const std::size_t k : {0UL, 5UL, 6UL}) diagonal = larger_of(diagonal, abs((*found)[k]));
      if (!are_narrow(*found, diagonal, digits)) continue;
      if (with_decay && !(decay = decay_of(matrices, *impedance, n, digits))) continue;
      return found->front();
    }
    throw data::BadInput("speed", speed.text(),
                         "must stay below the limiting speed of the direction psi, which is where bulk "
                         "waves begin to radiate");
  };
  // The compliance is of the order of 1/C33.
  const double first_nats = Exact(solid.voigt[2][2]).log2_magnitude() * std::numbers::ln2;
  const Enclosure first = enclose(digits, std::max(0.0, first_nats), compliance);
  const auto other = [&](std::size_t k) { return enclosure_of((*found)[k], digits); };
  return {first, other(1), other(2), other(3), other(4), other(5), other(6), std::move(decay)};
}

}  // namespace nipref::ref
