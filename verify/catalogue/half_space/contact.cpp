// Contacts of rigid bodies on isotropic half-spaces, and of the seed's steel sphere on a transversely isotropic
// half-space (brock2013): by the papers' contour rule, and exactly without friction.

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

/// Makes an evaluator from a function of the bodies' surface, numbers (or names of arguments), and the digits.
template <class Bodies>
ExactFunction exactly(auto function, auto... numbers) {
  return [=](const NamedExact& x, int digits) -> ref::Estimate {
    return function(Bodies::exact(x), number_of(x, numbers)..., digits);
  };
}

/// The functions of an entry.
struct ContactRow {
  const char* name;
  ExactFunction by_ref;
  double (*by_fast)(const NamedPoint& x);
  double (*size)(const NamedPoint& x) = nullptr;  ///< if the row of the table has none
};

std::vector<Quantity> entries_of(const std::vector<ContactRow>& rows) {
  return mapped(rows, [](const ContactRow& row) {
    return row.size == nullptr ? entry_of(row.name, row.by_ref, row.by_fast)
                               : entry_of(row.name, row.by_ref, row.by_fast, row.size);
  });
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

/// The largest span at which the creep keeps its sign.
double longest_span(const NamedPoint& x) {
  const fast::RollingLine line = roll(x, 1e-9).along(psi_of(x));
  const double largest = 2e-9 / (line.span * line.shear_share * line.index);
  return 0.99 * largest;
}

/// The quadratic equation of L/L1 for a line of a sphere of radius 1, where L1 is the span along the motion:
///   slowness L/L1 - P L1/2 (L/L1)^2 = B1 Q1/Q     (brock2012 52, signs corrected)
struct SpanEquation {
  double slowness;    ///< sqrt(wS/wD)
  double index;       ///< P
  double right_side;  ///< B1 Q1/Q

  SpanEquation(const NamedPoint& x, double L1) {
    const fast::RollingLine line = roll(x, 1e-12).along(psi_of(x)), along = roll(x, L1).along(along_motion);
    slowness = 1 / line.shear_share;
    index = line.index;
    const double half_Q = line.amplitude / (line.lean / 2);  // the amplitude is B Q/2, and lean is 2B
    right_side = along.amplitude / half_Q;
  }
  [[nodiscard]] double discriminant(double L1) const {
    return slowness * slowness - 2 * index * right_side * L1;
  }
};

double finite_span_ratio(const NamedPoint& x) {
  const double L1 = x["span_over_radius"];
  const SpanEquation equation(x, L1);
  const double discriminant = equation.discriminant(L1);
  if (!(discriminant > 0)) throw BadInput("span_over_radius", L1, "must be small");
  return 2 * equation.right_side / (equation.slowness + std::sqrt(discriminant));
}

/// Half of the span L1 at which the discriminant is 0 with the B1 of short spans, or at which B1 itself is 0.
double longest_finite_span(const NamedPoint& x) {
  const SpanEquation of(x, 1e-12);
  const fast::RollingLine along = roll(x, 1e-12).along(along_motion);
  const double ends_root = of.slowness * of.slowness / (2 * of.index * of.right_side);
  const double ends_B1 = 2 / (along.shear_share * along.index);
  return std::min(ends_root / 2, ends_B1 / 2);
}

/// V0 of (brock2012 48) as printed, where P has the wrong sign.
double creep_as_printed(const NamedPoint& x) {
  const fast::RollingLine line = roll(x, x["span_over_radius"]).along(psi_of(x));
  return line.span * (line.span / 16 * (1 - 4 * line.index * line.index) - line.index / line.shear_share);
}

}  // namespace

const PointFunctions& point_functions() {
  static const PointFunctions all{
      {"rayleigh", [](const NamedPoint& x) { return fast::isotropic_rayleigh_speed(x["poisson"]); }},
      {"critical", critical_speed_of},
      {"unphysical",
       [](const NamedPoint& x) { return is_refused([&] { transverse_of(x).check(); }) ? 1.0 : 0.0; }},
      {"longest_span", longest_span},
      {"longest_finite_span", longest_finite_span},
      {"creep_as_printed", creep_as_printed}};
  return all;
}

std::vector<Quantity> half_space_contact_entries() {
  using Bodies = OnIsotropic;
  const ExactFunction sliding_exponent = exactly<Bodies>(ref::sliding_exponent, "friction", "psi_deg");
  const std::vector<ContactRow> rows{
      {"die.exponent", sliding_exponent, exponent<Bodies>},
      {"die.peak_place",
       [=](const NamedExact& x, int digits) {
         ref::Estimate place = sliding_exponent(x, digits);
         place.value = -place.value - ref::Float(1) / 2;
         return place;
       },
       [](const NamedPoint& x) { return slide<Bodies>(x).along(psi_of(x)).leading_share - 0.5; }},
      {"die.span_ratio", exactly<Bodies>(ref::sliding_span_ratio, "friction", Exact(90.0)),
       [](const NamedPoint& x) { return slide<Bodies>(x).span_ratio(across_motion).value; }},
      {"die.force", exactly<Bodies>(ref::sliding_force, "friction"), force<Bodies>},
      {"rolling.index", exactly<Bodies>(ref::rolling_index, "psi_deg"),
       [](const NamedPoint& x) { return roll(x).along(psi_of(x)).index; }},
      {"rolling.span_ratio", exactly<Bodies>(ref::rolling_span_ratio, Exact(90.0)),
       [](const NamedPoint& x) { return roll(x).span_ratio(across_motion).value; }},
      {"rolling.finite_span_ratio",
       exactly<Bodies>(ref::rolling_finite_span_ratio, "psi_deg", "span_over_radius"), finite_span_ratio},
      {"rolling.strip", exactly<Bodies>(ref::rolling_strip, "psi_deg"),
       [](const NamedPoint& x) {
         return fast::rolling_strip(unit_isotropic(x["poisson"]), x["speed"], psi_of(x));
       }},
      {"rolling.force", exactly<Bodies>(ref::rolling_force),
       [](const NamedPoint& x) { return roll(x, 1).force().value; },
       // Just below the Rayleigh speed the resultant force is a pull. The size is the force of tractions of one sign.
       [](const NamedPoint& x) { return std::numbers::pi / 6 * roll(x).along(along_motion).amplitude; }},
      {"rolling.creep", exactly<Bodies>(ref::rolling_creep, "psi_deg", "span_over_radius"),
       [](const NamedPoint& x) { return roll(x, x["span_over_radius"]).along(psi_of(x)).creep.value; }},
      {"ellipse.axis_ratio", exactly<Bodies>(ref::elliptic_axis_ratio, "curvature_ratio"),
       [](const NamedPoint& x) { return ellipse(x).axis_ratio().value; }},
      {"ellipse.stiffness", exactly<Bodies>(ref::elliptic_stiffness, "curvature_ratio"),
       [](const NamedPoint& x) {
         return ellipse(x).for_approach(1).force.value * std::sqrt((1 + x["curvature_ratio"]) / 2);
       }}};
  return entries_of(rows);
}

std::vector<Quantity> seed_sphere_entries() {
  using Bodies = SeedSphere;
  const std::vector<ContactRow> rows{
      {"ti.span_ratio", exactly<Bodies>(ref::sliding_span_ratio, "friction", "phi_deg"),
       [](const NamedPoint& x) { return slide<Bodies>(x).span_ratio(direction_of(x, "phi_deg")).value; }},
      {"ti.axis_ratio", exactly<Bodies>(ref::elliptic_axis_ratio, Exact(1.0)),
       [](const NamedPoint& x) {
         return fast::EllipticContact(Bodies::surface(x), {1, 1}).axis_ratio().value;
       }},
      {"ti.exponent", exactly<Bodies>(ref::sliding_exponent, "friction", "phi_deg"), exponent<Bodies>},
      {"ti.force", exactly<Bodies>(ref::sliding_force, "friction"), force<Bodies>}};
  return entries_of(rows);
}

}  // namespace nipref::verify
