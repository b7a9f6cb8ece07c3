#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/internal/critical_lines.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/internal/phase_speed.hpp>

namespace nipref::ref {
namespace {

mpfr_prec_t inertia_bits(double nats) { return static_cast<mpfr_prec_t>(nats / std::numbers::ln2) + 16; }

/// The speed of a load that has this inertia along psi.
Interval load_speed(const ExactStiffness& solid, const Interval& inertia, const Interval& cosine) {
  const Exact squared_unit(mpq_class(solid.voigt[2][2] / solid.density));
  return abs(sqrt(inertia * Interval(squared_unit, inertia.precision())) / cosine);
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

/// The vertex of the parabola through three values at -1, 0, 1, and their second difference.
struct Parabola {
  Float vertex, curvature;

  Parabola(const Float& left, const Float& centre, const Float& right)
      : vertex((left - right) / (2 * (left - 2 * centre + right))), curvature(left - 2 * centre + right) {}
};

double unit_of_speed(const ExactStiffness& solid) {
  return std::sqrt(Exact(mpq_class(solid.voigt[2][2] / solid.density)).approximate());
}

/// Bounds of the distance from the parabola's middle point to its vertex, in units of its width. Below the first the
/// vertex is accepted as the minimum; above the second the minimum is taken not to be smooth.
constexpr double widths_of_error = 10, farthest_vertex = 1e4;
constexpr int most_parabolas = 8;
/// The widths are 10^-4, 10^-8, 10^-16 ..., and the speeds need four times as many digits.
constexpr int most_critical_digits = 508;

[[noreturn]] void refuse_motion(const SurfaceDirection& motion) {
  throw data::BadInput("motion", fmt::format("{:.10g} degrees", motion.degrees()),
                       "must be one whose critical speed has a smooth minimum over the lines");
}

bool is_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                    const SurfaceDirection& psi) {
  return is_subcritical(solid, psi, [&](mpfr_prec_t precision) {
    return inertia_of(solid, speed, cosine_between(motion, psi, precision));
  });
}

/// The smooth minimum next to psi.
CriticalSpeed bottom(const ExactStiffness& solid, const SurfaceDirection& motion, Float psi, int digits) {
  // A parabola of width h has an error of the order of h^2 in psi and h^4 in the speed. It is repeated about its vertex
  // where that was too far away.
  for (int width_digits = 4;; width_digits *= 2) {
    const int working_digits = std::max(digits, 4 * width_digits) + 8;
    const WorkingDigits working(working_digits + 16);
    const Float width = pow(Float(10), -width_digits);
    psi = at_working_precision(psi);
    const auto f = [&](const Float& angle) {
      return at_working_precision(critical_speed_along(solid, motion, degrees(angle), working_digits).value);
    };
    Float curvature = 0, vertex = widths_of_error;
    for (int attempt = 0; !(abs(vertex) < widths_of_error); ++attempt) {
      const Parabola parabola(f(psi - width), f(psi), f(psi + width));
      curvature = parabola.curvature;
      vertex = parabola.vertex;
      if (!(curvature > 0 && abs(vertex) < farthest_vertex && attempt < most_parabolas))
        refuse_motion(motion);
      psi += vertex * width;
    }
    if (4 * width_digits < digits + 10) continue;
    Estimate speed = critical_speed_along(solid, motion, degrees(psi), digits);
    const Float miss = curvature * pow(widths_of_error * width, 2);
    mpfr_add(raw(speed.error), raw(speed.error), raw(miss), MPFR_RNDU);
    speed.proven = false;  // the curvature is an estimate
    return {std::move(speed), static_cast<double>(psi)};
  }
}

}  // namespace

Enclosure limiting_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                         const SurfaceDirection& psi, int digits) {
  return enclose(digits, 0, [&](double nats) {
    const Interval inertia = limiting_inertia(solid, psi, inertia_bits(nats));
    return load_speed(solid, inertia, oblique_cosine(motion, psi, inertia.precision()));
  });
}

std::optional<Enclosure> surface_wave_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                                            const SurfaceDirection& psi, int digits) {
  check_digits(digits);
  oblique_cosine(motion, psi, 4 * digits);
  if (!surface_wave_inertia(solid, psi, inertia_bits(digits * std::numbers::ln10))) return std::nullopt;
  return enclose(digits, 0, [&](double nats) {
    const auto inertia = surface_wave_inertia(solid, psi, inertia_bits(nats));
    if (!inertia) {
      throw data::BadInput("psi", fmt::format("{:.10g} degrees", psi.degrees()),
                           "must be a direction whose surface wave is farther from the limiting speed");
    }
    return load_speed(solid, *inertia, oblique_cosine(motion, psi, inertia->precision()));
  });
}

Enclosure separation_degrees(const ExactStiffness& solid, const Exact& speed, int digits) {
  const auto line = SurfaceDirection::of_degrees(Exact(0.0));
  return enclose(digits, 0, [&](double nats) {
    // Close to the speed of the wave the angle is proportional to the square root of the difference of the speeds.
    const auto inertia = surface_wave_inertia(solid, line, inertia_bits(2 * nats));
    if (!inertia) refuse_proof(line, surface_wave);
    const Interval wave = load_speed(solid, *inertia, Interval(1L, inertia->precision()));
    const Interval given(speed, wave.precision());
    if (mpfr_less_p(given.upper(), wave.lower()) != 0) {
      throw data::BadInput(
          "speed", speed.text(),
          fmt::format("must be at least {:.17g}, that of Rayleigh waves", mpfi_get_d(wave.get())));
    }
    Interval squared_sine = 1 - square(wave / given);
    if (mpfr_sgn(squared_sine.lower()) < 0) mpfr_set_zero(&squared_sine.get()->left, 1);
    return 180 * atan(sqrt(squared_sine) * given / wave) / Interval::pi(wave.precision());
  });
}

void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                       const SurfaceDirection& psi) {
  if (is_subcritical(solid, speed, motion, psi)) return;
  const double cosine = std::fabs(mpfi_get_d(cosine_between(motion, psi, 64).get()));
  throw data::BadInput(
      "speed", speed.text(),
      fmt::format("must be below {:.6g}, which is critical on lines {:.6g} degrees from the motion",
                  critical_speed_along(solid, motion, psi, 16).to_double(),
                  std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi));
}

void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion) {
  const CriticalLine line = std::ranges::min(lowest_lines(solid, motion), {}, &CriticalLine::speed);
  if (is_subcritical(solid, speed, motion, SurfaceDirection::of_degrees(Exact(line.psi)))) return;
  throw data::BadInput(
      "speed", speed.text(),
      fmt::format("must be below {:.10g}, which is critical on the line psi = {:.6g} degrees",
                  line.speed * unit_of_speed(solid), line.psi));
}

CriticalSpeed critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, int digits) {
  if (digits < 16 || digits > most_critical_digits) {
    throw data::BadInput("digits", std::to_string(digits),
                         fmt::format("must be from 16 to {} for a critical speed", most_critical_digits));
  }
  std::optional<CriticalSpeed> least;
  for (const CriticalLine& line : lowest_lines(solid, motion)) {
    CriticalSpeed found = bottom(solid, motion, line.psi, digits);
    if (!least || mpfr_less_p(raw(found.speed.value), raw(least->speed.value)) != 0) least = std::move(found);
  }
  return *std::move(least);
}

}  // namespace nipref::ref
