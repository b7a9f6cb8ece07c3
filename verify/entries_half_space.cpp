// What half-spaces answer along lines, and their critical speeds.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "data/bad_input.hpp"
#include "fast/isotropic_half_space.hpp"
#include "fast/transversely_isotropic_half_space.hpp"
#include "ref/bulk_wave.hpp"
#include "ref/surface_response.hpp"
#include "ref/surface_wave.hpp"
#include "verify/entries.hpp"
#include "verify/half_space_arguments.hpp"

namespace nipref::verify {
namespace {

using fast::Accuracy;
using fast::Direction;
using fast::LineResponse;
using ref::Exact;
using ref::SurfaceDirection;

constexpr double half_space_promise = 4;
constexpr double largest_poisson = 0.4999;
/// Of the critical speed, in the audit.
constexpr double nearest_critical = 1 - 1e-8;

Quantity half_space_entry(std::string name, std::string definition, std::string source) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = std::move(source);
  entry.scale = "the value";
  entry.promise = half_space_promise;
  entry.envelope = [](Doubles) { return 0.0; };
  entry.audit_points = 200;
  entry.timed_alone = false;
  return entry;
}

/// The speed along a line, from what fast was given. n is only as long as doubles make it: with the axis in
/// the surface fast's formula is homogeneous in n, and the speed that it sees n.m/|n|, here to 1e-32; with
/// the axis normal its length does not enter.
Exact line_speed(double speed, Direction n, Direction m, data::SymmetryAxis axis) {
  const mpq_class nx(n.cosine), ny(n.sine);
  mpq_class along = nx * mpq_class(m.cosine) + ny * mpq_class(m.sine);
  if (axis == data::SymmetryAxis::in_plane) along *= 1 - (nx * nx + ny * ny - 1) / 2;
  return Exact(mpq_class(mpq_class(speed) * along));
}

/// The reference's response at a line that fast was given: nothing of the motion matters but the speed along
/// the line.
ref::SurfaceResponse transverse_response_of_doubles(Doubles x, int digits) {
  constexpr std::size_t solid = 3;
  const Direction psi = direction_of_degrees(x[1]);
  const SurfaceDirection line(Exact(psi.cosine), Exact(psi.sine));
  return ref::surface_response(exact_of_transverse_at(x, solid),
                               line_speed(x[2], psi, direction_of_degrees(x[0]), axis_at(x, solid)), line,
                               line, digits);
}

double draw_poisson(Random& random) {
  return random.chance(0.3) ? 0.5 - random.log_uniform(1e-4, 1) : random.uniform(-0.9, largest_poisson);
}

/// Of the critical speed: from 1e-8 to 1 - 1e-8.
double draw_share(Random& random) {
  switch (random.index(4)) {
    case 0:
      return random.log_uniform(1e-8, 1);
    case 1:
      return 1 - random.log_uniform(1e-8, 1e-3);
    default:
      return random.uniform(0, 0.999);
  }
}

double draw_degrees(Random& random) {
  const double sign = random.chance(0.5) ? 1 : -1;
  switch (random.index(4)) {
    case 0:
      return sign * (90 - random.log_uniform(1e-12, 1));
    case 1:
      return sign * random.log_uniform(1e-6, 1);
    default:
      return random.uniform(-90, 90);
  }
}

void keep_subcritical(Point& x) {
  x[0] = std::clamp(x[0], -0.9, largest_poisson);
  x[1] = std::min(x[1], nearest_critical * fast::isotropic_rayleigh_speed(x[0]));
}

/// Refuses what fast refuses: the reference solves the equations beyond the Rayleigh speed too.
void check_line(const Exact& poisson, const Exact& speed, const Exact& psi_deg) {
  static_cast<void>(fast::isotropic_response(unit_isotropic(poisson.approximate()), speed.approximate(),
                                             direction_of_degrees(psi_deg.approximate())));
}

template <class FastMember, class RefMember>
Quantity isotropic_line(std::string name, std::string definition, FastMember of_fast, RefMember of_ref) {
  Quantity entry =
      half_space_entry(std::move(name), std::move(definition), "brock2012 (18a), brock2013 (20)");
  entry.arguments = {{"poisson", ArgumentKind::poisson, {}, {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}}};
  entry.draw = [](Random& random) {
    const double poisson = draw_poisson(random);
    return Point{poisson, draw_share(random) * fast::isotropic_rayleigh_speed(poisson), draw_degrees(random)};
  };
  entry.keep_off = keep_subcritical;
  entry.by_ref = [of_ref](Exacts x, int digits) {
    check_line(x[0], x[1], x[2]);
    return ref::surface_response(exact_isotropic(x[0]), x[1], SurfaceDirection::of_degrees(Exact(0.0)),
                                 SurfaceDirection::of_degrees(x[2]), digits).*
           of_ref;
  };
  entry.by_ref_of_doubles = [of_ref](Doubles x, int digits) {
    // All lines of an isotropic surface are alike: only the speed along them matters.
    const Exact along(mpq_class(mpq_class(x[1]) * mpq_class(direction_of_degrees(x[2]).cosine)));
    const auto line = SurfaceDirection::of_degrees(Exact(0.0));
    return ref::surface_response(exact_isotropic(Exact(x[0])), along, line, line, digits).*of_ref;
  };
  set_fast(entry, [of_fast](Doubles x, Accuracy) {
    return fast::isotropic_response(unit_isotropic(x[0]), x[1], direction_of_degrees(x[2])).*of_fast;
  });
  return entry;
}

/// By a central difference of the reference's K in three times the digits.
ref::Enclosure exact_condition(const Exact& poisson, const Exact& speed, const SurfaceDirection& psi,
                               int digits) {
  const auto motion = SurfaceDirection::of_degrees(Exact(0.0));
  const ref::ExactStiffness solid = exact_isotropic(poisson);
  const Exact step = Exact::parse("1e-" + std::to_string(digits));
  const auto ln_K = [&](int sign) {
    const Exact moved(mpq_class(speed.value() * (1 + sign * step.value())));
    ref::Real value = ref::surface_response(solid, moved, motion, psi, 3 * digits).compliance.value;
    mpfr_log(value.get(), value.get(), MPFR_RNDN);
    return value;
  };
  ref::Real slope = ln_K(1);
  const ref::Real below = ln_K(-1);
  mpfr_sub(slope.get(), slope.get(), below.get(), MPFR_RNDN);
  ref::Real two_steps(slope.precision());
  mpfr_set_q(two_steps.get(), mpq_class(2 * step.value()).get_mpq_t(), MPFR_RNDN);
  mpfr_div(slope.get(), slope.get(), two_steps.get(), MPFR_RNDN);
  // The next term is step^2 times a third derivative, which grows like the cube of the slope.
  ref::Real error(64);
  mpfr_set_q(error.get(), step.value().get_mpq_t(), MPFR_RNDU);
  return {slope, error, digits};
}

Quantity entry_condition() {
  Quantity entry = half_space_entry(
      "halfspace.condition", "d ln K/d ln speed: how much of a relative error of the speed comes out in K",
      "of brock2012 (18a)");
  entry.arguments = {{"poisson", ArgumentKind::poisson, {}, {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}}};
  entry.scale = "1 or the value";
  entry.envelope = [](Doubles) { return 1.0; };
  entry.promise = 16;
  entry.draw = [](Random& random) {
    const double poisson = draw_poisson(random);
    return Point{poisson, random.uniform(0.01, 0.999) * fast::isotropic_rayleigh_speed(poisson),
                 random.uniform(-80, 80)};
  };
  entry.keep_off = [](Point& x) {
    x[0] = std::clamp(x[0], -0.9, largest_poisson);
    x[1] = std::min(x[1], 0.999 * fast::isotropic_rayleigh_speed(x[0]));
  };
  entry.by_ref = [](Exacts x, int digits) {
    check_line(x[0], x[1], x[2]);
    return exact_condition(x[0], x[1], SurfaceDirection::of_degrees(x[2]), digits);
  };
  entry.by_ref_of_doubles = [](Doubles x, int digits) {
    const Exact along(mpq_class(mpq_class(x[1]) * mpq_class(direction_of_degrees(x[2]).cosine)));
    return exact_condition(Exact(x[0]), along, SurfaceDirection::of_degrees(Exact(0.0)), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::isotropic_condition(unit_isotropic(x[0]), x[1], direction_of_degrees(x[2]));
  });
  return entry;
}

Quantity entry_rayleigh() {
  Quantity entry = half_space_entry("halfspace.rayleigh", "speed of Rayleigh waves over that of shear waves",
                                    "brock2012, root of R (16b)");
  entry.arguments = {{"poisson", ArgumentKind::poisson, {}, {}}};
  entry.draw = [](Random& random) { return Point{draw_poisson(random)}; };
  entry.keep_off = [](Point& x) { x[0] = std::clamp(x[0], -0.9, largest_poisson); };
  entry.by_ref = [](Exacts x, int digits) {
    const auto line = SurfaceDirection::of_degrees(Exact(0.0));
    return ref::surface_wave_speed(exact_isotropic(x[0]), line, line, digits).value();
  };
  set_fast(entry, [](Doubles x, Accuracy) { return fast::isotropic_rayleigh_speed(x[0]); });
  return entry;
}

// Transversely isotropic entries: theta_deg, then psi_deg and speed where they have them, then the solid.

/// Positive energy, both axes, stiffnesses over two decades; now and then the seed's.
Point draw_solid(Random& random) {
  const double axis = random.chance(0.5) ? 0 : 1;
  if (random.chance(0.1)) return {axis, 13.9, 160.7, 6.44, 7.07, 3.5, 1688};
  const double c66 = random.log_uniform(1, 100), c44 = random.log_uniform(1, 100);
  const double c11 = c66 * (1 + random.log_uniform(1e-2, 100)), c33 = random.log_uniform(1, 1000);
  const double c13 = random.uniform(-0.99, 0.99) * std::sqrt((c11 - c66) * c33);
  return {axis, c11, c33, c13, c44, c66, random.log_uniform(500, 2e4)};
}

fast::CriticalSpeed critical_at(Doubles x, std::size_t solid_at, double theta_deg) {
  return fast::critical_speed(transverse_at(x, solid_at), axis_at(x, solid_at),
                              direction_of_degrees(theta_deg));
}

bool is_physical(Doubles x, std::size_t solid_at) {
  try {
    transverse_at(x, solid_at).check();
    return true;
  } catch (const data::BadInput&) {
    return false;
  }
}

constexpr std::size_t line_solid = 3;

/// The search's steps may leave the domain: then to the seed's solid, and below the critical speed.
void keep_line_off(Point& x) {
  if (!is_physical(x, line_solid)) {
    const Point safe{x[line_solid], 13.9, 160.7, 6.44, 7.07, 3.5, 1688};
    std::ranges::copy(safe, x.begin() + line_solid);
  }
  x[2] = std::min(x[2], nearest_critical * critical_at(x, line_solid, x[0]).speed);
}

template <class FastMember, class RefMember>
Quantity transverse_line(std::string name, std::string definition, FastMember of_fast, RefMember of_ref) {
  Quantity entry = half_space_entry(std::move(name), std::move(definition),
                                    "brock2013 (19), (25b), (43) and (44) corrected");
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}},
                     {"psi_deg", ArgumentKind::degrees, "0", {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}}};
  append_transverse_arguments(entry.arguments);
  entry.scale = "the larger of compliance and value";
  entry.draw = [](Random& random) {
    Point x{draw_degrees(random), draw_degrees(random), 0};
    const Point solid = draw_solid(random);
    x.insert(x.end(), solid.begin(), solid.end());
    x[2] = draw_share(random) * critical_at(x, line_solid, x[0]).speed;
    return x;
  };
  entry.keep_off = keep_line_off;
  entry.by_ref = [of_ref](Exacts x, int digits) {
    check_subcritical(x, line_solid, x[0], x[2]);
    return ref::surface_response(exact_transverse_at(x, line_solid), x[2], SurfaceDirection::of_degrees(x[0]),
                                 SurfaceDirection::of_degrees(x[1]), digits).*
           of_ref;
  };
  entry.by_ref_of_doubles = [of_ref](Doubles x, int digits) {
    return transverse_response_of_doubles(x, digits).*of_ref;
  };
  const auto response = [](Doubles x) {
    const fast::TransverselyIsotropicHalfSpace surface(transverse_at(x, line_solid), axis_at(x, line_solid),
                                                       direction_of_degrees(x[0]), x[2]);
    return surface.along(direction_of_degrees(x[1]));
  };
  set_fast(entry, [response, of_fast](Doubles x, Accuracy) { return response(x).*of_fast; });
  entry.envelope = [response](Doubles x) { return response(x).compliance; };
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
    if (!is_physical(x, solid)) x = {x[0], x[1], 13.9, 160.7, 6.44, 7.07, 3.5, 1688};
  };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::bulk_wave_speed(exact_transverse_at(x, solid, data::SymmetryAxis::in_plane),
                                SurfaceDirection::of_degrees(x[0]),
                                bulk_waves[static_cast<std::size_t>(x[1].approximate())], digits);
  };
  entry.by_ref_of_doubles = [](Doubles x, int digits) {
    const Direction line = direction_of_degrees(x[0]);
    return ref::bulk_wave_speed(exact_of_transverse_at(x, solid, data::SymmetryAxis::in_plane),
                                {Exact(line.cosine), Exact(line.sine)},
                                bulk_waves[static_cast<std::size_t>(x[1])], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::branch_speed(branch_waves[static_cast<std::size_t>(x[1])], transverse_at(x, solid),
                              direction_of_degrees(x[0]));
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
    return Point{random.uniform(-90, 90), random.chance(0.2) ? 0.0 : 1.0, 13.9, 160.7, 6.44, 7.07, 3.5, 1688};
  };
  // The seed's solid only: in others the line that is critical first may be so by a bulk wave, or all but,
  // and the reference proves the speed of surface waves.
  entry.keep_off = [](Point& x) { x = {x[0], x[1], 13.9, 160.7, 6.44, 7.07, 3.5, 1688}; };
  entry.by_ref = [](Exacts x, int digits) {
    return ref::critical_speed(exact_transverse_at(x, solid), SurfaceDirection::of_degrees(x[0]), digits)
        .speed;
  };
  entry.by_ref_of_doubles = [](Doubles x, int digits) {
    const Direction motion = direction_of_degrees(x[0]);
    return ref::critical_speed(exact_of_transverse_at(x, solid),
                               SurfaceDirection(Exact(motion.cosine), Exact(motion.sine)), digits)
        .speed;
  };
  set_fast(entry, [](Doubles x, Accuracy) { return critical_at(x, solid, x[0]).speed; });
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
    return Point{
        theta, theta + random.uniform(-60, 60), random.chance(0.2) ? 0.0 : 1.0, 13.9, 160.7, 6.44, 7.07, 3.5,
        1688};
  };
  entry.keep_off = [](Point& x) { x = {x[0], x[1], x[2], 13.9, 160.7, 6.44, 7.07, 3.5, 1688}; };
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
  entry.by_ref_of_doubles = [speed](Doubles x, int digits) {
    const Direction motion = direction_of_degrees(x[0]), psi = direction_of_degrees(x[1]);
    return speed(exact_of_transverse_at(x, solid), {Exact(motion.cosine), Exact(motion.sine)},
                 {Exact(psi.cosine), Exact(psi.sine)}, digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::rayleigh_speed(transverse_at(x, solid), axis_at(x, solid), direction_of_degrees(x[0]),
                                direction_of_degrees(x[1]));
  });
  return entry;
}

}  // namespace

std::vector<Quantity> half_space_entries() {
  constexpr auto compliance = "K of lines at psi from the motion, speed in that of shear waves, over 1/mu";
  constexpr auto coupling = "S of such lines: du3/dx = -K H[sigma33] - S tau, over 1/mu";
  constexpr auto transverse = " of a transversely isotropic half-space, over 1/mu of steel, speed in its v_S";
  return {isotropic_line("halfspace.compliance", compliance, &LineResponse::compliance,
                         &ref::SurfaceResponse::compliance),
          isotropic_line("halfspace.coupling", coupling, &LineResponse::coupling,
                         &ref::SurfaceResponse::coupling),
          entry_condition(),
          entry_rayleigh(),
          transverse_line("ti.compliance", std::string("K") + transverse, &LineResponse::compliance,
                          &ref::SurfaceResponse::compliance),
          transverse_line("ti.coupling", std::string("S") + transverse, &LineResponse::coupling,
                          &ref::SurfaceResponse::coupling),
          entry_transverse_rayleigh(),
          entry_branch(),
          entry_transverse_critical()};
}

}  // namespace nipref::verify
