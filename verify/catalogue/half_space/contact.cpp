// Contacts on isotropic half-spaces: by the papers' rule, and the exact frictionless one.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;
using ref::Exact;

void keep_all(const NamedNumbers&) {}

/// Points up to `largest_share` of the Rayleigh speed. `more`: draws the arguments after poisson and speed.
template <class More>
Quantity sampled_to(double largest_share, Quantity entry, More more,
                    void (*keep_more)(const NamedNumbers&) = keep_all) {
  set_draw(entry, [=](Random& random, NamedNumbers x) {
    x["poisson"] = random.uniform(-0.5, 0.49);
    x["speed"] = draw_share(random, 0, largest_share) * fast::isotropic_rayleigh_speed(x["poisson"]);
    more(random, x);
  });
  set_keep_off(entry, [=](NamedNumbers x) {
    x["poisson"] = std::clamp(x["poisson"], -0.5, 0.49);
    x["speed"] = std::min(x["speed"], largest_share * fast::isotropic_rayleigh_speed(x["poisson"]));
    keep_more(x);
  });
  return entry;
}

void draw_nothing(Random&, const NamedNumbers&) {}
void draw_psi(Random& random, const NamedNumbers& x) { x["psi_deg"] = draw_angle(random); }
void draw_sliding(Random& random, const NamedNumbers& x) { x["friction"] = draw_friction(random); }

/// A sphere of curvature 1 with a span of 1 along the motion.
fast::SlidingContact slide(const NamedPoint& x) {
  return fast::sliding_for_span(isotropic_surface(x["poisson"], x["speed"]), {1, 1}, x["friction"], {1, 0},
                                1);
}

fast::RollingSphere roll(const NamedPoint& x, double span = 1e-3) {
  return fast::rolling_sphere_for_span(unit_isotropic(x["poisson"]), 1, x["speed"], span);
}

ref::SurfaceAnswer surface_of(const NamedExact& x) {
  return exact_isotropic_surface(x["poisson"], x["speed"]);
}

Direction psi_of(const NamedPoint& x) { return Direction::of_degrees(x["psi_deg"]); }

Quantity entry_exponent() {
  return sampled_to(nearest_critical,
                    entry_of(
                        "die.exponent",
                        [](NamedExact x, int digits) {
                          return ref::sliding_exponent(surface_of(x), x["friction"], x["psi_deg"], digits);
                        },
                        [](NamedPoint x) { return -slide(x).along(psi_of(x)).leading_share; }),
                    [](Random& random, NamedNumbers x) {
                      draw_sliding(random, x);
                      draw_psi(random, x);
                    });
}

Quantity entry_die_span_ratio() {
  Quantity entry =
      sampled_to(nearest_critical,
                 entry_of(
                     "die.span_ratio",
                     [](NamedExact x, int digits) {
                       return ref::sliding_span_ratio(surface_of(x), x["friction"], Exact(90.0), digits);
                     },
                     [](NamedPoint x) {
                       return slide(x).span_ratio({0, 1}).value;
                     }),
                 draw_sliding);
  set_forms(
      entry, [](NamedPoint x) { return die_span_ratio_as_printed(x["poisson"], x["friction"], x["speed"]); },
      [](NamedPoint x) {
        return die_span_ratio_as_tabulated(x["poisson"], x["friction"], x["speed"], table_root_decimals);
      });
  return entry;
}

Quantity entry_die_force() {
  return sampled_to(
      nearest_integrated,
      entry_of(
          "die.force",
          [](NamedExact x, int digits) { return ref::sliding_force(surface_of(x), x["friction"], digits); },
          [](NamedPoint x) { return slide(x).force().value; }),
      draw_sliding);
}

Quantity entry_rolling_index() {
  // It vanishes at nu = 1/2, at rest.
  return sampled_to(
      nearest_critical,
      entry_of(
          "rolling.index",
          [](NamedExact x, int digits) { return ref::rolling_index(surface_of(x), x["psi_deg"], digits); },
          [](NamedPoint x) { return roll(x).along(psi_of(x)).index; }, [](NamedPoint) { return 0.1; }),
      draw_psi);
}

Quantity entry_rolling_span_ratio() {
  Quantity entry = sampled_to(nearest_critical,
                              entry_of(
                                  "rolling.span_ratio",
                                  [](NamedExact x, int digits) {
                                    return ref::rolling_span_ratio(surface_of(x), Exact(90.0), digits);
                                  },
                                  [](NamedPoint x) {
                                    return roll(x).span_ratio({0, 1}).value;
                                  }),
                              draw_nothing);
  set_forms(
      entry, [](NamedPoint x) { return rolling_span_ratio_as_printed(x["poisson"], x["speed"]); },
      [](NamedPoint x) {
        return rolling_span_ratio_as_tabulated(x["poisson"], x["speed"], table_root_decimals);
      });
  return entry;
}

Quantity entry_rolling_strip() {
  return sampled_to(
      nearest_critical,
      entry_of(
          "rolling.strip",
          [](NamedExact x, int digits) { return ref::rolling_strip(surface_of(x), x["psi_deg"], digits); },
          [](NamedPoint x) {
            return fast::rolling_strip(unit_isotropic(x["poisson"]), x["speed"], psi_of(x));
          }),
      draw_psi);
}

Quantity entry_rolling_force() {
  // Just below the Rayleigh speed the tractions pull in sum.
  const auto force_of_one_sign = [](NamedPoint x) {
    return std::numbers::pi / 6 * roll(x).along({1, 0}).amplitude;
  };
  return sampled_to(
      nearest_integrated,
      entry_of(
          "rolling.force", [](NamedExact x, int digits) { return ref::rolling_force(surface_of(x), digits); },
          [](NamedPoint x) { return roll(x, 1).force().value; }, force_of_one_sign),
      draw_nothing);
}

/// Beyond it the creep changes its sign.
void keep_span(const NamedNumbers& x) {
  const fast::RollingLine line = roll(x, 1e-9).along(psi_of(x));
  const double largest = 2e-9 / (line.span * line.shear_share * line.index);
  x["span_over_radius"] = std::min(x["span_over_radius"], 0.99 * largest);
}

Quantity entry_rolling_creep() {
  Quantity entry = sampled_to(
      nearest_critical,
      entry_of(
          "rolling.creep",
          [](NamedExact x, int digits) {
            return ref::rolling_creep(surface_of(x), x["psi_deg"], x["span_over_radius"], digits);
          },
          [](NamedPoint x) { return roll(x, x["span_over_radius"]).along(psi_of(x)).creep.value; }),
      [](Random& random, NamedNumbers x) {
        x["span_over_radius"] = random.log_uniform(1e-9, 1);
        draw_psi(random, x);
        keep_span(x);
      },
      keep_span);
  set_forms(entry, [](NamedPoint x) {
    return rolling_creep_as_printed(x["poisson"], x["speed"], x["psi_deg"], x["span_over_radius"]);
  });
  return entry;
}

Quantity elliptic_entry(const char* name,
                        ref::Estimate (*by_ref)(const ref::SurfaceAnswer&, const Exact&, int),
                        double (*by_fast)(const fast::EllipticContact&, double)) {
  return sampled_to(
      nearest_integrated,
      entry_of(
          name,
          [by_ref](NamedExact x, int digits) { return by_ref(surface_of(x), x["curvature_ratio"], digits); },
          [by_fast](NamedPoint x) {
            const double ratio = x["curvature_ratio"];
            return by_fast({isotropic_surface(x["poisson"], x["speed"]), {1, ratio}}, ratio);
          }),
      [](Random& random, NamedNumbers x) {
        x["curvature_ratio"] = random.chance(0.3) ? 1 : random.log_uniform(1e-10, 1e10);
      });
}

}  // namespace

std::vector<Quantity> half_space_contact_entries() {
  return {
      entry_exponent(),
      entry_die_span_ratio(),
      entry_die_force(),
      entry_rolling_index(),
      entry_rolling_span_ratio(),
      entry_rolling_strip(),
      entry_rolling_force(),
      entry_rolling_creep(),
      elliptic_entry("ellipse.axis_ratio", ref::elliptic_axis_ratio,
                     [](const fast::EllipticContact& contact, double) { return contact.axis_ratio().value; }),
      elliptic_entry("ellipse.stiffness", ref::elliptic_stiffness,
                     [](const fast::EllipticContact& contact, double curvature_ratio) {
                       return contact.for_approach(1).force.value * std::sqrt((1 + curvature_ratio) / 2);
                     })};
}

}  // namespace nipref::verify
