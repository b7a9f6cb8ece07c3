// Contacts on half-spaces: by the papers' rule, and the exact ellipse.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "fast/elliptic_contact.hpp"
#include "fast/isotropic_half_space.hpp"
#include "fast/rolling_sphere.hpp"
#include "fast/sliding_contact.hpp"
#include "fast/transversely_isotropic_half_space.hpp"
#include "ref/half_space_contact.hpp"
#include "ref/surface_response.hpp"
#include "verify/entries.hpp"
#include "verify/half_space_arguments.hpp"

namespace nipref::verify {
namespace {

using fast::Accuracy;
using fast::Direction;
using ref::Exact;

/// The audit keeps so far from the critical speed: nearer the condition of a contact exceeds any constant.
constexpr double largest_share = 0.9;

Quantity contact_entry(std::string name, std::string definition, std::string source, double promise) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = std::move(source);
  entry.scale = "the value";
  entry.promise = promise;
  entry.envelope = [](Doubles) { return 0.0; };
  entry.audit_points = 20;
  entry.timed_alone = false;
  return entry;
}

// Arguments of the isotropic entries begin with poisson, speed.

Point draw_isotropic(Random& random) {
  const double poisson = random.uniform(-0.5, 0.49);
  return {poisson, random.uniform(0, largest_share) * fast::isotropic_rayleigh_speed(poisson)};
}

void keep_isotropic_off(Point& x) {
  x[0] = std::clamp(x[0], -0.5, 0.49);
  x[1] = std::min(x[1], largest_share * fast::isotropic_rayleigh_speed(x[0]));
}

std::vector<Argument> isotropic_arguments() {
  return {{"poisson", ArgumentKind::poisson, {}, {}}, {"speed", ArgumentKind::nonnegative, {}, {}}};
}

Argument friction_argument() { return {"friction", ArgumentKind::nonnegative, {}, {}}; }
Argument psi_argument() { return {"psi_deg", ArgumentKind::degrees, "0", {}}; }

/// A sphere of curvature 1 with a span of 1 along the motion.
fast::SlidingContact slide(Doubles x, double friction) {
  return fast::sliding_for_span(isotropic_surface(x[0], x[1]), {1, 1}, friction, {1, 0}, 1);
}

fast::RollingSphere roll(Doubles x) {
  return fast::rolling_sphere_for_span(unit_isotropic(x[0]), 1, x[1], 1e-3);
}

template <class Draw>
void drawn_with(Quantity& entry, Draw more) {
  entry.draw = [more](Random& random) {
    Point x = draw_isotropic(random);
    for (const double value : more(random)) x.push_back(value);
    return x;
  };
  entry.keep_off = keep_isotropic_off;
}

double draw_friction(Random& random) { return random.chance(0.2) ? 0 : random.uniform(0, 1); }
double draw_angle(Random& random) { return random.uniform(-90, 90); }

Quantity entry_exponent() {
  Quantity entry = contact_entry(
      "die.exponent", "Omega: the pressure of a sliding die ends like (x+ - x)^(1 + Omega) (x - x-)^(-Omega)",
      "brock2012 (26a)", 8);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(friction_argument());
  entry.arguments.push_back(psi_argument());
  drawn_with(entry, [](Random& random) { return Point{draw_friction(random), draw_angle(random)}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_exponent(exact_isotropic_surface(x[0], x[1]), x[2], x[3], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return -slide(x, x[2]).along(direction_of_degrees(x[3])).leading_share;
  });
  return entry;
}

Quantity entry_die_span_ratio() {
  Quantity entry = contact_entry(
      "die.span_ratio", "C2 L2/(C1 L1): span across over span along a sliding die, by the papers' rule",
      "brock2012 (34a), (35) corrected", 16);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(friction_argument());
  drawn_with(entry, [](Random& random) { return Point{draw_friction(random)}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_span_ratio(exact_isotropic_surface(x[0], x[1]), x[2], Exact(90.0), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return slide(x, x[2]).span_ratio({0, 1}); });
  return entry;
}

Quantity entry_die_force() {
  Quantity entry =
      contact_entry("die.force", "F3 sqrt(C3)/(mu C L1^3) of a die with C1 = C2 = C, by the papers' rule",
                    "brock2012 (36)", 32);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(friction_argument());
  entry.audit_points = 6;
  drawn_with(entry, [](Random& random) { return Point{draw_friction(random)}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_force(exact_isotropic_surface(x[0], x[1]), x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return slide(x, x[2]).force().value; });
  return entry;
}

Quantity entry_rolling_index() {
  Quantity entry = contact_entry(
      "rolling.index", "P: tractions of a rolling sphere end like sin and cos of P ln((L - 2x)/(L + 2x))",
      "brock2012 (43b)", 16);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(psi_argument());
  drawn_with(entry, [](Random& random) { return Point{draw_angle(random)}; });
  // It vanishes at nu = 1/2, at rest.
  entry.scale = "1/10 or the value";
  entry.envelope = [](Doubles) { return 0.1; };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::rolling_index(exact_isotropic_surface(x[0], x[1]), x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return roll(x).along(direction_of_degrees(x[2])).index; });
  return entry;
}

Quantity entry_rolling_span_ratio() {
  Quantity entry = contact_entry("rolling.span_ratio",
                                 "L2/L1: span across over span along a rolling sphere, by the papers' rule",
                                 "brock2012 (53b) corrected", 16);
  entry.arguments = isotropic_arguments();
  drawn_with(entry, [](Random&) { return Point{}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::rolling_span_ratio(exact_isotropic_surface(x[0], x[1]), Exact(90.0), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return roll(x).span_ratio({0, 1}); });
  return entry;
}

Quantity entry_axis_ratio() {
  Quantity entry =
      contact_entry("ellipse.axis_ratio",
                    "minor over major axis of the exact frictionless contact of a rigid sphere that slides",
                    "notes on brock2012 (31)", 64);
  entry.arguments = isotropic_arguments();
  entry.audit_points = 6;
  drawn_with(entry, [](Random&) { return Point{}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::elliptic_axis_ratio(exact_isotropic_surface(x[0], x[1]), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::EllipticContact(isotropic_surface(x[0], x[1]), {1, 1}).axis_ratio().value;
  });
  return entry;
}

Quantity entry_stiffness() {
  Quantity entry = contact_entry(
      "ellipse.stiffness",
      "F/(mu sqrt(r0) delta^(3/2)) of the exact frictionless contact of a rigid sphere that slides, "
      "delta its approach",
      "notes on brock2012 (31)", 128);  // the solver stops at 64
  entry.arguments = isotropic_arguments();
  entry.audit_points = 6;
  drawn_with(entry, [](Random&) { return Point{}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::elliptic_stiffness(exact_isotropic_surface(x[0], x[1]), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::EllipticContact(isotropic_surface(x[0], x[1]), {1, 1}).for_approach(1).force.value;
  });
  return entry;
}

// The seed's steel sphere on a transversely isotropic half-space: theta_deg, speed, then the entry's own
// argument and the solid. The patch moves in the sphere, as in the seed.

constexpr std::size_t solid_at = 3;

/// By the angle from the motion.
fast::SurfaceResponse seed_contact(Doubles x) {
  const Direction motion = direction_of_degrees(x[0]);
  const auto surface = std::make_shared<const fast::TransverselyIsotropicHalfSpace>(
      transverse_at(x, solid_at), axis_at(x, solid_at), motion, x[1]);
  const data::IsotropicSolid steel = unit_isotropic(seed::steel_poisson);
  return [=, speed = x[1]](Direction from_motion) -> fast::LineResponse {
    const fast::LineResponse lower = surface->along(turned(from_motion, motion));
    const fast::LineResponse upper = fast::isotropic_response(steel, speed, from_motion);
    return {lower.compliance + upper.compliance, lower.coupling - upper.coupling};
  };
}

/// x + sign y, rounded once.
ref::Real sum(const ref::Real& x, const ref::Real& y, int sign) {
  ref::Real result(std::max(x.precision(), y.precision()) + 8);
  (sign > 0 ? mpfr_add : mpfr_sub)(result.get(), x.get(), y.get(), MPFR_RNDN);
  return result;
}

ref::SurfaceAnswer exact_seed_contact(Exacts x) {
  check_subcritical(x, solid_at, x[0], x[1]);
  const ref::ExactStiffness solid = exact_transverse_at(x, solid_at);
  const auto motion = ref::SurfaceDirection::of_degrees(x[0]);
  const ref::SurfaceAnswer steel = exact_isotropic_surface(Exact(mpq_class("29529/100000")), x[1]);
  return [=, theta = x[0].value(), speed = x[1]](const Exact& degrees, int digits) -> ref::LineAnswer {
    const auto psi = ref::SurfaceDirection::of_degrees(Exact(mpq_class(theta + degrees.value())));
    const auto lower = ref::surface_response(solid, speed, motion, psi, digits);
    const ref::LineAnswer upper = steel(degrees, digits);
    return {sum(lower.compliance.value, upper.compliance, 1), sum(lower.coupling.value, upper.coupling, -1),
            sum(lower.in_line.value, upper.in_line, 1)};
  };
}

Quantity seed_entry(std::string name, std::string definition, std::string source) {
  Quantity entry = contact_entry(std::move(name), std::move(definition), std::move(source), 64);
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}}};
  entry.audit_points = 6;
  return entry;
}

/// Of the seed's solid: 0.3 is below its critical speeds.
Point draw_seed(Random& random, double own) {
  return {random.uniform(-90, 90),
          random.uniform(0.01, 0.3),
          own,
          random.chance(0.5) ? 0.0 : 1.0,
          13.9,
          160.7,
          6.44,
          7.07,
          3.5,
          1688};
}

void keep_seed(Point& x) {
  x[1] = std::min(x[1], 0.3);
  const Point solid{13.9, 160.7, 6.44, 7.07, 3.5, 1688};
  std::ranges::copy(solid, x.begin() + solid_at + 1);
}

Quantity entry_seed_span_ratio() {
  Quantity entry =
      seed_entry("ti.span_ratio",
                 "L_phi/L_X: span at phi from the motion over that along it, frictionless sphere, by the "
                 "papers' rule",
                 "brock2013 (34), (43) corrected");
  entry.arguments.push_back({"phi_deg", ArgumentKind::degrees, "90", {}});
  append_transverse_arguments(entry.arguments);
  entry.draw = [](Random& random) { return draw_seed(random, draw_angle(random)); };
  entry.keep_off = keep_seed;
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_span_ratio(exact_seed_contact(x), Exact(0.0), x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::sliding_for_span(seed_contact(x), {1, 1}, 0, {1, 0}, 1)
        .span_ratio(direction_of_degrees(x[2]));
  });
  return entry;
}

}  // namespace

std::vector<Quantity> half_space_contact_entries() {
  return {entry_exponent(),           entry_die_span_ratio(), entry_die_force(), entry_rolling_index(),
          entry_rolling_span_ratio(), entry_axis_ratio(),     entry_stiffness(), entry_seed_span_ratio()};
}

}  // namespace nipref::verify
