#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/half_space/sliding.hpp>

namespace nipref::ref {
namespace {

/// cos of an angle in degrees, exactly 0 across.
Float cosine(const Exact& degrees) {
  mpq_class from_90 = 90 - abs(degrees.value());
  return sin(to_float(Exact(from_90)) * pi() / 180);
}

Float sine(const Exact& degrees) { return sin(to_float(degrees) * pi() / 180); }

/// One line of a sliding contact.
struct SlidingLine {
  Float omega;
  Float
      h;  ///< sqrt(K^2 + (friction (cos(psi) S - sin(psi) S'))^2), K with what friction adds of shear compliances

  SlidingLine(const WorkingSurface& surface, const Exact& friction, const Exact& degrees) {
    const WorkingAnswer answer = surface.at(degrees);
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
    omega = atan(shear / compliance) / pi() - Float(0.5);
    h = sqrt(compliance * compliance + shear * shear);
  }
  /// Q = (1 + Omega)^(1 + Omega) (-Omega)^(-Omega): peak of the pressure over span/h and curvature.
  [[nodiscard]] Float Q() const { return pow(1 + omega, 1 + omega) * pow(-omega, -omega); }
};

/// int |x| (x+ - x)^(1 + Omega) (x - x-)^(-Omega) dx for span 1, cut at the kink x = 0.
Float line_moment(const Float& omega, int digits) {
  const Float ahead = -omega, behind = 1 + omega;
  const Float front = unit_integral(digits, [&](const Float& left, const Float& right) {
    const Float x = ahead * left;
    return ahead * x * pow(ahead * right, behind) * pow(x + behind, ahead);
  });
  const Float back = unit_integral(digits, [&](const Float& left, const Float& right) {
    const Float x = behind * left;
    return behind * x * pow(ahead + x, behind) * pow(behind * right, ahead);
  });
  return front + back;
}

/// Of the body along a line.
Float curvature_of(const Indenter& body, const Exact& degrees) {
  const Float c = cosine(degrees), s = sine(degrees);
  return to_float(body.along) * c * c + to_float(body.across) * s * s;
}

/// The curvature has a zero at tan = i sqrt(along/across).
CrowdedDirections directions_for(const PeakOfCompliance& peak, const Indenter& body) {
  const Float slenderness = sqrt(to_float(body.along) / to_float(body.across)), width = peak.width;
  return {Exact(peak.degrees), std::min(width, slenderness), std::max(Float(1), slenderness)};
}

/// In force = factor span^3, stresses as `lines` count them.
Levels force_factor(const WorkingSurface& lines, const CrowdedDirections& directions, const Exact& friction,
                    const Indenter& body, int digits, int working) {
  const SlidingLine along(lines, friction, Exact(0.0));
  const Float steepness = to_float(body.along) * along.Q() / along.h;
  // On a line of span L and curvature C the pressure is (C/h) L times that of span 1, and L = steepness h/(C Q).
  return half_turn_integral(digits, directions, [&](const Exact& degrees) -> Float {
    const SlidingLine line(lines, friction, degrees);
    const Float curvature = curvature_of(body, degrees);
    const Float span = steepness * line.h / (curvature * line.Q());
    return curvature * pow(span, 3) / line.h * line_moment(line.omega, working);
  });
}
}  // namespace

Estimated sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                           int digits) {
  return with_digits(digits, [&](int working) {
    return closed(SlidingLine(WorkingSurface(surface, working), friction, degrees).omega, digits);
  });
}

Estimated sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                             int digits) {
  return with_digits(digits, [&](int working) {
    const WorkingSurface lines(surface, working);
    const SlidingLine along(lines, friction, Exact(0.0)), line(lines, friction, degrees);
    return closed(along.Q() / line.Q() * line.h / along.h, digits);
  });
}

Estimated sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits) {
  return with_digits(digits, [&](int working) {
    const WorkingSurface lines(surface, working);
    const Indenter unit{Exact(1.0), Exact(1.0)};
    const CrowdedDirections directions = directions_for(peak_of_compliance(surface), unit);
    const auto [fine, coarse] = force_factor(lines, directions, friction, unit, digits, working);
    return estimated(fine, abs(fine - coarse), digits);
  });
}

struct SlidingContact::Implementation {
  SurfaceAnswer surface;
  Indenter body;
  Exact friction;
  HalfSpaceLoad load;
  int digits;
  int working = 0;
  long exponent = 0;
  Float steepness = {};                       ///< peak pressure over span
  mutable std::optional<Levels> factor = {};  ///< in force = factor span^3, when it is first asked for

  [[nodiscard]] WorkingSurface lines() const { return {surface, working, exponent}; }
  /// Of the papers' rule: A(0) Q(0) h/(A Q h(0)).
  [[nodiscard]] Float ratio(const Exact& degrees) const {
    const SlidingLine line(lines(), friction, degrees);
    return steepness_in_unit() * line.h / (curvature_of(body, degrees) * line.Q());
  }
  [[nodiscard]] Float steepness_in_unit() const { return ldexp(steepness, -exponent); }
  /// A function of the factor.
  template <class Function>
  [[nodiscard]] Estimated of_factor(const Function& function) const {
    const WorkingDigits scope(working);
    if (!factor) {
      const CrowdedDirections directions = directions_for(peak_of_compliance(surface), body);
      const auto [fine, coarse] = force_factor(lines(), directions, friction, body, digits, working);
      factor = {ldexp(fine, exponent), ldexp(coarse, exponent)};
    }
    return of_levels(function(factor->fine), function(factor->coarse), digits);
  }
  /// A function of the span along the motion.
  template <class Function>
  [[nodiscard]] Estimated of_span(const Function& function) const {
    if (const auto* given = std::get_if<data::GivenSpan>(&load)) {
      const WorkingDigits scope(working);
      const Float value = function(Float(given->along));
      return of_levels(value, value, digits);
    }
    return of_factor([&](const Float& force) { return function(span_along_of(load, force)); });
  }
};

SlidingContact::SlidingContact(SurfaceAnswer surface, const Indenter& body, const Exact& friction,
                               const HalfSpaceLoad& load, int digits) {
  Implementation made{std::move(surface), body, friction, load, digits};
  made.working = working_digits(digits);
  made.exponent = stress_exponent(made.surface);
  const WorkingDigits scope(made.working);
  const SlidingLine along(made.lines(), friction, Exact(0.0));
  made.steepness = ldexp(to_float(body.along) * along.Q() / along.h, made.exponent);
  implementation_ = std::make_shared<const Implementation>(std::move(made));
}

Estimated SlidingContact::span_ratio(const Exact& degrees) const {
  const WorkingDigits scope(implementation_->working);
  const Float ratio = implementation_->ratio(degrees);
  return of_levels(ratio, ratio, implementation_->digits);
}

Estimated SlidingContact::span(const Exact& degrees) const {
  const WorkingDigits scope(implementation_->working);
  const Float ratio = implementation_->ratio(degrees);
  return implementation_->of_span([&](const Float& along) -> Float { return ratio * along; });
}

Estimated SlidingContact::force() const {
  return implementation_->of_factor(
      [&](const Float& factor) { return force_of(implementation_->load, factor); });
}

Estimated SlidingContact::friction_force() const {
  return implementation_->of_factor([&](const Float& factor) -> Float {
    return to_float(implementation_->friction) * force_of(implementation_->load, factor);
  });
}

Estimated SlidingContact::peak_pressure() const {
  return implementation_->of_span(
      [&](const Float& along) -> Float { return implementation_->steepness * along; });
}

}  // namespace nipref::ref
