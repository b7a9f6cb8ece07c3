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
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;
using fast::Direction;
using ref::Exact;

/// By the angle from the motion.
fast::SurfaceResponse seed_contact(const NamedPoint& x) {
  const Direction motion = Direction::of_degrees(x["theta_deg"]);
  const auto surface = std::make_shared<const fast::TransverselyIsotropicHalfSpace>(transverse_surface_of(x));
  const data::IsotropicSolid steel = unit_isotropic(data::seed::steel.poisson);
  return [=, speed = x["patch"] * x["speed"]](Direction from_motion) -> fast::LineResponse {
    const fast::LineResponse lower = in_steel(surface->along(from_motion.turned(motion)));
    const fast::LineResponse upper = fast::isotropic_response(steel, speed, from_motion);
    return fast::in_contact(lower, upper);
  };
}

fast::SlidingContact seed_slide(const NamedPoint& x) {
  return fast::sliding_for_span(seed_contact(x), {1, 1}, x["friction"], {1, 0}, 1);
}

/// x + sign y, rounded once.
ref::Real sum(const ref::Real& x, const ref::Real& y, int sign) {
  ref::Real result(std::max(x.precision(), y.precision()) + 8);
  (sign > 0 ? mpfr_add : mpfr_sub)(result.get(), x.get(), y.get(), MPFR_RNDN);
  return result;
}

ref::SurfaceAnswer exact_seed_contact(const NamedExact& x) {
  check_subcritical(x);
  const ref::ExactStiffness solid = exact_transverse_of(x, symmetry_axis(x));
  const auto motion = ref::SurfaceDirection::of_degrees(x["theta_deg"]);
  const ref::SurfaceAnswer steel = exact_isotropic_surface(
      as_written(data::seed::steel.poisson), Exact(mpq_class(x["patch"].value() * x["speed"].value())));
  return [=, theta = x["theta_deg"].value(), speed = x["speed"]](const Exact& degrees,
                                                                 int digits) -> ref::LineAnswer {
    const auto psi = ref::SurfaceDirection::of_degrees(Exact(mpq_class(theta + degrees.value())));
    const auto lower = ref::line_response(solid, speed, motion, psi, digits);
    const ref::LineAnswer upper = steel(degrees, digits);
    return {sum(lower.compliance.value, upper.compliance, 1), sum(lower.coupling.value, upper.coupling, -1),
            sum(lower.coupling_across.value, upper.coupling_across, -1),
            sum(lower.in_line.value, upper.in_line, 1)};
  };
}

/// Points of the seed's solid up to this share of the critical speed. `own`: draws the arguments after the solid.
template <class Ref, class Fast, class Own>
Quantity seed_entry(const char* name, Ref by_ref, Fast by_fast, double largest_share, Own own) {
  Quantity entry = entry_of(name, by_ref, by_fast);
  set_draw(entry, [=](Random& random, NamedNumbers x) {
    x["theta_deg"] = draw_angle(random);
    x["patch"] = random.chance(0.5) ? 0 : 1;
    x["axis"] = random.chance(0.5) ? 0 : 1;
    x["speed"] = draw_share(random, 0.01, largest_share) * critical_speed_of(x);
    own(random, x);
  });
  set_keep_off(entry, [=](NamedNumbers x) {
    put_epoxy(x);
    x["speed"] = std::min(x["speed"], largest_share * critical_speed_of(x));
  });
  return entry;
}

void draw_line_of_contact(Random& random, const NamedNumbers& x) {
  x["phi_deg"] = draw_angle(random);
  x["friction"] = draw_friction(random);
}

/// What the seed's own formulas are about: BadInput elsewhere.
void check_seed_contact(const NamedPoint& x) {
  if (x["patch"] == 0) throw BadInput("patch", "fixed", "must be moving: the seed has no other");
  if (symmetry_axis(x) == data::SymmetryAxis::in_plane && x["friction"] != 0)
    throw BadInput("friction", x["friction"], "must be 0: (42) to (48) are frictionless");
}

using InPlaneForm = double (*)(const ScaledModuli&, Direction line, double cosine_from_motion, double speed);

/// The seed's own span ratio; in_plane: its form of (43).
double seed_span_ratio(const NamedPoint& x, InPlaneForm in_plane) {
  const double phi = x["phi_deg"], theta = x["theta_deg"], speed = x["speed"];
  check_seed_contact(x);
  const ScaledModuli moduli = scaled_moduli_of(x);
  if (symmetry_axis(x) == data::SymmetryAxis::normal) {
    if (std::fabs(phi) != 90)
      throw BadInput("phi_deg", phi, "must be 90 or -90: (35) is of the cross direction");
    return sphere_span_ratio_as_printed(moduli, x["friction"], speed);
  }
  const auto compliance = [&](double degrees, double cosine) {
    return in_plane(moduli, Direction::of_degrees(degrees), cosine, speed) +
           sphere_compliance(moduli, cosine, speed);
  };
  const double along = compliance(theta, 1);
  return compliance(theta + phi, Direction::of_degrees(phi).cosine) / along;
}

Quantity entry_sphere_span_ratio() {
  Quantity entry = seed_entry(
      "ti.span_ratio",
      [](NamedExact x, int digits) {
        return ref::sliding_span_ratio(exact_seed_contact(x), x["friction"], x["phi_deg"], digits);
      },
      [](NamedPoint x) { return seed_slide(x).span_ratio(Direction::of_degrees(x["phi_deg"])).value; },
      nearest_critical, draw_line_of_contact);
  const auto form = [](InPlaneForm in_plane) {
    return [in_plane](NamedPoint x) { return seed_span_ratio(x, in_plane); };
  };
  set_forms(entry, form(in_plane_compliance_as_printed), form(in_plane_compliance_as_tabulated));
  return entry;
}

Quantity entry_sphere_exponent() {
  Quantity entry = seed_entry(
      "ti.exponent",
      [](NamedExact x, int digits) {
        return ref::sliding_exponent(exact_seed_contact(x), x["friction"], x["phi_deg"], digits);
      },
      [](NamedPoint x) { return -seed_slide(x).along(Direction::of_degrees(x["phi_deg"])).leading_share; },
      nearest_critical, draw_line_of_contact);
  set_forms(entry, [](NamedPoint x) {
    check_seed_contact(x);
    if (symmetry_axis(x) == data::SymmetryAxis::in_plane) return -0.5;
    return sphere_exponent_as_printed(scaled_moduli_of(x), x["friction"], x["speed"],
                                      Direction::of_degrees(x["phi_deg"]).cosine);
  });
  return entry;
}

Quantity entry_sphere_force() {
  // Oblique to the axis the pressure's ends turn fast across the critical line, and the reference needs more lines.
  constexpr double nearest = 1 - 1e-5;
  Quantity entry = seed_entry(
      "ti.force",
      [](NamedExact x, int digits) {
        return ref::sliding_force(exact_seed_contact(x), x["friction"], digits);
      },
      [](NamedPoint x) { return seed_slide(x).force().value; }, nearest,
      [](Random& random, NamedNumbers x) { x["friction"] = draw_friction(random); });
  set_forms(entry, [](NamedPoint x) {
    check_seed_contact(x);
    const ScaledModuli moduli = scaled_moduli_of(x);
    return symmetry_axis(x) == data::SymmetryAxis::normal
               ? sphere_force_as_printed(moduli, x["friction"], x["speed"])
               : in_plane_force_as_printed(moduli, Direction::of_degrees(x["theta_deg"]), x["speed"]);
  });
  return entry;
}

Quantity entry_sphere_axis_ratio() {
  return seed_entry(
      "ti.axis_ratio",
      [](NamedExact x, int digits) {
        return ref::elliptic_axis_ratio(exact_seed_contact(x), Exact(1.0), digits);
      },
      [](NamedPoint x) {
        return fast::EllipticContact(seed_contact(x), {1, 1}).axis_ratio().value;
      },
      nearest_integrated, [](Random&, NamedNumbers) {});
}

}  // namespace

std::vector<Quantity> seed_sphere_entries() {
  return {entry_sphere_span_ratio(), entry_sphere_axis_ratio(), entry_sphere_exponent(),
          entry_sphere_force()};
}

}  // namespace nipref::verify
