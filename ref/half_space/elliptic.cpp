#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>

namespace nipref::ref {
namespace {

using Lines = std::vector<DirectionValue>;

/// Of axes a/b = exp(eta), the major one at the angle alpha from the motion: (p, q) = eta (cos 2 alpha, sin 2
/// alpha), in which the equations are nearly linear however slender the ellipse.
struct Ellipse {
  Float p = 0, q = 0;

  [[nodiscard]] Float eta() const { return hypot(p, q); }
};

/// Half-width squared over a b along a line, e^eta C^2 + e^-eta S^2 with C and S the cosine and sine of the
/// angle from the major axis, and its slopes.
class SquaredWidth {
 public:
  explicit SquaredWidth(const Ellipse& ellipse) : eta_(ellipse.eta()), wide_(exp(eta_)), narrow_(1 / wide_) {
    const bool is_round = eta_ == Float(0);
    cosine2_ = is_round ? Float(1) : Float(ellipse.p / eta_);
    sine2_ = is_round ? Float(0) : Float(ellipse.q / eta_);
    // alpha from its double, |alpha| <= 90 degrees, without cancellation
    const bool is_forward = ellipse.p >= Float(0);
    const Float larger = sqrt((1 + abs(cosine2_)) / 2), smaller = abs(sine2_) / (2 * larger);
    cosine_ = is_forward ? larger : smaller;
    sine_ = is_forward ? smaller : larger;
    if (sine2_ < Float(0)) sine_ = -sine_;
    turning_ = is_round ? Float(1) : Float(sinh(eta_) / eta_);
  }

  struct Value {
    Float value, over_p, over_q;
  };
  [[nodiscard]] Value at(const CrowdedDirections::Direction& line) const {
    const Float c = line.cosine * cosine_ + line.sine * sine_, s = line.sine * cosine_ - line.cosine * sine_;
    const Float grown = wide_ * c * c - narrow_ * s * s, turned = 2 * c * s * turning_;
    return {wide_ * c * c + narrow_ * s * s, grown * cosine2_ - turned * sine2_,
            grown * sine2_ + turned * cosine2_};
  }

 private:
  Float eta_, wide_, narrow_;
  Float cosine2_, sine2_, cosine_, sine_;
  Float turning_;  ///< sinh(eta)/eta
};

/// A function of the ellipse and its slopes.
struct Sloped {
  Float value, over_p, over_q;

  void add(const Float& term, const Float& slope, const SquaredWidth::Value& width) {
    value += term;
    over_p += slope * width.over_p;
    over_q += slope * width.over_q;
  }
};

/// int K n n/w^3 dpsi is proportional to the curvatures where its logarithm m11/m22 is that of their ratio and
/// m12 vanishes against both: Newton's method on the trapezoidal sums; nothing if it does not converge.
std::optional<Ellipse> solve_ellipse(const Lines& lines, const Float& curvature_ratio, Ellipse ellipse) {
  for (int step = 0; step < 60; ++step) {
    const SquaredWidth squared_width(ellipse);
    Sloped m11, m12, m22;
    for (const auto& [at, compliance] : lines) {
      const auto width = squared_width.at(at);
      const Float term = at.weight * compliance / (width.value * sqrt(width.value));
      const Float slope = Float(-1.5) * term / width.value;
      const Float cc = at.cosine * at.cosine, cs = at.cosine * at.sine, ss = at.sine * at.sine;
      m11.add(term * cc, slope * cc, width);
      m12.add(term * cs, slope * cs, width);
      m22.add(term * ss, slope * ss, width);
    }
    const Float size = sqrt(m11.value * m22.value);
    const Float r1 = log(m11.value / m22.value * curvature_ratio), r2 = m12.value / size;
    const auto along = [&](Float Sloped::*over) { return m11.*over / m11.value; };
    const auto across = [&](Float Sloped::*over) { return m22.*over / m22.value; };
    const auto first = [&](Float Sloped::*over) { return along(over) - across(over); };
    const auto second = [&](Float Sloped::*over) {
      return m12.*over / size - r2 * (along(over) + across(over)) / 2;
    };
    const Float j11 = first(&Sloped::over_p), j12 = first(&Sloped::over_q);
    const Float j21 = second(&Sloped::over_p), j22 = second(&Sloped::over_q);
    const Float determinant = j11 * j22 - j12 * j21;
    Float dp = -(r1 * j22 - r2 * j12) / determinant, dq = -(r2 * j11 - r1 * j21) / determinant;
    const Float length = hypot(dp, dq);
    if (mpfr_number_p(length.get()) == 0) return std::nullopt;
    const Float part = 1 / std::max(Float(1), length);
    ellipse.p += part * dp;
    ellipse.q += part * dq;
    if (length < sqrt(std::numeric_limits<Float>::epsilon()) * Float(1e-3)) return ellipse;
  }
  return std::nullopt;
}

Float axis_ratio(const Ellipse& ellipse) { return exp(-ellipse.eta()); }

Float stiffness(const Ellipse& ellipse, const Lines& lines) {
  const SquaredWidth squared_width(ellipse);
  Float first = 0, third = 0;
  for (const auto& [at, compliance] : lines) {
    const Float square = squared_width.at(at).value;
    const Float term = at.weight * compliance / sqrt(square);
    first += term;
    third += term / square;
  }
  const auto count = static_cast<long>(lines.size());
  return 8 * pi() / 3 * sqrt(third / count) / pow(first / count, Float(1.5));
}

constexpr double slenderest = 1e-12;

/// Hertz's axes within a few per cent, along and across the motion.
Ellipse first_ellipse(const Float& curvature_ratio) { return {Float(0.62) * log(curvature_ratio), 0}; }

/// With some room for that ellipse, which a peak of the compliance makes longer, up to the inverse of its width.
CrowdedDirections directions_for(const SurfaceAnswer& surface, double curvature_ratio) {
  const auto [degrees, width] = peak_of_compliance(surface);
  const double slenderness = std::exp(-0.7 * std::fabs(std::log(curvature_ratio)));
  const bool is_along = curvature_ratio >= 1;  // then singular at |tan| = 1/slenderness
  const double smallest = is_along ? width : std::min(width, slenderness);
  return {Exact(degrees), smallest, 1 / (is_along ? std::min(width, slenderness) : width)};
}

/// `value` of the ellipse and K on lines, doubled until it changes no more.
template <class Value>
Estimated of_ellipse(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits, Value value) {
  const double ratio = curvature_ratio.approximate();
  if (!(ratio >= slenderest && ratio <= 1 / slenderest))
    throw data::BadInput("curvature_ratio", curvature_ratio.text(), "must lie between 1e-12 and 1e12");
  return with_digits(digits, [&](int working) {
    const WorkingSurface lines(surface, working);
    const Float curvatures = to_float(curvature_ratio);
    Ellipse ellipse = first_ellipse(curvatures);
    std::optional<Float> last;
    Float change = 1;
    double_directions(
        digits, directions_for(surface, ratio),
        [&](const Exact& degrees) { return lines.at(degrees).compliance; },
        [&](const Lines& compliance) {
          const std::optional<Ellipse> found = solve_ellipse(compliance, curvatures, ellipse);
          if (!found) return false;
          ellipse = *found;
          const Float finer = value(ellipse, compliance);
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
                    [](const Ellipse& ellipse, const Lines&) { return axis_ratio(ellipse); });
}

Estimated elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits, stiffness);
}

}  // namespace nipref::ref
