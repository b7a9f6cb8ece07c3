// Contacts on isotropic half-spaces by the papers' rule.
#include <algorithm>
#include <numbers>
#include <utility>

#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/catalogue/half_space/internal/contact_entry.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using ref::Exact;

Argument friction_argument() { return {"friction", ArgumentKind::nonnegative, {}, {}}; }
Argument psi_argument() { return {"psi_deg", ArgumentKind::degrees, "0", {}}; }

/// A sphere of curvature 1 with a span of 1 along the motion.
fast::SlidingContact slide(Doubles x, double friction) {
  return fast::sliding_for_span(isotropic_surface(x[0], x[1]), {1, 1}, friction, {1, 0}, 1);
}

fast::RollingSphere roll(Doubles x) {
  return fast::rolling_sphere_for_span(unit_isotropic(x[0]), 1, x[1], 1e-3);
}

Quantity entry_exponent() {
  Quantity entry = contact_entry(
      "die.exponent", "Omega: the pressure of a sliding die ends like (x+ - x)^(1 + Omega) (x - x-)^(-Omega)",
      "brock2012 (26a)", 8);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(friction_argument());
  entry.arguments.push_back(psi_argument());
  draw_isotropic(entry, nearest_critical, [](Random& random) {
    return Point{draw_friction(random), draw_angle(random)};
  });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_exponent(exact_isotropic_surface(x[0], x[1]), x[2], x[3], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return -slide(x, x[2]).along(fast::Direction::of_degrees(x[3])).leading_share;
  });
  return entry;
}

Quantity entry_die_span_ratio() {
  Quantity entry = contact_entry(
      "die.span_ratio", "C2 L2/(C1 L1): span across over span along a sliding die, by the papers' rule",
      "brock2012 (34a), (35) corrected", 16);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(friction_argument());
  draw_isotropic(entry, nearest_critical, [](Random& random) { return Point{draw_friction(random)}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_span_ratio(exact_isotropic_surface(x[0], x[1]), x[2], Exact(90.0), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return slide(x, x[2]).span_ratio({0, 1}).value; });
  entry.seed_forms = {
      {"printed", "(35) as it stands: sqrt(c_D^4 + friction^2) where friction does nothing across the motion",
       [](Doubles x) { return die_span_ratio_as_printed(x[0], x[2], x[1]); }},
      {"table",
       "as Table 1 was made: (35) printed, and friction left out of Delta_1 and Q_1, roots to 5 decimals",
       [](Doubles x) { return die_span_ratio_as_tabulated(x[0], x[2], x[1], table_root_decimals); }}};
  return entry;
}

Quantity entry_die_force() {
  Quantity entry =
      contact_entry("die.force", "F3 sqrt(C3)/(mu C L1^3) of a die with C1 = C2 = C, by the papers' rule",
                    "brock2012 (36)", 32);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(friction_argument());
  entry.audit_points = 6;
  draw_isotropic(entry, nearest_integrated, [](Random& random) { return Point{draw_friction(random)}; });
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
  draw_isotropic(entry, nearest_critical, [](Random& random) { return Point{draw_angle(random)}; });
  // It vanishes at nu = 1/2, at rest.
  entry.scale = "1/10 or the value";
  entry.envelope = [](Doubles) { return 0.1; };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::rolling_index(exact_isotropic_surface(x[0], x[1]), x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return roll(x).along(fast::Direction::of_degrees(x[2])).index; });
  return entry;
}

Quantity entry_rolling_span_ratio() {
  Quantity entry = contact_entry("rolling.span_ratio",
                                 "L2/L1: span across over span along a rolling sphere, by the papers' rule",
                                 "brock2012 (53b) corrected", 16);
  entry.arguments = isotropic_arguments();
  draw_isotropic(entry, nearest_critical, [](Random&) { return Point{}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::rolling_span_ratio(exact_isotropic_surface(x[0], x[1]), Exact(90.0), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return roll(x).span_ratio({0, 1}).value; });
  entry.seed_forms = {{"printed", "(53b) as it stands: a factor c_D under its second root",
                       [](Doubles x) { return rolling_span_ratio_as_printed(x[0], x[1]); }},
                      {"table", "as Table 2 was made: right, but with roots to 5 decimals", [](Doubles x) {
                         return rolling_span_ratio_as_tabulated(x[0], x[1], table_root_decimals);
                       }}};
  return entry;
}

Quantity entry_rolling_strip() {
  Quantity entry = contact_entry(
      "rolling.strip",
      "s = exp(-pi/(2P)): on a line of span L the pressure of a rolling sphere may be tension in the outermost "
      "s L/(1 + s)",
      "brock2012 (50)", 4);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back(psi_argument());
  draw_isotropic(entry, nearest_critical, [](Random& random) { return Point{draw_angle(random)}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::rolling_strip(exact_isotropic_surface(x[0], x[1]), x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::rolling_strip(unit_isotropic(x[0]), x[1], fast::Direction::of_degrees(x[2]));
  });
  return entry;
}

Quantity entry_rolling_force() {
  Quantity entry = contact_entry(
      "rolling.force", "F3 r0/(mu L1^3) of a rolling sphere, to first order in L1/r0", "brock2012 (54)", 32);
  entry.arguments = isotropic_arguments();
  entry.audit_points = 6;
  draw_isotropic(entry, nearest_integrated, [](Random&) { return Point{}; });
  // Just below the Rayleigh speed the tractions pull in sum.
  entry.scale = "the value, or that of tractions of one sign";
  const auto one_sign = [](Doubles x) {
    const fast::RollingLine line = roll(x).along({1, 0});
    return std::numbers::pi / 6 * line.amplitude;
  };
  entry.envelope = one_sign;
  entry.by_ref = [](Exacts x, int digits) {
    return ref::rolling_force(exact_isotropic_surface(x[0], x[1]), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::rolling_sphere_for_span(unit_isotropic(x[0]), 1, x[1], 1).force().value;
  });
  return entry;
}

Quantity entry_rolling_creep() {
  Quantity entry = contact_entry(
      "rolling.creep",
      "V0: the surface under a rolling sphere moves along its lines by du/dx = -V0 + x^2/(2 r0^2)",
      "brock2012 (48) corrected", 16);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back({"span_over_radius", ArgumentKind::positive, {}, {}});
  entry.arguments.push_back(psi_argument());
  const auto largest_span = [](Doubles x) {
    const double psi = x[3];
    const fast::RollingSphere unit = fast::rolling_sphere_for_span(unit_isotropic(x[0]), 1, x[1], 1e-9);
    const fast::RollingLine line = unit.along(fast::Direction::of_degrees(psi));
    return 2e-9 / (line.span * line.shear_share * line.index);
  };
  draw_isotropic(entry, nearest_critical, [](Random& random) {
    return Point{random.log_uniform(1e-9, 1), draw_angle(random)};
  });
  const auto below = entry.keep_off;
  entry.draw = [draw = entry.draw, largest_span](Random& random) {
    Point x = draw(random);
    x[2] = std::min(x[2], 0.99 * largest_span(x));
    return x;
  };
  entry.keep_off = [below, largest_span](Point& x) {
    below(x);
    x[2] = std::min(x[2], 0.99 * largest_span(x));
  };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::rolling_creep(exact_isotropic_surface(x[0], x[1]), x[3], x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::rolling_sphere_for_span(unit_isotropic(x[0]), 1, x[1], x[2])
        .along(fast::Direction::of_degrees(x[3]))
        .creep.value;
  });
  entry.seed_forms = {{"printed", "(48) as it stands: P with the wrong sign",
                       [](Doubles x) { return rolling_creep_as_printed(x[0], x[1], x[3], x[2]); }}};
  return entry;
}

}  // namespace

std::vector<Quantity> half_space_contact_entries() {
  return {entry_exponent(),           entry_die_span_ratio(), entry_die_force(),     entry_rolling_index(),
          entry_rolling_span_ratio(), entry_rolling_strip(),  entry_rolling_force(), entry_rolling_creep()};
}

}  // namespace nipref::verify
