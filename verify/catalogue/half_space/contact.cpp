// Contacts of rigid bodies on isotropic half-spaces, and of the seed's steel sphere on a transversely isotropic half-space
// (brock2013): by the papers' contour rule, and the exact contacts without friction.

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/sliding.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;
using fast::Direction;
using ref::Exact;

/// A rigid body on an isotropic half-space.
struct OnIsotropic {
  static constexpr auto angle = "psi_deg";

  static ref::SurfaceAnswer exact(const NamedExact& x) {
    return exact_isotropic_surface(x["poisson"], x["speed"]);
  }
  static fast::SurfaceResponse surface(const NamedPoint& x) {
    return isotropic_surface(x["poisson"], x["speed"]);
  }
  static void draw(Random& random, const NamedNumbers& x, double largest_share) {
    x["poisson"] = random.uniform(-0.5, 0.49);
    x["speed"] = draw_share(random, 0, largest_share) * critical_speed(x);
  }
  static void keep(const NamedNumbers& x) { x["poisson"] = std::clamp(x["poisson"], -0.5, 0.49); }
  static double critical_speed(const NamedPoint& x) { return fast::isotropic_rayleigh_speed(x["poisson"]); }
};

/// x + sign y, rounded once.
ref::Float sum(const ref::Float& x, const ref::Float& y, int sign) {
  ref::Float result = ref::zero_of_bits(std::max(ref::bits_of(x), ref::bits_of(y)) + 8);
  (sign > 0 ? mpfr_add : mpfr_sub)(ref::raw(result), ref::raw(x), ref::raw(y), MPFR_RNDN);
  return result;
}

/// The steel sphere on the seed's solid. Angles are measured from the direction of motion.
struct SeedSphere {
  static constexpr auto angle = "phi_deg";

  static ref::SurfaceAnswer exact(const NamedExact& x) {
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
  static fast::SurfaceResponse surface(const NamedPoint& x) {
    const Direction motion = direction_of(x, "theta_deg");
    const auto lower = std::make_shared<const fast::TransverselyIsotropicHalfSpace>(transverse_surface_of(x));
    const auto upper = isotropic_surface(data::seed::steel.poisson, x["patch"] * x["speed"]);
    return [=](Direction from_motion) {
      return fast::in_contact(in_steel(lower->along(from_motion.turned(motion))), upper(from_motion));
    };
  }
  static void draw(Random& random, const NamedNumbers& x, double largest_share) {
    x["theta_deg"] = draw_angle(random);
    x["patch"] = random.chance(0.5) ? 0 : 1;
    x["axis"] = random.chance(0.5) ? 0 : 1;
    x["speed"] = draw_share(random, 0.01, largest_share) * critical_speed(x);
  }
  static void keep(const NamedNumbers& x) { put_epoxy(x); }
  static double critical_speed(const NamedPoint& x) { return critical_speed_of(x); }
};

/// A sphere of curvature 1 with a span of 1 along the motion.
template <class Bodies>
fast::SlidingContact slide(const NamedPoint& x) {
  return fast::sliding_for_span(Bodies::surface(x), {1, 1}, x["friction"], {1, 0}, 1);
}

fast::RollingSphere roll(const NamedPoint& x, double span = 1e-3) {
  return fast::rolling_sphere_for_span(unit_isotropic(x["poisson"]), 1, x["speed"], span);
}

constexpr Direction along_motion{1, 0}, across_motion{0, 1};

Direction psi_of(const NamedPoint& x) { return direction_of(x, "psi_deg"); }

using ExactFunction = std::function<ref::Estimate(const NamedExact& x, int digits)>;

template <class Number>
const Number& number_of(const Named<const Number>& x, const char* name) {
  return x[name];
}
const auto& number_of(const auto&, const auto& number) { return number; }

/// A function of the bodies' surface, of the arguments of those names or of numbers themselves, and of the digits.
template <class Bodies>
ExactFunction exactly(auto function, auto... numbers) {
  return [=](const NamedExact& x, int digits) -> ref::Estimate {
    return function(Bodies::exact(x), number_of(x, numbers)..., digits);
  };
}

using SeedForms = std::vector<std::function<double(const NamedPoint& x)>>;
const SeedForms no_forms;

SeedForms forms(auto... functions) { return {functions...}; }
/// A form by a function of the arguments of those names or of numbers themselves.
auto printed(auto function, auto... numbers) {
  return [=](const NamedPoint& x) { return function(number_of(x, numbers)...); };
}

/// Draws the arguments that belong neither to the bodies nor to their speed.
void draw_others(Random& random, const NamedNumbers& x) {
  for (const Argument& argument : x.arguments()) {
    const std::string& name = argument.name;
    if (name == "friction") x[name] = draw_friction(random);
    if (name == "psi_deg" || name == "phi_deg") x[name] = draw_angle(random);
    if (name == "span_over_radius") x[name] = random.log_uniform(1e-9, 1);
    if (name == "curvature_ratio") x[name] = random.chance(0.3) ? 1 : random.log_uniform(1e-10, 1e10);
  }
}

/// The functions of an entry. Points have speeds up to `largest_share` of the critical one.
struct ContactRow {
  const char* name;
  double largest_share;
  ExactFunction by_ref;
  double (*by_fast)(const NamedPoint& x);
  SeedForms seed_forms = no_forms;
  double (*size)(const NamedPoint& x) = [](const NamedPoint&) { return 0.0; };
  void (*keep_more)(const NamedNumbers& x) = [](const NamedNumbers&) {};
};

template <class Bodies>
std::vector<Quantity> entries_of(const std::vector<ContactRow>& rows) {
  std::vector<Quantity> entries;
  for (const ContactRow& row : rows) {
    const auto draw = [=](Random& random, NamedNumbers x) {
      Bodies::draw(random, x, row.largest_share);
      draw_others(random, x);
      row.keep_more(x);
    };
    Quantity entry =
        sampled(entry_of(row.name, row.by_ref, row.by_fast, row.size), draw, [=](NamedNumbers x) {
          Bodies::keep(x);
          x["speed"] = std::min(x["speed"], row.largest_share * Bodies::critical_speed(x));
          row.keep_more(x);
        });
    for (std::size_t i = 0; i < row.seed_forms.size(); ++i)
      entry.seed_forms[i].value = of_point(entry, row.seed_forms[i]);
    entries.push_back(std::move(entry));
  }
  return entries;
}

template <class Bodies>
double exponent(const NamedPoint& x) {
  return -slide<Bodies>(x).along(direction_of(x, Bodies::angle)).leading_share;
}
template <class Bodies>
double force(const NamedPoint& x) {
  return slide<Bodies>(x).force().value;
}

fast::EllipticContact ellipse(const NamedPoint& x) {
  return {OnIsotropic::surface(x), {1, x["curvature_ratio"]}};
}

/// Limits the span to where the creep keeps its sign.
void keep_span(const NamedNumbers& x) {
  const fast::RollingLine line = roll(x, 1e-9).along(psi_of(x));
  const double largest = 2e-9 / (line.span * line.shear_share * line.index);
  x["span_over_radius"] = std::min(x["span_over_radius"], 0.99 * largest);
}

/// sqrt(wS/wD), P and Q of a line, and the span up to which brock2012 (52) has a root there that goes with it.
struct FiniteSpan {
  double slowness, index, share;

  /// `along` is the line of the motion at the span `span` of a sphere of radius 1.
  FiniteSpan(const NamedPoint& x, double span) {
    const fast::RollingLine line = roll(x, 1e-12).along(psi_of(x)), along = roll(x, span).along(along_motion);
    slowness = 1 / line.shear_share;
    index = line.index;
    share = along.amplitude / (line.amplitude / (line.lean / 2));  // B1 Q1/Q
  }
  [[nodiscard]] double square(double span) const { return slowness * slowness - 2 * index * share * span; }
};

double finite_span_ratio(const NamedPoint& x) {
  const double span = x["span_over_radius"];
  const FiniteSpan of(x, span);
  if (!(of.square(span) > 0)) throw BadInput("span_over_radius", span, "must be small");
  return 2 * of.share / (of.slowness + std::sqrt(of.square(span)));
}

/// Limits the span to half of that at which the root ends.
void keep_finite_span(const NamedNumbers& x) {
  const FiniteSpan of(x, 1e-12);
  const fast::RollingLine along = roll(x, 1e-12).along(along_motion);
  const double of_line = of.slowness * of.slowness / (2 * of.index * of.share);
  const double of_motion = 2 / (along.shear_share * along.index);
  x["span_over_radius"] = std::min({x["span_over_radius"], of_line / 2, of_motion / 2});
}

bool has_normal_axis(const NamedPoint& x) { return symmetry_axis(x) == data::SymmetryAxis::normal; }

/// Throws BadInput for a contact that the seed's own formulas do not describe.
void check_seed_contact(const NamedPoint& x) {
  if (x["patch"] == 0) throw BadInput("patch", "fixed", "must be moving: the seed has no other");
  if (!has_normal_axis(x) && x["friction"] != 0)
    throw BadInput("friction", x["friction"], "must be 0: (42) to (48) are frictionless");
}

/// The seed's span ratio; with the axis in the surface by the form `in_plane` of (43).
template <InPlaneForm in_plane>
double seed_span_ratio(const NamedPoint& x) {
  const double phi = x["phi_deg"], theta = x["theta_deg"], speed = x["speed"];
  check_seed_contact(x);
  const ScaledModuli moduli = scaled_moduli_of(x);
  if (has_normal_axis(x)) {
    if (std::fabs(phi) != 90)
      throw BadInput("phi_deg", phi, "must be 90 or -90: (35) is of the cross direction");
    return sphere_span_ratio_as_printed(moduli, x["friction"], speed);
  }
  return in_plane_span_ratio(in_plane, moduli, theta, phi, speed);
}

double seed_exponent(const NamedPoint& x) {
  check_seed_contact(x);
  if (!has_normal_axis(x)) return -0.5;
  return sphere_exponent_as_printed(scaled_moduli_of(x), x["friction"], x["speed"],
                                    direction_of(x, "phi_deg").cosine);
}

double seed_force(const NamedPoint& x) {
  check_seed_contact(x);
  const ScaledModuli moduli = scaled_moduli_of(x);
  return has_normal_axis(x) ? sphere_force_as_printed(moduli, x["friction"], x["speed"])
                            : in_plane_force_as_printed(moduli, direction_of(x, "theta_deg"), x["speed"]);
}

/// If the motion is oblique to the axis, the ends of the pressure change rapidly with the direction near the critical line,
/// and the reference needs more lines to integrate over.
constexpr double nearest_for_force = 1 - 1e-5;

}  // namespace

std::vector<Quantity> half_space_contact_entries() {
  using Bodies = OnIsotropic;
  const ExactFunction sliding_exponent = exactly<Bodies>(ref::sliding_exponent, "friction", "psi_deg");
  const std::vector<ContactRow> rows{
      {"die.exponent", nearest_critical, sliding_exponent, exponent<Bodies>},
      {"die.peak_place", nearest_critical,
       [=](const NamedExact& x, int digits) {
         ref::Estimate place = sliding_exponent(x, digits);
         place.value = -place.value - ref::Float(1) / 2;
         return place;
       },
       [](const NamedPoint& x) { return slide<Bodies>(x).along(psi_of(x)).leading_share - 0.5; }, no_forms,
       [](const NamedPoint&) { return 0.5; }},
      {"die.span_ratio", nearest_critical, exactly<Bodies>(ref::sliding_span_ratio, "friction", Exact(90.0)),
       [](const NamedPoint& x) { return slide<Bodies>(x).span_ratio(across_motion).value; },
       forms(printed(die_span_ratio_as_printed, "poisson", "friction", "speed"),
             printed(die_span_ratio_as_tabulated, "poisson", "friction", "speed", table_root_decimals))},
      {"die.force", nearest_integrated, exactly<Bodies>(ref::sliding_force, "friction"), force<Bodies>},
      {"rolling.index", nearest_critical, exactly<Bodies>(ref::rolling_index, "psi_deg"),
       [](const NamedPoint& x) { return roll(x).along(psi_of(x)).index; }, no_forms,
       [](const NamedPoint&) { return 0.1; }},  // it vanishes at nu = 1/2, at rest
      {"rolling.span_ratio", nearest_critical, exactly<Bodies>(ref::rolling_span_ratio, Exact(90.0)),
       [](const NamedPoint& x) { return roll(x).span_ratio(across_motion).value; },
       forms(printed(rolling_span_ratio_as_printed, "poisson", "speed"),
             printed(rolling_span_ratio_as_tabulated, "poisson", "speed", table_root_decimals))},
      {.name = "rolling.finite_span_ratio",
       .largest_share = nearest_critical,
       .by_ref = exactly<Bodies>(ref::rolling_finite_span_ratio, "psi_deg", "span_over_radius"),
       .by_fast = finite_span_ratio,
       .keep_more = keep_finite_span},
      {"rolling.strip", nearest_critical, exactly<Bodies>(ref::rolling_strip, "psi_deg"),
       [](const NamedPoint& x) {
         return fast::rolling_strip(unit_isotropic(x["poisson"]), x["speed"], psi_of(x));
       }},
      {"rolling.force", nearest_integrated, exactly<Bodies>(ref::rolling_force),
       [](const NamedPoint& x) { return roll(x, 1).force().value; }, no_forms,
       // Just below the Rayleigh speed the resultant force is a pull. The size is the force of tractions of one sign.
       [](const NamedPoint& x) { return std::numbers::pi / 6 * roll(x).along(along_motion).amplitude; }},
      {.name = "rolling.creep",
       .largest_share = nearest_critical,
       .by_ref = exactly<Bodies>(ref::rolling_creep, "psi_deg", "span_over_radius"),
       .by_fast =
           [](const NamedPoint& x) { return roll(x, x["span_over_radius"]).along(psi_of(x)).creep.value; },
       .seed_forms =
           forms(printed(rolling_creep_as_printed, "poisson", "speed", "psi_deg", "span_over_radius")),
       .keep_more = keep_span},
      {"ellipse.axis_ratio", nearest_integrated, exactly<Bodies>(ref::elliptic_axis_ratio, "curvature_ratio"),
       [](const NamedPoint& x) { return ellipse(x).axis_ratio().value; }},
      {"ellipse.stiffness", nearest_integrated, exactly<Bodies>(ref::elliptic_stiffness, "curvature_ratio"),
       [](const NamedPoint& x) {
         return ellipse(x).for_approach(1).force.value * std::sqrt((1 + x["curvature_ratio"]) / 2);
       }}};
  return entries_of<Bodies>(rows);
}

std::vector<Quantity> seed_sphere_entries() {
  using Bodies = SeedSphere;
  const std::vector<ContactRow> rows{
      {"ti.span_ratio", nearest_critical, exactly<Bodies>(ref::sliding_span_ratio, "friction", "phi_deg"),
       [](const NamedPoint& x) { return slide<Bodies>(x).span_ratio(direction_of(x, "phi_deg")).value; },
       forms(seed_span_ratio<InPlaneForm::printed>, seed_span_ratio<InPlaneForm::tabulated>)},
      {"ti.axis_ratio", nearest_integrated, exactly<Bodies>(ref::elliptic_axis_ratio, Exact(1.0)),
       [](const NamedPoint& x) {
         return fast::EllipticContact(Bodies::surface(x), {1, 1}).axis_ratio().value;
       }},
      {"ti.exponent", nearest_critical, exactly<Bodies>(ref::sliding_exponent, "friction", "phi_deg"),
       exponent<Bodies>, forms(seed_exponent)},
      {"ti.force", nearest_for_force, exactly<Bodies>(ref::sliding_force, "friction"), force<Bodies>,
       forms(seed_force)}};
  return entries_of<Bodies>(rows);
}

}  // namespace nipref::verify
