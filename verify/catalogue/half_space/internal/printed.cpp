#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

double square(double x) { return x * x; }

double rounded(double x, std::optional<int> decimals) {
  if (!decimals) return x;
  const double unit = std::pow(10.0, *decimals);
  return std::round(x * unit) / unit;
}

/// Terms of (brock2012 34) at psi = 0.
struct Terms {
  double d, c2, shear_root, dilatation_root, rayleigh, n;  // c_D^2, c^2, w_S, w_D, R, N

  Terms(double poisson, double speed, std::optional<int> decimals)
      : d((2 - 2 * poisson) / (1 - 2 * poisson)),
        c2(square(speed)),
        shear_root(rounded(std::sqrt(1 - c2), decimals)),
        dilatation_root(rounded(std::sqrt(1 - c2 / d), decimals)),
        rayleigh(4 * shear_root * dilatation_root - square(c2 - 2)),
        n(2 * shear_root * dilatation_root + c2 - 2) {}
};

/// Q of (brock2012 33b).
double shape(double omega) { return std::pow(1 + omega, 1 + omega) * std::pow(-omega, -omega); }

double rolling_span_ratio(const Terms& terms, double under_the_root) {
  return 0.5 * std::sqrt((terms.d + 1) / (terms.d - 1)) * std::sqrt(under_the_root) *
         std::sqrt(terms.rayleigh / (1 - terms.shear_root * terms.dilatation_root));
}

/// The sphere's terms (brock2013 20).
struct SphereTerms {
  double numerator, m, n;

  SphereTerms(double c_d, double speed) {
    const double d = square(c_d), a = std::sqrt(1 - square(speed) / d), b = std::sqrt(1 - square(speed));
    numerator = d * a * (a + b);
    m = 4 * (d - 1) * b - d * (a + b) * square(speed);
    n = d * a + (2 - d) * b;
  }
};

/// A line of half-space and sphere, axis normal, with (brock2013 25c) as printed.
struct SphereLine {
  double omega, h;  // Omega, sqrt(K^2 + Gamma^2)

  SphereLine(const ScaledModuli& moduli, double friction, double speed, double cosine) {
    const double d1 = moduli.c11, d5 = moduli.c44, d13 = moduli.c13, mean = std::sqrt(moduli.c33 * d5);
    const double cx2 = square(moduli.speed_scale * speed * cosine);
    const double a1 = std::sqrt(d1 - cx2), b5 = std::sqrt(d5 - cx2);
    const double p_plus =
        std::sqrt(square(std::sqrt(moduli.c33) * a1 + std::sqrt(d5) * b5) - square(d5 + d13));
    const double m = a1 * b5 * (b5 + std::sqrt(moduli.c33 / d5) * a1) - d5 * a1 - square(d13) * b5 / mean;
    const double n = a1 - d13 * b5 / mean;
    const SphereTerms sphere(moduli.sphere_dilatation, speed * cosine);
    const double k = a1 * p_plus / (m * mean) + sphere.numerator / sphere.m;
    const double gamma = friction * (n / m + sphere.n / sphere.m) * cosine;
    omega = -0.5 + std::atan(gamma / k) / std::numbers::pi;
    h = std::hypot(k, gamma);
  }
};

/// int_Omega^(1 + Omega) (1 + Omega - t)^(1 + Omega) (t - Omega)^(-Omega) |t| dt of (brock2013 36).
double moment_as_printed(double omega) {
  boost::math::quadrature::tanh_sinh<double> rule;
  const auto from = [&](double low, double high) {
    return rule.integrate(
        [&](double t) {
          return std::pow(1 + omega - t, 1 + omega) * std::pow(t - omega, -omega) * std::fabs(t);
        },
        low, high);
  };
  return from(omega, 0) + from(0, 1 + omega);
}

double over_half_turn(const std::function<double(double psi)>& value) {
  constexpr double quarter = std::numbers::pi / 2;
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(value, -quarter, quarter, 10, 1e-10);
}

}  // namespace

double die_span_ratio_as_printed(double poisson, double friction, double speed) {
  const Terms terms(poisson, speed, std::nullopt);
  const double sheared = -friction * terms.n, pressed = terms.c2 * terms.dilatation_root;
  const double q = shape(-0.5 + std::atan(sheared / pressed) / std::numbers::pi);
  return std::sqrt(square(terms.d) + square(friction)) / (terms.d - 1) * terms.rayleigh * q /
         std::hypot(sheared, pressed);
}

double die_span_ratio_as_tabulated(double poisson, double friction, double speed,
                                   std::optional<int> decimals) {
  const Terms terms(poisson, speed, decimals);
  return std::sqrt(square(terms.d) + square(friction)) / (2 * (terms.d - 1)) * terms.rayleigh /
         (terms.c2 * terms.dilatation_root);
}

double rolling_span_ratio_as_printed(double poisson, double speed) {
  const Terms terms(poisson, speed, std::nullopt);
  return rolling_span_ratio(terms, std::sqrt(terms.d) * terms.shear_root / terms.dilatation_root);
}

double rolling_span_ratio_as_tabulated(double poisson, double speed, int decimals) {
  const Terms terms(poisson, speed, decimals);
  return rolling_span_ratio(terms, terms.shear_root / terms.dilatation_root);
}

// Along the line the coefficients of (38b), (38c) are N1 cos^2 + 2 N12 sin cos + N2 sin^2 = M - M, across it N1 sin^2 -
// 2 N12 sin cos + N2 cos^2 = -M.
double in_line_as_printed(double, double, double) { return 0; }

double across_as_printed(double poisson, double speed, double degrees) {
  const Terms terms(poisson, speed * fast::Direction::of_degrees(degrees).cosine, std::nullopt);
  return (2 * terms.n + terms.c2) / (terms.shear_root * terms.rayleigh);
}

double rolling_creep_as_printed(double poisson, double speed, double degrees, double span) {
  const fast::RollingLine line = fast::rolling_sphere_for_span({1, poisson, 1}, 1, speed, span)
                                     .along(fast::Direction::of_degrees(degrees));
  return line.span * (line.span / 16 * (1 - 4 * line.index * line.index) - line.index / line.shear_share);
}

ScaledModuli scaled_moduli(const data::TransverselyIsotropicSolid& half_space,
                           const data::IsotropicSolid& sphere) {
  const double mu = sphere.shear, poisson = sphere.poisson;
  return {half_space.c11 / mu,
          half_space.c33 / mu,
          half_space.c13 / mu,
          half_space.c44 / mu,
          half_space.c66 / mu,
          std::sqrt(half_space.density / sphere.density),
          std::sqrt((2 - 2 * poisson) / (1 - 2 * poisson))};
}

double sphere_span_ratio_as_printed(const ScaledModuli& moduli, double friction, double speed) {
  const SphereLine along(moduli, friction, speed, 1);
  const double d5 = moduli.c44, d13 = moduli.c13, d = square(moduli.sphere_dilatation);
  const double root = std::sqrt(moduli.c11 * moduli.c33);
  const double half_space = 2 * std::sqrt(moduli.c11) * std::sqrt(2 * d5 + root + d13) /
                            ((root + d13) * std::sqrt(d5) * std::sqrt(root - d13));
  return shape(along.omega) / along.h * (d + half_space) / (d - 1);
}

double sphere_exponent_as_printed(const ScaledModuli& moduli, double friction, double speed, double cosine) {
  return SphereLine(moduli, friction, speed, cosine).omega;
}

double sphere_force_as_printed(const ScaledModuli& moduli, double friction, double speed) {
  const SphereLine along(moduli, friction, speed, 1);
  return std::pow(shape(along.omega) / along.h, 3) * over_half_turn([&](double psi) {
           const SphereLine line(moduli, friction, speed, std::cos(psi));
           return square(line.h / shape(line.omega)) * moment_as_printed(line.omega);
         });
}

double sphere_compliance(const ScaledModuli& moduli, double cosine_from_motion, double speed) {
  const SphereTerms sphere(moduli.sphere_dilatation, speed * cosine_from_motion);
  return sphere.numerator / sphere.m;
}

double in_plane_compliance(InPlaneForm form, const ScaledModuli& moduli, fast::Direction line,
                           double cosine_from_motion, double speed) {
  const double sign = form == InPlaneForm::printed ? 1 : -1;
  const double d1 = moduli.c11, d5 = moduli.c66, d6 = moduli.c44, d6_and_d12 = d6 + moduli.c13;
  const double cx2 = square(moduli.speed_scale * speed * cosine_from_motion);
  const double cosine2 = square(line.cosine), sine2 = square(line.sine);
  const double a6 = d6 * sine2 - cx2, a2 = moduli.c33 * sine2 - cx2;
  const double half = d1 * a2 + d6 * a6 - square(d6_and_d12) * sine2;
  const double root = std::sqrt(square(half) - 4 * d1 * d6 * a2 * a6);
  const double b_plus = std::sqrt(cosine2 + (half + root) / (2 * d1 * d6));
  const double b_minus = std::sqrt(cosine2 + (half - root) / (2 * d1 * d6));
  const double b_cubic = b_plus * b_minus * (b_plus + b_minus);
  const double b5 = std::sqrt(cosine2 + a6 / d5), t5 = a6 + 2 * d5 * cosine2;
  const double q = square(d6_and_d12) * sine2 / (d1 * d6) - cosine2 - a2 / d6 - b_plus * b_minus;
  const double m = sign * 4 * square(d5) * b5 * b_cubic * cosine2 -
                   d6 * a6 * (cosine2 + a6 / d1 + b_plus * b_minus) * sine2 - q * square(t5);
  return std::fabs(a6 / m) * b_cubic;
}

double in_plane_span_ratio(InPlaneForm form, const ScaledModuli& moduli, double theta, double phi,
                           double speed) {
  const auto compliance = [&](double degrees, double cosine) {
    return in_plane_compliance(form, moduli, fast::Direction::of_degrees(degrees), cosine, speed) +
           sphere_compliance(moduli, cosine, speed);
  };
  return compliance(theta + phi, fast::Direction::of_degrees(phi).cosine) / compliance(theta, 1);
}

double in_plane_force_as_printed(const ScaledModuli& moduli, fast::Direction motion, double speed) {
  const auto compliance = [&](double psi) {
    const fast::Direction from_motion = fast::Direction::of_angle(psi);
    return in_plane_compliance(InPlaneForm::printed, moduli, from_motion.turned(motion), from_motion.cosine,
                               speed) +
           sphere_compliance(moduli, from_motion.cosine, speed);
  };
  return over_half_turn([&](double psi) { return square(compliance(psi)); }) /
         (12 * std::pow(compliance(0), 3));
}

double branch_radicand_as_printed(const ScaledModuli& moduli, fast::Direction motion) {
  const double d6 = moduli.c44;
  const double p = moduli.c11 * square(motion.cosine) + moduli.c33 * square(motion.sine);
  const double twice = 2 * motion.sine * motion.cosine;
  const double p6 = std::sqrt(
      4 * square(p) + (square(d6) - 2 * moduli.c11 * moduli.c33 - square(d6 + moduli.c13)) * square(twice));
  return d6 + p - p6;
}

}  // namespace nipref::verify
