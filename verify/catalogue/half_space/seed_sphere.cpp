// The seed's steel sphere sliding on a transversely isotropic half-space. (brock2013)
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/catalogue/half_space/internal/contact_entry.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;
using fast::Accuracy;
using fast::Direction;
using ref::Exact;

// Arguments: theta_deg, speed, patch, the solid, then the entry's own.

constexpr std::size_t patch_at = 2, solid_at = 3, own_at = solid_at + 7;

/// The solid's critical speed.
double critical_at(Doubles x) {
  return speed_in_steel(
      fast::critical_speed(transverse_at(x, solid_at), axis_at(x, solid_at), Direction::of_degrees(x[0]))
          .speed);
}

/// By the angle from the motion.
fast::SurfaceResponse seed_contact(Doubles x) {
  const Direction motion = Direction::of_degrees(x[0]);
  const auto surface = std::make_shared<const fast::TransverselyIsotropicHalfSpace>(
      transverse_surface_at(x, solid_at, x[0], x[1]));
  const data::IsotropicSolid steel = unit_isotropic(data::seed::steel.poisson);
  return [=, speed = x[patch_at] * x[1]](Direction from_motion) -> fast::LineResponse {
    const fast::LineResponse lower = in_steel(surface->along(from_motion.turned(motion)));
    const fast::LineResponse upper = fast::isotropic_response(steel, speed, from_motion);
    return fast::in_contact(lower, upper);
  };
}

fast::SlidingContact seed_slide(Doubles x, double friction) {
  return fast::sliding_for_span(seed_contact(x), {1, 1}, friction, {1, 0}, 1);
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
  const ref::SurfaceAnswer steel = exact_isotropic_surface(
      as_written(data::seed::steel.poisson), Exact(mpq_class(x[patch_at].value() * x[1].value())));
  return [=, theta = x[0].value(), speed = x[1]](const Exact& degrees, int digits) -> ref::LineAnswer {
    const auto psi = ref::SurfaceDirection::of_degrees(Exact(mpq_class(theta + degrees.value())));
    const auto lower = ref::line_response(solid, speed, motion, psi, digits);
    const ref::LineAnswer upper = steel(degrees, digits);
    return {sum(lower.compliance.value, upper.compliance, 1), sum(lower.coupling.value, upper.coupling, -1),
            sum(lower.coupling_across.value, upper.coupling_across, -1),
            sum(lower.in_line.value, upper.in_line, 1)};
  };
}

/// `patch`: the default, fixed or moving.
Quantity seed_entry(std::string name, std::string definition, std::string source, const char* patch) {
  Quantity entry = contact_entry(std::move(name), std::move(definition), std::move(source), 32);
  entry.arguments = {{"theta_deg", ArgumentKind::degrees, "0", {}},
                     {"speed", ArgumentKind::nonnegative, {}, {}},
                     {"patch", ArgumentKind::choice, patch, {}, {"fixed", "moving"}}};
  append_transverse_arguments(entry.arguments);
  entry.audit_points = 6;
  return entry;
}

/// The seed's solid, up to this share of the critical speed.
void draw_seed(Quantity& entry, double largest_share, std::function<Point(Random&)> own) {
  entry.draw = [=, own = std::move(own)](Random& random) {
    Point x{random.uniform(-90, 90), 0, random.chance(0.5) ? 0.0 : 1.0};
    x.push_back(random.chance(0.5) ? 0 : 1);
    x = with_epoxy(std::move(x));
    const double share = random.chance(0.5) ? 1 - random.log_uniform(1 - largest_share, 1)
                                            : random.uniform(0.01, largest_share);
    x[1] = share * critical_at(x);
    for (const double value : own(random)) x.push_back(value);
    return x;
  };
  entry.keep_off = [=](Point& x) {
    std::ranges::copy(with_epoxy({x[solid_at]}), x.begin() + solid_at);
    x[1] = std::min(x[1], largest_share * critical_at(x));
  };
}

/// What the seed's own formulas are about: BadInput elsewhere.
void check_seed_contact(Doubles x, double friction) {
  if (x[patch_at] == 0) throw BadInput("patch", "fixed", "must be moving: the seed has no other");
  if (axis_at(x, solid_at) == data::SymmetryAxis::in_plane && friction != 0)
    throw BadInput("friction", friction, "must be 0: (42) to (48) are frictionless");
}

using InPlaneForm = double (*)(const ScaledModuli&, Direction line, double cosine_from_motion, double speed);

/// The seed's own span ratio; in_plane: its form of (43).
std::function<double(Doubles)> seed_span_ratio(InPlaneForm in_plane) {
  return [in_plane](Doubles x) {
    const double phi = x[own_at], friction = x[own_at + 1];
    check_seed_contact(x, friction);
    const ScaledModuli moduli = scaled_moduli_at(x, solid_at);
    if (axis_at(x, solid_at) == data::SymmetryAxis::normal) {
      if (std::fabs(phi) != 90)
        throw BadInput("phi_deg", phi, "must be 90 or -90: (35) is of the cross direction");
      return sphere_span_ratio_as_printed(moduli, friction, x[1]);
    }
    const double along =
        in_plane(moduli, Direction::of_degrees(x[0]), 1, x[1]) + sphere_compliance(moduli, 1, x[1]);
    const double cosine = Direction::of_degrees(phi).cosine;
    return (in_plane(moduli, Direction::of_degrees(x[0] + phi), cosine, x[1]) +
            sphere_compliance(moduli, cosine, x[1])) /
           along;
  };
}

Quantity entry_sphere_span_ratio() {
  Quantity entry = seed_entry("ti.span_ratio",
                              "L_phi/L_X: span of a sphere at phi from the motion over that along it, by the "
                              "papers' rule",
                              "brock2013 (34), (35), (43) corrected", "moving");
  entry.arguments.push_back({"phi_deg", ArgumentKind::degrees, "90", {}});
  entry.arguments.push_back({"friction", ArgumentKind::nonnegative, "0", {}});
  draw_seed(entry, nearest_critical, [](Random& random) {
    return Point{draw_angle(random), draw_friction(random)};
  });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_span_ratio(exact_seed_contact(x), x[own_at + 1], x[own_at], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return seed_slide(x, x[own_at + 1]).span_ratio(Direction::of_degrees(x[own_at])).value;
  });
  entry.seed_forms = {
      {"printed",
       "(35) and (43) as they stand: c_D^2 - 1 under both bodies' terms, couplings added, a sign and a term "
       "of M",
       seed_span_ratio(in_plane_compliance_as_printed)},
      {"table", "as Tables 1 and 3 were made: (35) as printed, (43) without the last term of M",
       seed_span_ratio(in_plane_compliance_as_tabulated)}};
  return entry;
}

Quantity entry_sphere_exponent() {
  Quantity entry =
      seed_entry("ti.exponent",
                 "Omega: the pressure of a sliding sphere on the line at phi from the motion ends like "
                 "(x+ - x)^(1 + Omega) (x - x-)^(-Omega)",
                 "brock2013 (29a), (25c) corrected", "moving");
  entry.promise = 8;
  entry.arguments.push_back({"phi_deg", ArgumentKind::degrees, "0", {}});
  entry.arguments.push_back({"friction", ArgumentKind::nonnegative, {}, {}});
  entry.audit_points = 20;
  draw_seed(entry, nearest_critical, [](Random& random) {
    return Point{draw_angle(random), draw_friction(random)};
  });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_exponent(exact_seed_contact(x), x[own_at + 1], x[own_at], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return -seed_slide(x, x[own_at + 1]).along(Direction::of_degrees(x[own_at])).leading_share;
  });
  entry.seed_forms = {{"printed", "(25c) as it stands: the couplings of both bodies added", [](Doubles x) {
                         check_seed_contact(x, x[own_at + 1]);
                         if (axis_at(x, solid_at) == data::SymmetryAxis::in_plane) return -0.5;
                         return sphere_exponent_as_printed(scaled_moduli_at(x, solid_at), x[own_at + 1], x[1],
                                                           Direction::of_degrees(x[own_at]).cosine);
                       }}};
  return entry;
}

Quantity entry_sphere_force() {
  Quantity entry =
      seed_entry("ti.force",
                 "F3 r0/(mu0 L_X^3) of a sphere whose contact has the span L_X along the motion, by the "
                 "papers' rule",
                 "brock2013 (36) and (43) corrected, (47)", "moving");
  entry.arguments.push_back({"friction", ArgumentKind::nonnegative, "0", {}});
  // Oblique to the axis the pressure's ends turn fast across the critical line, and the reference needs more lines.
  constexpr double nearest = 1 - 1e-5;
  draw_seed(entry, nearest, [](Random& random) { return Point{draw_friction(random)}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sliding_force(exact_seed_contact(x), x[own_at], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return seed_slide(x, x[own_at]).force().value; });
  entry.seed_forms = {
      {"printed",
       "(36), (25c) and (43) as they stand: 1/Q^2, exponents interchanged, couplings added, a sign and a term of M",
       [](Doubles x) {
         check_seed_contact(x, x[own_at]);
         const ScaledModuli moduli = scaled_moduli_at(x, solid_at);
         return axis_at(x, solid_at) == data::SymmetryAxis::normal
                    ? sphere_force_as_printed(moduli, x[own_at], x[1])
                    : in_plane_force_as_printed(moduli, Direction::of_degrees(x[0]), x[1]);
       }}};
  return entry;
}

Quantity entry_sphere_axis_ratio() {
  Quantity entry =
      seed_entry("ti.axis_ratio", "minor over major axis of the exact frictionless contact of a sphere",
                 "notes on brock2013 (33)", "fixed");
  draw_seed(entry, nearest_integrated, [](Random&) { return Point{}; });
  entry.by_ref = [](Exacts x, int digits) {
    return ref::elliptic_axis_ratio(exact_seed_contact(x), Exact(1.0), digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return fast::EllipticContact(seed_contact(x), {1, 1}).axis_ratio().value;
  });
  return entry;
}

}  // namespace

std::vector<Quantity> seed_sphere_entries() {
  return {entry_sphere_span_ratio(), entry_sphere_axis_ratio(), entry_sphere_exponent(),
          entry_sphere_force()};
}

}  // namespace nipref::verify
