#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/half_space/sliding.hpp>

namespace nipref::ref {
namespace {

/// The cosine of an angle in degrees, exactly 0 at 90 degrees.
Float cosine(const Exact& degrees) {
  mpq_class from_90 = 90 - abs(degrees.value());
  return sin(to_float(from_90) * pi() / 180);
}

Float sine(const Exact& degrees) { return sin(to_float(degrees) * pi() / 180); }

/// For larger coefficients the pressure changes within so small an angle about the direction across the motion that the
/// integrals take minutes.
constexpr int greatest_friction = 1000;

void check_friction(const Exact& friction) {
  if (friction.sign() < 0 || friction.value() > greatest_friction)
    throw data::BadInput("friction", friction.text(), "must be from 0 to 1000");
}

/// The angle of (x, y), y > 0, in half turns; the relative error is small even for the smallest angles.
Float half_turns(const Float& y, const Float& x) { return atan2(y, x) / pi(); }

/// One line of a sliding contact. `ahead` and `behind` have small relative errors, however small they are.
struct SlidingLine {
  Float ahead;         ///< -Omega, the part of the span ahead of x = 0
  Float behind;        ///< 1 + Omega, the part of the span behind x = 0
  Float shear_over_K;  ///< friction (cos(psi) S - sin(psi) S')/K
  Float h;             ///< sqrt(K^2 + (friction (cos(psi) S - sin(psi) S'))^2)

  SlidingLine(const WorkingSurface& surface, const Exact& friction, const Exact& degrees) {
    const LineAnswer answer = surface.at(degrees);
    const auto of_friction = [&](const Float& along, const Float& across) -> Float {
      return to_float(friction) * (cosine(degrees) * along - sine(degrees) * across);
    };
    const Float shear = of_friction(answer.coupling, answer.coupling_across);
    const Float compliance =
        answer.compliance + of_friction(answer.shear_compliance, answer.shear_compliance_across);
    if (!(compliance > Float(0))) {
      throw data::BadInput("friction", friction.text(),
                           "must be smaller: the shear compliance of the surface outweighs the compliance");
    }
    shear_over_K = shear / compliance;
    ahead = half_turns(compliance, shear);
    behind = half_turns(compliance, -shear);
    h = sqrt(compliance * compliance + shear * shear);
  }
  /// Q = (1 + Omega)^(1 + Omega) (-Omega)^(-Omega). The peak pressure is Q curvature span/h.
  [[nodiscard]] Float Q() const { return pow(behind, behind) * pow(ahead, ahead); }
};

/// int |x|^power (x+ - x)^(1 + Omega) (x - x-)^(-Omega) dx for span 1 and power 1 or 2, over x > 0 and over x < 0.
struct LineMoment {
  Float front, back;
};
/// The moment of x > 0, with x = ahead (1 - w) and the power series of (x + behind)^ahead = (1 - ahead w)^ahead, whose
/// terms decrease like ahead^n. The moment of x < 0 is the same with `ahead` and `behind` exchanged.
Float moment_ahead(const Float& ahead, const Float& behind, int power) {
  Float sum = 0, coefficient = 1, term = 1;
  for (long n = 0; abs(term) > std::numeric_limits<Float>::epsilon() * sum; ++n) {
    // int (1 - w)^power w^(behind + n) dw
    const Float from = behind + n;
    term = coefficient * power / ((from + 1) * (from + 2));
    if (power == 2) term /= from + 3;
    sum += term;
    coefficient *= ahead * (n - ahead) / (n + 1);
  }
  return sum * pow(ahead, power + 1 + behind);
}

/// The series gives the moment of the shorter side. The moment of the longer side is the rest of Euler's beta integral
/// int x^power v^a (1 - v)^b dv over 0 < v < 1, v = x + b.
LineMoment line_moment(const SlidingLine& line, int power) {
  const bool leads = line.ahead > line.behind;
  const Float &a = leads ? line.ahead : line.behind, &b = leads ? line.behind : line.ahead;
  const Float shorter = moment_ahead(b, a, power), size = a * b * pi() / (2 * sin(pi() * b));
  const Float longer = power == 1
                           ? Float(size * (4 * a - 2) / 3 + shorter)
                           : Float(size * ((1 + a) * (2 + a) / 12 - 2 * b * (1 + a) / 3 + b * b) - shorter);
  return leads ? LineMoment{longer, shorter} : LineMoment{shorter, longer};
}

/// The curvature of the body along a line.
Float curvature_of(const Indenter& body, const Exact& degrees) {
  const Float c = cosine(degrees), s = sine(degrees);
  return to_float(body.along) * c * c + to_float(body.across) * s * s;
}

}  // namespace

Estimate sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                          int digits) {
  check_friction(friction);
  return of_lines(surface, digits, [&](const WorkingSurface& lines) -> Float {
    return -SlidingLine(lines, friction, degrees).ahead;
  });
}

Estimate sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                            int digits) {
  check_friction(friction);
  return of_lines(surface, digits, [&](const WorkingSurface& lines) -> Float {
    const SlidingLine along(lines, friction, Exact(0.0)), line(lines, friction, degrees);
    return along.Q() / line.Q() * line.h / along.h;
  });
}

Estimate sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits) {
  return SlidingContact(surface, {Exact(1.0), Exact(1.0)}, friction, data::GivenSpan{1}, digits).force();
}

struct SlidingContact::Implementation final : ScaledContact {
  const Indenter body;
  const Exact friction;
  const SpanRule rule;

  Implementation(SurfaceAnswer answer, Indenter of_body, Exact coefficient, const HalfSpaceLoad& given,
                 int asked, SpanRule by_rule)
      : ScaledContact(std::move(answer), given, asked, 0),
        body(std::move(of_body)),
        friction(std::move(coefficient)),
        rule(by_rule) {}

  [[nodiscard]] SlidingLine line_at(const Exact& degrees) const { return {lines(), friction, degrees}; }
  [[nodiscard]] Float ratio(const Exact& degrees) const override {
    return ratio(line_at(Exact(0.0)), line_at(degrees), degrees);
  }
  /// L(psi)/L(0).
  [[nodiscard]] Float ratio(const SlidingLine& along, const SlidingLine& line, const Exact& degrees) const {
    const Float relative = to_float(body.along) / curvature_of(body, degrees);
    if (rule == SpanRule::similar_contour) return sqrt(relative);
    return relative * along.Q() / along.h * line.h / line.Q();
  }
  /// The peak pressure over the span.
  [[nodiscard]] Float steepness_of(const SlidingLine& line, const Exact& degrees) const {
    return curvature_of(body, degrees) * line.Q() / line.h;
  }
  [[nodiscard]] Levels integrated() const override {
    return pressure_integral(
        1, [](const LineMoment& moment, const Exact&) -> Float { return moment.front + moment.back; });
  }
  /// A coordinate of the centre of pressure. component(degrees) is the component along a line of the coordinate's
  /// direction. The moment may vanish, so that it cannot be integrated to a relative error. It is therefore the
  /// difference of two integrals that do not vanish: of pressure |x| plus the moment, and of pressure |x|.
  [[nodiscard]] Estimate centre(const std::function<Float(const Exact& degrees)>& component) const {
    const WorkingDigits scope(working);
    const auto integral = [&](bool with_moment) {
      return pressure_integral(2, [&](const LineMoment& moment, const Exact& degrees) -> Float {
        const Float all = moment.front + moment.back;
        return with_moment ? Float(all + (moment.front - moment.back) * component(degrees)) : all;
      });
    };
    const Levels both = integral(true), size = integral(false);
    const Float fine = both.fine - size.fine, coarse = both.coarse - size.coarse;
    // The integrals may have different numbers of directions, so that their errors add.
    const Float apart = abs(both.fine - both.coarse) + abs(size.fine - size.coarse);
    Estimate result = function_of_factor(
        [&](const Float& force) -> Float { return fine / force * span_along_of(load, force); });
    const Estimate along = function_of_span([](const Float& span) { return span; });
    const Float span = at_working_precision(along.value), per_force = span / factor().fine;
    const Float error = at_working_precision(result.error) + abs(per_force) * (apart + abs(fine - coarse)) +
                        tolerance(digits + 6) * abs(span);
    return {result.value, error, digits};
  }

 private:
  /// The directions for the singularities of the integrand, computed at the first call. The singularities are where the
  /// curvature is 0, tan = i sqrt(along/across), and where h is 0, close to tan = i friction S/K.
  [[nodiscard]] const CrowdedDirections& directions(const SlidingLine& along) const {
    if (!directions_) {
      const auto [peak, width] = peak_of_compliance(surface);
      const Float slenderness = sqrt(to_float(body.along) / to_float(body.across));
      directions_.emplace(Exact(peak), std::min(Float(width), slenderness),
                          std::max({Float(1), slenderness, Float(abs(along.shear_over_K))}));
    }
    return *directions_;
  }

  using LineWeight = std::function<Float(const LineMoment& moment, const Exact& degrees)>;
  /// The integral over the lines of (C/h) (L(psi)/L(0))^(power + 2) weight(moments of |x|^power) with the curvature C
  /// of a line, which the caller multiplies by L(0)^(power + 2). The moments are those of LineMoment, whose pressure is
  /// multiplied by (C/h) L on a line of span L.
  [[nodiscard]] Levels pressure_integral(int power, const LineWeight& weight) const {
    const SlidingLine along = line_at(Exact(0.0));
    // Without friction the moment is the same on all lines.
    const LineMoment moment_along = line_moment(along, power);
    return half_turn_integral(digits, directions(along), [&](const Exact& degrees) -> Float {
      const SlidingLine line = line_at(degrees);
      const LineMoment moment = line.ahead == along.ahead ? moment_along : line_moment(line, power);
      return curvature_of(body, degrees) * pow(ratio(along, line, degrees), power + 2) / line.h *
             weight(moment, degrees);
    });
  }

  mutable std::optional<CrowdedDirections> directions_;
};

SlidingContact::SlidingContact(SurfaceAnswer surface, const Indenter& body, const Exact& friction,
                               const HalfSpaceLoad& load, int digits, SpanRule rule) {
  check_friction(friction);
  implementation_ =
      std::make_shared<const Implementation>(std::move(surface), body, friction, load, digits, rule);
  const WorkingDigits scope(implementation_->working);
  (void)implementation_->line_at(Exact(0.0));  // Throws BadInput if the friction is too large.
}

Estimate SlidingContact::span_ratio(const Exact& degrees) const {
  return implementation_->span_ratio(degrees);
}
Estimate SlidingContact::span(const Exact& degrees) const { return implementation_->span(degrees); }
Estimate SlidingContact::force() const { return implementation_->force(); }
Estimate SlidingContact::peak_pressure() const { return peak_pressure(Exact(0.0)); }

Estimate SlidingContact::peak_pressure(const Exact& degrees) const {
  const WorkingDigits scope(implementation_->working);
  const SlidingLine line = implementation_->line_at(degrees);
  const Float steepness = implementation_->steepness_of(line, degrees),
              ratio = implementation_->ratio(degrees);
  return implementation_->function_of_span(
      [&](const Float& along) -> Float { return steepness * ratio * along; });
}

Estimate SlidingContact::leading_end(const Exact& degrees) const {
  const WorkingDigits scope(implementation_->working);
  const Float share = implementation_->line_at(degrees).ahead;
  const Float ratio = implementation_->ratio(degrees);
  return implementation_->function_of_span(
      [&](const Float& along) -> Float { return share * ratio * along; });
}

Estimate SlidingContact::pressure(const Exact& degrees, const Exact& x) const {
  const WorkingDigits scope(implementation_->working);
  const SlidingLine line = implementation_->line_at(degrees);
  const Float &lead = line.ahead, &trail = line.behind;
  const Float ratio = implementation_->ratio(degrees);
  const Float there = to_float(x), steepness = implementation_->steepness_of(line, degrees);
  const auto at = [&](const Float& change, const Float& along) -> Float {
    const Float span = ratio * along;
    const Float ahead = lead * span - there + change * span, behind = there + trail * span + change * span;
    if (!(ahead > Float(0) && behind > Float(0))) return 0;
    return steepness * span * pow(ahead / (trail * span), trail) * pow(behind / (lead * span), lead);
  };
  return with_shifted_ends(implementation_->digits, [&](const Float& change) {
    return implementation_->function_of_span([&](const Float& along) { return at(change, along); });
  });
}

Estimate SlidingContact::centre_along() const {
  const WorkingDigits scope(implementation_->working);
  return implementation_->centre([](const Exact& degrees) { return cosine(degrees); });
}

Estimate SlidingContact::centre_across() const {
  const WorkingDigits scope(implementation_->working);
  return implementation_->centre([](const Exact& degrees) { return sine(degrees); });
}

}  // namespace nipref::ref
