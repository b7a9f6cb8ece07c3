#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/internal/elliptic_displacement.hpp>

namespace nipref::ref {
namespace {

using Lines = std::vector<DirectionValue>;

/// An ellipse with a/b = exp(eta) and its major axis at the angle alpha from the motion, in the variables (p, q) =
/// eta (cos 2 alpha, sin 2 alpha). In these variables the equations are nearly linear, however slender the ellipse is.
struct Ellipse {
  Float p = 0, q = 0;

  [[nodiscard]] Float eta() const { return hypot(p, q); }
  [[nodiscard]] Float alpha() const { return atan2(q, p) / 2; }
};

/// w^2/(a b) = e^eta C^2 + e^-eta S^2, where w is the half-width of the ellipse in the direction of a line, and C and S
/// are the cosine and sine of the angle between the major axis and the line.
class SquaredWidth {
 public:
  explicit SquaredWidth(const Ellipse& ellipse)
      : wide_(exp(ellipse.eta())),
        narrow_(1 / wide_),
        cosine_(cos(ellipse.alpha())),
        sine_(sin(ellipse.alpha())) {}

  [[nodiscard]] Float at(const CrowdedDirections::Direction& line) const {
    const Float c = line.cosine * cosine_ + line.sine * sine_, s = line.sine * cosine_ - line.cosine * sine_;
    return wide_ * c * c + narrow_ * s * s;
  }

 private:
  Float wide_, narrow_, cosine_, sine_;
};

/// The residuals of the condition that m = int K n n/w^3 dpsi, by the trapezoidal rule, is proportional to the
/// curvatures: ln(m11/m22) minus the logarithm of the curvatures' ratio, and m12 over sqrt(m11 m22).
struct Mismatch {
  Float ratio, turn;

  Mismatch(const Lines& lines, const Float& curvature_ratio, const Ellipse& ellipse) {
    const SquaredWidth squared_width(ellipse);
    Float m11, m12, m22;
    for (const auto& [at, compliance] : lines) {
      const Float width = squared_width.at(at), term = at.weight * compliance / (width * sqrt(width));
      m11 += term * at.cosine * at.cosine;
      m12 += term * at.cosine * at.sine;
      m22 += term * at.sine * at.sine;
    }
    ratio = log(m11 / m22 * curvature_ratio);
    turn = m12 / sqrt(m11 * m22);
  }
};

/// The ellipse whose residuals are 0, by Newton's method. The derivatives are differences over so small a distance that
/// each step about doubles the digits. Nothing if the method does not converge.
std::optional<Ellipse> solve_ellipse(const Lines& lines, const Float& curvature_ratio, Ellipse ellipse) {
  const Float little = sqrt(std::numeric_limits<Float>::epsilon());
  for (int step = 0; step < 60; ++step) {
    const auto at = [&](const Float& p, const Float& q) -> Mismatch {
      return {lines, curvature_ratio, {ellipse.p + p, ellipse.q + q}};
    };
    const Mismatch here = at(0, 0), beside = at(little, 0), above = at(0, little);
    const Float j11 = (beside.ratio - here.ratio) / little, j12 = (above.ratio - here.ratio) / little,
                j21 = (beside.turn - here.turn) / little, j22 = (above.turn - here.turn) / little;
    const Float determinant = j11 * j22 - j12 * j21;
    const Float dp = (here.turn * j12 - here.ratio * j22) / determinant,
                dq = (here.ratio * j21 - here.turn * j11) / determinant;
    const Float length = hypot(dp, dq);
    if (mpfr_number_p(raw(length)) == 0) return std::nullopt;
    const Float part = 1 / std::max(Float(1), length);
    ellipse.p += part * dp;
    ellipse.q += part * dq;
    if (length < little * Float(1e-3)) return ellipse;
  }
  return std::nullopt;
}

constexpr double slenderest = 1e-12;

/// The first approximation: Hertz's axis ratio to within a few per cent, with axes along and across the motion.
Ellipse first_ellipse(const Float& curvature_ratio) { return {Float(0.62) * log(curvature_ratio), 0}; }

/// Directions for first_ellipse(), with a margin, because a peak of the compliance makes the ellipse longer, by up to
/// the inverse of the peak's width.
CrowdedDirections directions_for(const SurfaceAnswer& surface, double curvature_ratio) {
  const auto [degrees, width] = peak_of_compliance(surface);
  const double slenderness = std::exp(-0.7 * std::fabs(std::log(curvature_ratio)));
  const bool is_along = curvature_ratio >= 1;  // If so, singularities are at |tan| = 1/slenderness.
  const double smallest = is_along ? width : std::min(width, slenderness);
  return {Exact(degrees), smallest, 1 / (is_along ? std::min(width, slenderness) : width)};
}

/// The solution for one set of lines: the ellipse, scaled so that a b = 1, and its integrals.
struct Level {
  Ellipse ellipse;
  Float first;   ///< int K/w dpsi
  Float third;   ///< int K/w^3 dpsi
  Float moment;  ///< int K cos^2/w^3 dpsi

  Level(const Ellipse& found, const Lines& lines) : ellipse(found) {
    const SquaredWidth squared_width(found);
    for (const auto& [at, compliance] : lines) {
      const Float square = squared_width.at(at);
      const Float term = at.weight * compliance / sqrt(square);
      first += term;
      third += term / square;
      moment += term / square * at.cosine * at.cosine;
    }
    for (Float* sum : {&first, &third, &moment}) *sum /= static_cast<long>(lines.size());
  }
  [[nodiscard]] Float axis_ratio() const { return exp(-ellipse.eta()); }
  [[nodiscard]] Float stiffness() const { return 8 * pi() / 3 * sqrt(third) / pow(first, Float(1.5)); }
  /// The distance from the centre to the edge.
  [[nodiscard]] Float radius(const Exact& degrees) const {
    const Float psi = to_float(degrees) * pi() / 180, c = cos(psi), s = sin(psi);
    // The half-width of the ellipse turned by 90 degrees is 1 over the radius of this one.
    return 1 / sqrt(SquaredWidth({-ellipse.p, -ellipse.q}).at({degrees, c, s, 1}));
  }
};

/// The solutions with two numbers of directions.
struct TwoLevels {
  Level coarse, fine;
};

/// Doubles the number of lines until the ellipse and its integrals have converged. The caller has checked the curvature
/// ratio; `lines` is `surface` at the working digits.
TwoLevels solve_levels(const SurfaceAnswer& surface, const WorkingSurface& lines,
                       const Exact& curvature_ratio, int digits) {
  const Float curvatures = to_float(curvature_ratio);
  Ellipse ellipse = first_ellipse(curvatures);
  std::optional<Level> coarse, fine;
  const auto agree = [&](const auto& value) {
    return abs(value(*fine) - value(*coarse)) <= tolerance(digits) * abs(value(*fine)) / 10;
  };
  double_directions(
      digits, directions_for(surface, curvature_ratio.approximate()),
      [&](const Exact& degrees) { return lines.at(degrees).compliance; },
      [&](const Lines& compliance) {
        const std::optional<Ellipse> found = solve_ellipse(compliance, curvatures, ellipse);
        if (!found) return false;
        ellipse = *found;
        coarse = fine;
        fine = Level(ellipse, compliance);
        return coarse && agree([](const Level& level) { return level.axis_ratio(); }) &&
               agree([](const Level& level) { return level.first; }) &&
               agree([](const Level& level) { return level.third; }) &&
               agree([](const Level& level) { return level.moment; }) &&
               agree([](const Level& level) { return level.radius(Exact(0.0)); }) &&
               agree([](const Level& level) { return level.radius(Exact(90.0)); });
      });
  return {*coarse, *fine};
}

void check_ratio(const Exact& curvature_ratio) {
  const double ratio = curvature_ratio.approximate();
  if (!(ratio >= slenderest && ratio <= 1 / slenderest))
    throw data::BadInput("curvature_ratio", curvature_ratio.text(), "must lie between 1e-12 and 1e12");
}

Estimate of_ellipse(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits,
                    Float (Level::*value)() const) {
  check_ratio(curvature_ratio);
  const int working = working_digits(digits);
  const WorkingDigits scope(working);
  const auto [coarse, fine] =
      solve_levels(surface, WorkingSurface(surface, working), curvature_ratio, digits);
  return estimated((fine.*value)(), abs((fine.*value)() - (coarse.*value)()), digits);
}

}  // namespace

Estimate elliptic_axis_ratio(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits, &Level::axis_ratio);
}

Estimate elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits, &Level::stiffness);
}

// The contact is the ellipse of a Level multiplied by s. In it the pressure p0 sqrt(1 - ...) causes the displacement
// (p0 s^2/4) int K (1 - (n.x)^2/w^2)/w. With the curvature C along the motion it follows that p0 = 2 s C/moment,
// F = (2 pi/3) p0 s^2 and approach = p0 s first/4.
struct EllipticContact::Implementation {
  HalfSpaceLoad load;
  Float curvature;  ///< along the motion
  int digits, working;
  TwoLevels levels;

  template <class Function>
  [[nodiscard]] Estimate of(const Function& function) const {
    const WorkingDigits scope(working);
    return of_levels(function(levels.fine), function(levels.coarse), digits);
  }
  /// p0/s = 2 C/moment.
  [[nodiscard]] Float pressure_over_scale(const Level& level) const { return 2 * curvature / level.moment; }
  /// Force over the cube of the span along the motion.
  [[nodiscard]] Float factor(const Level& level) const {
    const Float span = 2 * level.radius(Exact(0.0));
    return 2 * pi() / 3 * pressure_over_scale(level) / (span * span * span);
  }
  /// The factor s between the level's ellipse and that of the contact.
  [[nodiscard]] Float scale(const Level& level) const {
    return span_along_of(load, factor(level)) / (2 * level.radius(Exact(0.0)));
  }
};

EllipticContact::EllipticContact(SurfaceAnswer surface, const Indenter& body, const HalfSpaceLoad& load,
                                 int digits) {
  const Exact ratio(mpq_class(body.across.value() / body.along.value()));
  check_ratio(ratio);
  const int working = working_digits(digits);
  const WorkingDigits scope(working);
  implementation_ = std::make_shared<const Implementation>(
      Implementation{load, to_float(body.along), digits, working,
                     solve_levels(surface, WorkingSurface(surface, working), ratio, digits)});
}

Estimate EllipticContact::axis_ratio() const {
  return implementation_->of([](const Level& level) { return level.axis_ratio(); });
}

Estimate EllipticContact::orientation() const {
  const WorkingDigits scope(implementation_->working);
  const auto& [coarse, fine] = implementation_->levels;
  const auto degrees = [](const Ellipse& ellipse) { return Float(180 * ellipse.alpha() / pi()); };
  const Float change = hypot(fine.ellipse.p - coarse.ellipse.p, fine.ellipse.q - coarse.ellipse.q);
  // The error of twice the angle, in radians. Half of it in degrees is 29 turn for small turns, of which 90 turn is an
  // upper bound. If it is not small, any angle is possible.
  const Float turn = (change + tolerance(implementation_->digits + 6)) / fine.ellipse.eta();
  const Float error = turn < Float(0.25) ? Float(90 * turn) : Float(90);
  return {degrees(fine.ellipse), error, implementation_->digits};
}

Estimate EllipticContact::span(const Exact& degrees) const {
  return implementation_->of(
      [&](const Level& level) -> Float { return 2 * implementation_->scale(level) * level.radius(degrees); });
}

Estimate EllipticContact::span_ratio(const Exact& degrees) const {
  return implementation_->of(
      [&](const Level& level) -> Float { return level.radius(degrees) / level.radius(Exact(0.0)); });
}

Estimate EllipticContact::approach() const {
  return implementation_->of([&](const Level& level) -> Float {
    const Float scale = implementation_->scale(level);
    return scale * scale * implementation_->curvature * level.first / (2 * level.moment);
  });
}

Estimate EllipticContact::force() const {
  return implementation_->of(
      [&](const Level& level) { return force_of(implementation_->load, implementation_->factor(level)); });
}

Estimate EllipticContact::peak_pressure() const { return pressure(Exact(0.0), Exact(0.0)); }

Estimate EllipticContact::pressure(const Exact& degrees, const Exact& x) const {
  const WorkingDigits scope(implementation_->working);
  const Float there = to_float(x);
  return with_shifted_ends(implementation_->digits, [&](const Float& change) {
    return implementation_->of([&](const Level& level) -> Float {
      const Float scale = implementation_->scale(level), end = scale * level.radius(degrees);
      const Float ahead = end * (1 + change) - there, behind = end * (1 + change) + there;
      if (!(ahead > Float(0) && behind > Float(0))) return 0;
      return scale * implementation_->pressure_over_scale(level) * sqrt(ahead * behind) / end;
    });
  });
}

EllipticContact::Displacement EllipticContact::displacement(const SurfaceAnswer& half_space,
                                                            const Exact& depth) const {
  if (depth.sign() < 0) throw data::BadInput("depth", depth.text(), "must not be negative");
  const WorkingDigits scope(implementation_->working);
  const WorkingSurface surface(half_space, implementation_->working);
  const PeakOfCompliance peak = peak_of_compliance(half_space);
  const auto lines =
      std::make_shared<const SmoothLines>(surface, peak, depth.sign() > 0, implementation_->digits + 7);
  const Float largest = surface.at(Exact(peak.degrees)).compliance;
  const auto nodes = std::make_shared<const std::vector<UnitPoint>>(unit_nodes(8 * implementation_->working));
  return [contact = implementation_, lines, nodes, largest, depth](const Exact& degrees, const Exact& x) {
    const WorkingDigits working(contact->working);
    const auto pressed = [&](const Level& level) -> EllipticPressure {
      const Float scale = contact->scale(level), root = exp(Float(level.ellipse.eta() / 2));
      return {scale * root, scale / root, level.ellipse.alpha(),
              scale * 2 * contact->curvature / level.moment};
    };
    const EllipticPressure fine = pressed(contact->levels.fine), coarse = pressed(contact->levels.coarse);
    const Float psi = to_float(degrees) * pi() / 180;
    const Displaced found = displacement_under({fine, coarse}, *lines, {psi, to_float(x), to_float(depth)},
                                               *nodes, contact->digits);
    // The rounding error, the stretches that are left out because they are shorter than the rounding error of an angle,
    // and the error of the polynomials, which is a tenth of this. All are relative to the size of all lines together.
    const Float rounding = tolerance(contact->digits + 6) * fine.peak * fine.a * largest;
    const auto estimate = [&](std::size_t i) -> Estimate {
      return {found.value[i], found.error[i] + rounding, contact->digits};
    };
    return std::array{estimate(0), estimate(1), estimate(2)};
  };
}

}  // namespace nipref::ref
