#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>

namespace nipref::ref {
namespace {

/// Of w^2 = 1 + e cos 2 psi + f sin 2 psi.
struct Ellipse {
  Float e = 0, f = 0;
};

/// cos and sin of twice the angles of evenly spread directions.
struct DoubledAngles {
  std::vector<Float> c, s;

  explicit DoubledAngles(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Float angle = 2 * pi() * static_cast<long>(i) / static_cast<long>(count) - pi();
      c.push_back(cos(angle));
      s.push_back(sin(angle));
    }
  }
};

/// (C1 - C2)/(C1 + C2) of the curvatures along and across the motion.
Float eccentricity(const Exact& curvature_ratio) {
  if (curvature_ratio.sign() <= 0)
    throw data::BadInput("curvature_ratio", curvature_ratio.approximate(), "must be positive");
  return to_float(Exact(mpq_class((1 - curvature_ratio.value()) / (1 + curvature_ratio.value()))));
}

/// int K n n/w^3 dpsi is proportional to the curvatures where int K (cos 2 psi - eccentricity)/w^3 dpsi and
/// int K sin 2 psi/w^3 dpsi vanish: Newton's method on the trapezoidal sums; nothing if it does not converge.
std::optional<Ellipse> solve_ellipse(const std::vector<Float>& compliance, const Float& eccentricity) {
  const auto count = compliance.size();
  Ellipse ellipse;
  const auto [c, s] = DoubledAngles(count);
  for (int step = 0; step < 60; ++step) {
    Float r1 = 0, r2 = 0, j11 = 0, j12 = 0, j21 = 0, j22 = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Float square = 1 + ellipse.e * c[i] + ellipse.f * s[i];
      const Float term = compliance[i] / (square * sqrt(square));
      const Float slope = Float(-1.5) * term / square;
      const Float off = c[i] - eccentricity;
      r1 += term * off;
      r2 += term * s[i];
      j11 += slope * off * c[i];
      j12 += slope * off * s[i];
      j21 += slope * s[i] * c[i];
      j22 += slope * s[i] * s[i];
    }
    const Float determinant = j11 * j22 - j12 * j21;
    Float de = -(r1 * j22 - r2 * j12) / determinant, df = -(r2 * j11 - r1 * j21) / determinant;
    if (mpfr_number_p(de.get()) == 0 || mpfr_number_p(df.get()) == 0) return std::nullopt;
    const auto beyond = [&] { return hypot(ellipse.e + de, ellipse.f + df) >= 1; };
    while (beyond()) {
      de /= 2;
      df /= 2;
    }
    ellipse.e += de;
    ellipse.f += df;
    if (hypot(de, df) < sqrt(std::numeric_limits<Float>::epsilon()) * Float(1e-3)) return ellipse;
  }
  return std::nullopt;
}

Float axis_ratio(const Ellipse& ellipse) {
  const Float r = hypot(ellipse.e, ellipse.f);
  return sqrt((1 - r) / (1 + r));
}

Float stiffness(const Ellipse& ellipse, const std::vector<Float>& compliance) {
  const auto [c, s] = DoubledAngles(compliance.size());
  Float first = 0, third = 0;
  for (std::size_t i = 0; i < compliance.size(); ++i) {
    const Float square = 1 + ellipse.e * c[i] + ellipse.f * s[i];
    const Float term = compliance[i] / sqrt(square);
    first += term;
    third += term / square;
  }
  const Float step = pi() / static_cast<long>(compliance.size());
  return 8 * pi() / 3 * sqrt(third * step) / pow(first * step, Float(1.5));
}

/// `value` of the ellipse and K at evenly spread directions, doubled until it changes no more.
template <class Value>
Estimated of_ellipse(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits, Value value) {
  return with_digits(digits, [&](int working) {
    const WorkingSurface lines(surface, working);
    const Float off_centre = eccentricity(curvature_ratio);
    std::optional<Float> last;
    Float change = 1;
    double_directions(
        digits, [&](const Exact& degrees) { return lines.at(degrees).compliance; },
        [&](const std::vector<Float>& compliance) {
          const std::optional<Ellipse> ellipse = solve_ellipse(compliance, off_centre);
          if (!ellipse) return false;
          const Float finer = value(*ellipse, compliance);
          if (last) change = abs(finer - *last);
          last = finer;
          return is_settled(change, finer, digits);
        });
    return estimated(*last, change, digits);
  });
}

}  // namespace

Estimated elliptic_axis_ratio(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits,
                    [](const Ellipse& ellipse, const std::vector<Float>&) { return axis_ratio(ellipse); });
}

Estimated elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits, stiffness);
}

}  // namespace nipref::ref
