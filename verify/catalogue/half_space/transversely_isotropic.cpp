// What transversely isotropic half-spaces answer along lines, and their critical speeds.
#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/bulk_wave.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/line_entry.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using fast::Direction;
using fast::LineResponse;
using ref::Exact;
using ref::SurfaceDirection;

// Arguments: theta_deg, then psi_deg and speed where they have them, then the solid.

constexpr std::size_t line_solid = 3;

/// Positive energy, both axes, stiffnesses over two decades; now and then the seed's.
Point draw_solid(Random& random) {
  const double axis = random.chance(0.5) ? 0 : 1;
  if (random.chance(0.1)) return with_epoxy({axis});
  const double c66 = random.log_uniform(1, 100), c44 = random.log_uniform(1, 100);
  const double c11 = c66 * (1 + random.log_uniform(1e-2, 100)), c33 = random.log_uniform(1, 1000);
  const double c13 = random.uniform(-0.99, 0.99) * std::sqrt((c11 - c66) * c33);
  return {axis, c11, c33, c13, c44, c66, random.log_uniform(500, 2e4)};
}

/// In steel's shear wave speeds.
double critical_at(Doubles x, std::size_t first, double theta_deg) {
  return speed_in_steel(
      fast::critical_speed(transverse_at(x, first), axis_at(x, first), Direction::of_degrees(theta_deg))
          .speed);
}

bool is_physical(Doubles x, std::size_t first) {
  try {
    transverse_at(x, first).check();
    return true;
  } catch (const data::BadInput&) {
    return false;
  }
}

/// The search's steps may leave the domain: then to the seed's solid, and below the critical speed.
void keep_line_off(Point& x) {
  if (!is_physical(x, line_solid)) {
    const Point safe = with_epoxy({x[line_solid]});
    std::ranges::copy(safe, x.begin() + line_solid);
  }
  x[2] = std::min(x[2], nearest_critical * critical_at(x, line_solid, x[0]));
}

fast::TransverselyIsotropicHalfSpace surface_at(Doubles x) {
  return transverse_surface_at(x, line_solid, x[0], x[2]);
}

void set_line_arguments(Quantity& entry) {
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}}};
  append_transverse_arguments(entry.arguments);
  entry.draw = [](Random& random) {
    Point x{draw_degrees(random), draw_degrees(random), 0};
    const Point solid = draw_solid(random);
    x.insert(x.end(), solid.begin(), solid.end());
    x[2] = draw_share(random) * critical_at(x, line_solid, x[0]);
    return x;
  };
  entry.keep_off = keep_line_off;
}

template <class FastMember, class RefMember>
Quantity transverse_line(std::string name, std::string definition, FastMember of_fast, RefMember of_ref) {
  Quantity entry = half_space_entry(std::move(name), std::move(definition),
                                    "brock2013 (19), (25b), (43) and (44) corrected");
  set_line_arguments(entry);
  entry.scale = "the larger of compliance and value";
  entry.by_ref = [of_ref](Exacts x, int digits) {
    check_subcritical(x, line_solid, x[0], x[2]);
    return ref::line_response(exact_transverse_at(x, line_solid), x[2], SurfaceDirection::of_degrees(x[0]),
                              SurfaceDirection::of_degrees(x[1]), digits).*
           of_ref;
  };
  const auto response = [](Doubles x) { return in_steel(surface_at(x).along(Direction::of_degrees(x[1]))); };
  set_fast(entry, [response, of_fast](Doubles x, Accuracy) { return response(x).*of_fast; });
  entry.envelope = [response](Doubles x) { return response(x).compliance; };
  return entry;
}

/// The seed's own K with the axis in the surface.
template <class Form>
std::function<double(Doubles)> seed_compliance(Form form) {
  return [form](Doubles x) {
    if (axis_at(x, line_solid) == data::SymmetryAxis::normal)
      throw data::BadInput("axis", "normal", "must be in-plane: elsewhere the seed has no other form");
    const double cosine = Direction::of_degrees(x[1] - x[0]).cosine;
    return form(scaled_moduli_at(x, line_solid), Direction::of_degrees(x[1]), cosine, x[2]);
  };
}

Quantity entry_transverse_compliance(std::string definition) {
  Quantity entry = transverse_line("ti.compliance", std::move(definition), &LineResponse::compliance,
                                   &ref::LineResponse::compliance);
  entry.seed_forms = {
      {"printed", "(43) as it stands: the first term of M with the wrong sign, its last term missing",
       seed_compliance(in_plane_compliance_as_printed)},
      {"table", "as Table 3 was made: the last term of M missing",
       seed_compliance(in_plane_compliance_as_tabulated)}};
  return entry;
}

Quantity entry_ti_condition() {
  Quantity entry = condition_entry("ti.condition", "of brock2013 (19), (43) corrected");
  set_line_arguments(entry);
  entry.promise = 2048;  // a difference quotient in two words
  entry.by_ref = [](Exacts x, int digits) {
    check_subcritical(x, line_solid, x[0], x[2]);
    return exact_condition(exact_transverse_at(x, line_solid), x[2], SurfaceDirection::of_degrees(x[0]),
                           SurfaceDirection::of_degrees(x[1]), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return surface_at(x).condition(Direction::of_degrees(x[1])); });
  return entry;
}

// The order of their names on the command line.
constexpr fast::BranchWave branch_waves[] = {
    fast::BranchWave::transverse, fast::BranchWave::quasi_longitudinal, fast::BranchWave::quasi_transverse};
constexpr ref::BulkWave bulk_waves[] = {ref::BulkWave::upright, ref::BulkWave::faster, ref::BulkWave::slower};

Quantity entry_branch() {
  constexpr std::size_t solid = 1;  // in place of its axis, which lies in the surface, there is the wave
  Quantity entry = half_space_entry(
      "ti.branch", "speed of bulk waves along theta, in those of steel's shear waves, axis in the surface",
      "brock2013 (46) corrected");
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}},
                     {"which", ArgumentKind::choice, {}, {}, {"56", "plus", "minus"}}};
  append_constants(entry.arguments);
  entry.draw = [](Random& random) {
    Point x{draw_degrees(random), static_cast<double>(random.index(3))};
    const Point drawn = draw_solid(random);
    x.insert(x.end(), drawn.begin() + 1, drawn.end());
    return x;
  };
  entry.keep_off = [](Point& x) {
    if (!is_physical(x, solid)) x = with_epoxy({x[0], x[1]});
  };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::bulk_wave_speed(exact_transverse_at(x, solid, data::SymmetryAxis::in_plane),
                                SurfaceDirection::of_degrees(x[0]),
                                bulk_waves[static_cast<std::size_t>(x[1].approximate())], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return speed_in_steel(fast::branch_speed(branch_waves[static_cast<std::size_t>(x[1])],
                                             transverse_at(x, solid), Direction::of_degrees(x[0])));
  });
  return entry;
}

Quantity entry_transverse_critical() {
  constexpr std::size_t solid = 1;
  Quantity entry = half_space_entry(
      "ti.critical", "smallest speed, in those of steel's shear waves, at which some line is critical",
      "brock2013 (46), corrected: for all lines, surface waves included");
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}}};
  append_transverse_arguments(entry.arguments);
  entry.promise = 16;
  entry.audit_points = 6;
  entry.draw = [](Random& random) {
    return with_epoxy({random.uniform(-90, 90), random.chance(0.2) ? 0.0 : 1.0});
  };
  // The seed's solid only: in others the line that is critical first may be so by a bulk wave, or all but,
  // and the reference proves the speed of surface waves.
  entry.keep_off = [](Point& x) { x = with_epoxy({x[0], x[1]}); };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::critical_speed(exact_transverse_at(x, solid), SurfaceDirection::of_degrees(x[0]), digits)
        .speed;
  };
  set_fast(entry, [](Doubles x, Accuracy) { return critical_at(x, solid, x[0]); });
  return entry;
}

Quantity entry_transverse_rayleigh() {
  constexpr std::size_t solid = 2;
  Quantity entry =
      half_space_entry("ti.rayleigh",
                       "speed, in those of steel's shear waves, at which lines at psi are critical by a "
                       "surface wave",
                       "brock2013, root of M (19c), (43b) corrected");
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}}};
  append_transverse_arguments(entry.arguments);
  entry.promise = 16;
  entry.audit_points = 6;
  entry.draw = [](Random& random) {
    const double theta = random.uniform(-90, 90);
    return with_epoxy({theta, theta + random.uniform(-60, 60), random.chance(0.2) ? 0.0 : 1.0});
  };
  entry.keep_off = [](Point& x) { x = with_epoxy({x[0], x[1], x[2]}); };
  const auto speed = [](const ref::ExactStiffness& material, const SurfaceDirection& motion,
                        const SurfaceDirection& psi, int digits) {
    const auto found = ref::surface_wave_speed(material, motion, psi, digits);
    if (!found) throw data::BadInput("psi_deg", "(as given)", "must be a direction that has a surface wave");
    return *found;
  };
  entry.by_ref = [speed](Exacts x, int digits) {
    return speed(exact_transverse_at(x, solid), SurfaceDirection::of_degrees(x[0]),
                 SurfaceDirection::of_degrees(x[1]), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return speed_in_steel(fast::rayleigh_speed(transverse_at(x, solid), axis_at(x, solid),
                                               Direction::of_degrees(x[0]), Direction::of_degrees(x[1])));
  });
  return entry;
}

}  // namespace

std::vector<Quantity> transverse_half_space_entries() {
  constexpr auto transverse = " of a transversely isotropic half-space, over 1/mu of steel, speed in its v_S";
  return {entry_transverse_compliance(std::string("K") + transverse),
          transverse_line("ti.coupling", std::string("S") + transverse, &LineResponse::coupling,
                          &ref::LineResponse::coupling),
          transverse_line("ti.coupling_across",
                          std::string("S' of shear across the line, 90 degrees on from it,") + transverse,
                          &LineResponse::coupling_across, &ref::LineResponse::coupling_across),
          entry_ti_condition(),
          entry_transverse_rayleigh(),
          entry_branch(),
          entry_transverse_critical()};
}

}  // namespace nipref::verify
