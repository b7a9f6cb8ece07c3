#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/internal/interval_float.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>

namespace nipref::ref {
namespace {

mpfr_prec_t bits_of(double nats) { return static_cast<mpfr_prec_t>(nats / std::numbers::ln2) + 16; }

/// The speed of a load that has this inertia along psi.
Interval load_speed(const ExactStiffness& solid, const Interval& inertia, const Interval& cosine) {
  const Exact squared_unit(mpq_class(solid.voigt[2][2] / solid.density));
  Interval speed = sqrt(inertia * Interval(squared_unit, inertia.precision())) / cosine;
  mpfi_abs(speed.get(), speed.get());
  return speed;
}

Interval oblique_cosine(const SurfaceDirection& motion, const SurfaceDirection& psi, mpfr_prec_t precision) {
  Interval cosine = cosine_between(motion, psi, precision);
  if (mpfi_has_zero(cosine.get()) > 0) {
    throw data::BadInput("psi", "perpendicular", "must not be perpendicular to the motion");
  }
  return cosine;
}

SurfaceDirection degrees(const Float& angle) { return SurfaceDirection::of_degrees(to_exact(angle)); }

Enclosure critical_speed_along(const ExactStiffness& solid, const SurfaceDirection& motion,
                               const SurfaceDirection& psi, int digits) {
  auto wave = surface_wave_speed(solid, motion, psi, digits);
  return wave ? *std::move(wave) : limiting_speed(solid, motion, psi, digits);
}

double approximate_critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, double psi) {
  const auto direction = SurfaceDirection::of_degrees(Exact(psi));
  const double cosine = mpfi_get_d(cosine_between(motion, direction, 64).get());
  return std::sqrt(approximate_critical_inertia(solid, direction)) / std::fabs(cosine);
}

double degrees_of(const SurfaceDirection& direction) {
  const auto [cosine, sine] = direction.at(64);
  return std::atan2(mpfi_get_d(sine.get()), mpfi_get_d(cosine.get())) * 180 / std::numbers::pi;
}

/// Vertex of the parabola through three values at -1, 0, 1, and its second difference.
template <class Scalar>
struct Parabola {
  Scalar vertex, curvature;

  Parabola(const Scalar& left, const Scalar& centre, const Scalar& right)
      : vertex((left - right) / (2 * (left - 2 * centre + right))), curvature(left - 2 * centre + right) {}
};

/// The minimiser of the critical speed in degrees, to some 1e-5: the scan, then parabolas of shrinking width.
double approximate_minimiser(const ExactStiffness& solid, const SurfaceDirection& motion) {
  const double theta = degrees_of(motion);
  double best = theta;
  double least = INFINITY;
  for (int offset = -89; offset <= 89; ++offset) {
    const double speed = approximate_critical_speed(solid, motion, theta + offset);
    if (speed < least) {
      least = speed;
      best = theta + offset;
    }
  }
  const auto f = [&](double psi) { return approximate_critical_speed(solid, motion, psi); };
  for (const double width : {0.5, 0.1, 0.02, 0.02}) {
    const Parabola<double> parabola(f(best - width), f(best), f(best + width));
    best += std::clamp(parabola.vertex * width, -1.0, 1.0);
  }
  return best;
}

}  // namespace

Enclosure limiting_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                         const SurfaceDirection& psi, int digits) {
  return enclose(digits, 0, [&](double nats) {
    const Interval inertia = limiting_inertia(solid, psi, bits_of(nats));
    return load_speed(solid, inertia, oblique_cosine(motion, psi, inertia.precision()));
  });
}

std::optional<Enclosure> surface_wave_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                                            const SurfaceDirection& psi, int digits) {
  check_digits(digits);
  oblique_cosine(motion, psi, 4 * digits);
  if (!surface_wave_inertia(solid, psi, 24)) return std::nullopt;
  return enclose(digits, 0, [&](double nats) {
    const Interval inertia = surface_wave_inertia(solid, psi, bits_of(nats)).value();
    return load_speed(solid, inertia, oblique_cosine(motion, psi, inertia.precision()));
  });
}

CriticalSpeed critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, int digits) {
  check_digits(digits);
  // A parabola of width h leaves an error of the order of h^2 in psi and h^4 in the speed.
  int width_digits = 4;
  Float psi = approximate_minimiser(solid, motion);
  for (;; width_digits *= 2) {
    const int working_digits = std::max(digits, 4 * width_digits) + 8;
    const WorkingDigits working(working_digits + 16);
    const Float width = pow(Float(10), -width_digits);
    psi = psi.at_working_precision();
    const auto f = [&](const Float& angle) {
      return to_float(critical_speed_along(solid, motion, degrees(angle), working_digits).value);
    };
    const Parabola<Float> parabola(f(psi - width), f(psi), f(psi + width));
    psi += parabola.vertex * width;
    if (4 * width_digits < digits + 4) continue;
    Enclosure speed = critical_speed_along(solid, motion, degrees(psi), digits);
    const Float miss = parabola.curvature * pow(10 * width, 2);
    mpfr_add(speed.error_bound.get(), speed.error_bound.get(), miss.get(), MPFR_RNDU);
    return {std::move(speed), static_cast<double>(psi)};
  }
}

}  // namespace nipref::ref
