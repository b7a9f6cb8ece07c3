#include <algorithm>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>

namespace nipref::ref {
namespace {

/// Digits that K K_nn - S^2 may lose to cancellation: twice those that it loses at the double next to the critical
/// speed.
constexpr int cancelled_digits = 32;

/// K K_nn - S^2, which is 1/det M of both components: near the critical speed K K_nn and S^2 are larger by a factor as
/// large as the inverse of the relative distance from that speed. BadInput where they lose more than cancelled_digits.
Float determinant_of(const LineAnswer& line) {
  const Float product = line.compliance * line.in_line, rest = product - line.coupling * line.coupling;
  if (!(abs(rest) > tolerance(cancelled_digits) * abs(product)))
    throw data::BadInput("speed", "(next to the critical speed)", "must be farther from it");
  return rest;
}

/// One line of a rolling contact.
struct RollingLine {
  Float index;      ///< P
  Float slowness;   ///< sqrt(wS/wD) = sqrt(K_nn/K)
  Float stiffness;  ///< sqrt(K_nn/K/(K K_nn - S^2)); amplitudes are proportional to this times the span

  RollingLine(const WorkingSurface& surface, const Exact& degrees) {
    const LineAnswer line = surface.at(degrees);
    const Float product = line.compliance * line.in_line;
    index = atanh(line.coupling / sqrt(product)) / pi();
    slowness = sqrt(line.in_line / line.compliance);
    stiffness = slowness / sqrt(determinant_of(line));
  }
};

/// B = sqrt(wS/wD) - P L/(2 r0) of a line of span L; BadInput unless B > 0. (brock2012 49)
Float lean_of(const RollingLine& line, const Float& span_over_radius) {
  const Float lean = line.slowness - line.index * span_over_radius / 2;
  if (!(lean > Float(0)))
    throw data::BadInput("span", static_cast<double>(span_over_radius), "must be small against the radius");
  return lean;
}

/// exp(-pi/(2P))
Float strip_of(const Float& index) { return index > Float(0) ? Float(exp(-pi() / (2 * index))) : Float(0); }

/// (brock2012 48)
Float creep_of(const RollingLine& line, const Float& span_over_radius) {
  lean_of(line, span_over_radius);
  return span_over_radius *
         (span_over_radius / 16 * (1 - 4 * line.index * line.index) + line.index * line.slowness);
}

/// int_0^1 t sqrt(1 - t^2) cos(P ln((1 - t)/(1 + t))) dt
Float oscillating_moment(const Float& index, const std::vector<UnitPoint>& nodes) {
  Float sum = 0;
  for (const auto& [t, rest, weight] : nodes)
    sum += weight * t * sqrt(rest * (1 + t)) * cos(index * log(rest / (1 + t)));
  return sum;
}

template <class Of>
Estimate of_rolling_lines(const SurfaceAnswer& surface, int digits, const Of& of) {
  return of_lines(surface, digits, of, cancelled_digits);
}

}  // namespace

Estimate rolling_index(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return of_rolling_lines(surface, digits,
                          [&](const WorkingSurface& lines) { return RollingLine(lines, degrees).index; });
}

Estimate rolling_index_beyond(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return of_rolling_lines(surface, digits, [&](const WorkingSurface& lines) -> Float {
    const LineAnswer line = lines.at(degrees);
    (void)determinant_of(line);
    return atanh(sqrt(line.compliance * line.in_line) / abs(line.coupling)) / pi();
  });
}

Estimate rolling_span_ratio(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return of_rolling_lines(surface, digits, [&](const WorkingSurface& lines) -> Float {
    return RollingLine(lines, Exact(0.0)).stiffness / RollingLine(lines, degrees).stiffness;
  });
}

Estimate rolling_finite_span_ratio(const SurfaceAnswer& surface, const Exact& degrees,
                                   const Exact& span_over_radius, int digits) {
  return of_rolling_lines(surface, digits, [&](const WorkingSurface& lines) -> Float {
    const RollingLine along(lines, Exact(0.0)), line(lines, degrees);
    const Float span = to_float(span_over_radius), first = along.stiffness / along.slowness,
                second = line.stiffness / line.slowness;
    const Float same = lean_of(along, span) * first / second;  // over the span
    const Float square = line.slowness * line.slowness - 2 * line.index * same * span;
    if (!(square > Float(0)))
      throw data::BadInput("span_over_radius", span_over_radius.text(), "must be small");
    return 2 * same / (line.slowness + sqrt(square));
  });
}

Estimate rolling_strip(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return of_rolling_lines(surface, digits, [&](const WorkingSurface& lines) {
    return strip_of(RollingLine(lines, degrees).index);
  });
}

Estimate rolling_force(const SurfaceAnswer& surface, int digits) {
  return RollingSphere(surface, 1, data::GivenSpan{1}, digits).force();
}

Estimate rolling_creep(const SurfaceAnswer& surface, const Exact& degrees, const Exact& span_over_radius,
                       int digits) {
  return of_rolling_lines(surface, digits, [&](const WorkingSurface& lines) {
    const RollingLine along(lines, Exact(0.0)), line(lines, degrees);
    return creep_of(line, to_float(span_over_radius) * along.stiffness / line.stiffness);
  });
}

struct RollingSphere::Implementation final : ScaledContact {
  const double radius;

  Implementation(SurfaceAnswer answer, double of_radius, const HalfSpaceLoad& given, int asked)
      : ScaledContact(std::move(answer), given, asked, cancelled_digits), radius(of_radius) {}

  [[nodiscard]] Float ratio(const Exact& degrees) const override {
    return RollingLine(lines(), Exact(0.0)).stiffness / RollingLine(lines(), degrees).stiffness;
  }
  /// (brock2012 54)
  [[nodiscard]] Levels integrated() const override {
    const auto [peak, width] = peak_of_compliance(surface);
    const std::vector<UnitPoint> nodes = unit_nodes(working);
    const Float along = RollingLine(lines(), Exact(0.0)).stiffness, unit = along / (4 * Float(radius));
    const auto [fine, coarse] =
        half_turn_integral(digits, {Exact(peak), width, 1}, [&](const Exact& degrees) -> Float {
          const RollingLine line(lines(), degrees);
          const Float share = along / line.stiffness;
          return share * share * oscillating_moment(line.index, nodes);
        });
    if (std::holds_alternative<data::GivenNormalForce>(load) && !(fine > Float(0)))
      throw data::BadInput("speed", "(near the Rayleigh speed)",
                           "must be farther below it: here the tractions pull");
    return {unit * fine, unit * coarse};
  }
  /// The traction at x: the amplitude times wave(line, sin phi, cos phi, tan Phi), where phi = P ln((L - 2x)/(L + 2x))
  /// and tan Phi = x/(2 r0 B). Errors of the contact's ends act on the square root in the amplitude and on phi.
  template <class Wave>
  [[nodiscard]] Estimate traction(const Exact& degrees, const Exact& x, const Wave& wave) const {
    const WorkingDigits scope(working);
    const RollingLine line(lines(), degrees);
    const Float there = to_float(x), span_ratio = ratio(degrees);
    const auto at = [&](const Float& change, const Float& along) -> Float {
      const Float span = span_ratio * along, lean = lean_of(line, span / Float(radius));
      const Float ahead = span * (1 + change) - 2 * there, behind = span * (1 + change) + 2 * there;
      if (!(ahead > Float(0) && behind > Float(0))) return 0;
      const Float phase = line.index * log(ahead / behind), slope = there / (2 * Float(radius) * lean);
      const Float size = lean * line.stiffness / (line.slowness * 2 * Float(radius));
      return size * sqrt(ahead * behind) * wave(line, sin(phase), cos(phase), slope);
    };
    return with_shifted_ends(digits, [&](const Float& change) {
      return function_of_span([&](const Float& along) { return at(change, along); });
    });
  }
};

RollingSphere::RollingSphere(SurfaceAnswer surface, double radius, const HalfSpaceLoad& load, int digits)
    : implementation_(std::make_shared<const Implementation>(std::move(surface), radius, load, digits)) {}

Estimate RollingSphere::span_ratio(const Exact& degrees) const {
  return implementation_->span_ratio(degrees);
}
Estimate RollingSphere::span(const Exact& degrees) const { return implementation_->span(degrees); }
Estimate RollingSphere::force() const { return implementation_->force(); }

Estimate RollingSphere::peak_pressure() const { return pressure(Exact(0.0), Exact(0.0)); }

Estimate RollingSphere::pressure(const Exact& degrees, const Exact& x) const {
  return implementation_->traction(degrees, x,
                                   [](const RollingLine&, const Float& sine, const Float& cosine,
                                      const Float& slope) -> Float { return cosine - slope * sine; });
}

Estimate RollingSphere::shear(const Exact& degrees, const Exact& x) const {
  return implementation_->traction(
      degrees, x,
      [](const RollingLine& line, const Float& sine, const Float& cosine, const Float& slope) -> Float {
        return (sine + slope * cosine) / line.slowness;
      });
}

Estimate RollingSphere::creep(const Exact& degrees) const {
  const WorkingDigits scope(implementation_->working);
  const RollingLine line(implementation_->lines(), degrees);
  const Float ratio = implementation_->ratio(degrees) / Float(implementation_->radius);
  return implementation_->function_of_span([&](const Float& along) { return creep_of(line, ratio * along); });
}

Estimate RollingSphere::compressed_radius(const Exact& degrees) const {
  const WorkingDigits scope(implementation_->working);
  const RollingLine line(implementation_->lines(), degrees);
  const Float ratio = implementation_->ratio(degrees) / 2;
  const Float strip = strip_of(line.index), share = (1 - strip) / (1 + strip);
  return implementation_->function_of_span(
      [&](const Float& along) -> Float { return share * ratio * along; });
}

}  // namespace nipref::ref
