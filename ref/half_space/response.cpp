#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
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

ComplexInterval scaled(const Interval& factor, const ComplexInterval& x) {
  return {factor * x.real, factor * x.imag};
}

/// Components of LineResponse in its order, from the inverse of the impedance in the axes 1, 2, 3.
Components components(const IntervalMatrix& y, const SurfaceDirection::Cosines& n, const Interval& unit) {
  const ComplexInterval in_line = scaled(n.cosine, y(2, 0)) + scaled(n.sine, y(2, 1));
  const ComplexInterval across = scaled(n.cosine, y(2, 1)) - scaled(n.sine, y(2, 0));
  const Interval mixed = 2 * (n.cosine * n.sine * y(0, 1).real);
  const Interval nn = square(n.cosine) * y(0, 0).real + square(n.sine) * y(1, 1).real + mixed;
  const Interval tt = square(n.sine) * y(0, 0).real + square(n.cosine) * y(1, 1).real - mixed;
  Components result{y(2, 2).real, -in_line.imag, -across.imag, in_line.real, across.real, nn, tt};
  for (Interval& component : result) component = component / unit;
  return result;
}

std::optional<Components> components_at(mpfr_prec_t precision, const ExactStiffness& solid,
                                        const Exact& speed, const SurfaceDirection& motion,
                                        const SurfaceDirection& psi) {
  const Interval inertia = inertia_of(solid, speed, cosine_between(motion, psi, precision));
  const auto impedance = surface_impedance(acoustic_matrices(solid, psi, inertia));
  if (!impedance) return std::nullopt;
  return components(hermitian_inverse(*impedance), psi.at(precision),
                    Interval(Exact(solid.voigt[2][2]), precision));
}

/// Whether every component has an error of at most 10^-digits of the largest diagonal component.
bool are_narrow(const Components& components, int digits) {
  Float widest = zero_of_bits(64), width = zero_of_bits(64), largest = zero_of_bits(64),
        magnitude = zero_of_bits(64);
  for (const Interval& component : components) {
    mpfi_diam_abs(raw(width), component.get());
    mpfr_max(raw(widest), raw(widest), raw(width), MPFR_RNDU);
  }
  for (const std::size_t diagonal : {0UL, 5UL, 6UL}) {
    mpfi_mig(raw(magnitude), components[diagonal].get());
    mpfr_max(raw(largest), raw(largest), raw(magnitude), MPFR_RNDD);
  }
  mpfr_set_si(raw(width), -digits, MPFR_RNDN);
  mpfr_exp10(raw(width), raw(width), MPFR_RNDD);
  mpfr_mul(raw(width), raw(width), raw(largest), MPFR_RNDD);
  return mpfr_lessequal_p(raw(widest), raw(width)) != 0;
}

}  // namespace

LineResponse line_response(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                           const SurfaceDirection& psi, int digits) {
  std::optional<Components> found;
  const auto compliance = [&](double nats) {
    mpfr_prec_t precision = static_cast<mpfr_prec_t>(nats / std::numbers::ln2) + spare_bits;
    for (int doubling = 0; doubling <= most_doublings; ++doubling, precision *= 2) {
      found = components_at(precision, solid, speed, motion, psi);
      if (found && are_narrow(*found, digits)) return found->front();
    }
    throw data::BadInput("speed", speed.text(),
                         "must stay below the limiting speed of the direction psi, which is where bulk "
                         "waves begin to radiate");
  };
  // The compliance is of the order of 1/C33.
  const double first_nats = Exact(solid.voigt[2][2]).log2_magnitude() * std::numbers::ln2;
  const Enclosure first = enclose(digits, std::max(0.0, first_nats), compliance);
  const auto other = [&](std::size_t k) { return enclosure_of((*found)[k], digits); };
  return {first, other(1), other(2), other(3), other(4), other(5), other(6)};
}

}  // namespace nipref::ref
