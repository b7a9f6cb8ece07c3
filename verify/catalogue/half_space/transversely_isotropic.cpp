// Responses of transversely isotropic half-spaces along lines, and their critical speeds.

#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/bulk_wave.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/half_space/internal/printed.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::SymmetryAxis;
using fast::Direction;
using fast::LineResponse;

/// Draws a solid of positive strain energy, whose stiffnesses span two decades, or sometimes the seed's solid. Returns the
/// number of one of the two directions of the axis.
double draw_solid(Random& random, const NamedNumbers& x) {
  const double axis = random.chance(0.5) ? 0 : 1;
  if (random.chance(0.1)) return axis;  // the default
  const double c66 = x["c66"] = random.log_uniform(1, 100);
  x["c44"] = random.log_uniform(1, 100);
  x["c11"] = c66 * (1 + random.log_uniform(1e-2, 100));
  x["c33"] = random.log_uniform(1, 1000);
  x["c13"] = random.uniform(-0.99, 0.99) * std::sqrt((x["c11"] - c66) * x["c33"]);
  x["density"] = random.log_uniform(500, 2e4);
  return axis;
}

/// Replaces a solid that does not exist, to which a step of the audit's search may lead.
void keep_physical(const NamedNumbers& x) {
  if (is_refused([&] { transverse_of(x).check(); })) put_epoxy(x);
}

void draw_line_of_solid(Random& random, const NamedNumbers& x) {
  x["theta_deg"] = draw_degrees(random);
  x["psi_deg"] = draw_degrees(random);
  x["axis"] = draw_solid(random, x);
  x["speed"] = draw_share(random) * critical_speed_of(x);
}

/// `by_ref` is a function of solid, speed, motion, psi and digits.
template <class Ref, class Fast, class Size>
Quantity transverse_line_entry(const char* name, Ref by_ref, Fast by_fast, Size size) {
  const auto of_line = [by_ref](NamedExact x, int digits) {
    check_subcritical(x);
    return by_ref(exact_transverse_of(x, symmetry_axis(x)), x["speed"], direction_of(x, "theta_deg"),
                  direction_of(x, "psi_deg"), digits);
  };
  return sampled(entry_of(name, of_line, by_fast, size), draw_line_of_solid, [](NamedNumbers x) {
    keep_physical(x);
    x["speed"] = std::min(x["speed"], nearest_critical * critical_speed_of(x));
  });
}

Quantity transverse_line(const char* name, double LineResponse::*of_fast,
                         ref::Enclosure ref::LineResponse::*of_ref) {
  const auto response = [](NamedPoint x) {
    return in_steel(transverse_surface_of(x).along(direction_of(x, "psi_deg")));
  };
  return transverse_line_entry(
      name, [of_ref](const auto&... x) { return ref::line_response(x...).*of_ref; },
      [=](NamedPoint x) { return response(x).*of_fast; },
      [=](NamedPoint x) { return response(x).compliance; });
}

Quantity entry_transverse_compliance() {
  Quantity entry =
      transverse_line("ti.compliance", &LineResponse::compliance, &ref::LineResponse::compliance);
  // The seed's own K with the axis in the surface.
  const auto seed_form = [](InPlaneForm form) {
    return [form](NamedPoint x) {
      if (symmetry_axis(x) == SymmetryAxis::normal)
        throw data::BadInput("axis", "normal", "must be in-plane: elsewhere the seed has no other form");
      const double cosine = Direction::of_degrees(x["psi_deg"] - x["theta_deg"]).cosine;
      return in_plane_compliance(form, scaled_moduli_of(x), direction_of(x, "psi_deg"), cosine, x["speed"]);
    };
  };
  set_forms(entry, seed_form(InPlaneForm::printed), seed_form(InPlaneForm::tabulated));
  return entry;
}

// The order of their names on the command line.
constexpr fast::BranchWave branch_waves[] = {
    fast::BranchWave::transverse, fast::BranchWave::quasi_longitudinal, fast::BranchWave::quasi_transverse};
constexpr ref::BulkWave bulk_waves[] = {ref::BulkWave::upright, ref::BulkWave::faster, ref::BulkWave::slower};

/// The axis lies in the surface.
Quantity entry_branch() {
  const Quantity entry = entry_of(
      "ti.branch",
      [](NamedExact x, int digits) {
        return ref::bulk_wave_speed(exact_transverse_of(x, SymmetryAxis::in_plane),
                                    direction_of(x, "theta_deg"), bulk_waves[x.choice("which")], digits);
      },
      [](NamedPoint x) {
        return speed_in_steel(fast::branch_speed(branch_waves[x.choice("which")], transverse_of(x),
                                                 direction_of(x, "theta_deg")));
      });
  const auto draw = [](Random& random, NamedNumbers x) {
    x["theta_deg"] = draw_degrees(random);
    x["which"] = static_cast<double>(random.index(3));
    draw_solid(random, x);
  };
  return sampled(entry, draw, keep_physical);
}

Quantity entry_transverse_critical() {
  const Quantity entry = entry_of(
      "ti.critical",
      [](NamedExact x, int digits) {
        return ref::critical_speed(exact_transverse_of(x, symmetry_axis(x)), direction_of(x, "theta_deg"),
                                   digits)
            .speed;
      },
      critical_speed_of);
  const auto draw = [](Random& random, NamedNumbers x) {
    x["theta_deg"] = draw_angle(random);
    x["axis"] = random.chance(0.2) ? 0 : 1;
  };
  // Only the seed's solid: in others a bulk wave may be what makes the first line critical, or nearly so, and the
  // reference proves the speed of surface waves only.
  return sampled(entry, draw, put_epoxy);
}

Quantity entry_transverse_rayleigh() {
  const Quantity entry = entry_of(
      "ti.rayleigh",
      [](NamedExact x, int digits) {
        const auto found =
            ref::surface_wave_speed(exact_transverse_of(x, symmetry_axis(x)), direction_of(x, "theta_deg"),
                                    direction_of(x, "psi_deg"), digits);
        if (!found)
          throw data::BadInput("psi_deg", "(as given)", "must be a direction that has a surface wave");
        return *found;
      },
      [](NamedPoint x) {
        return speed_in_steel(fast::rayleigh_speed(transverse_of(x), symmetry_axis(x),
                                                   direction_of(x, "theta_deg"), direction_of(x, "psi_deg")));
      });
  const auto draw = [](Random& random, NamedNumbers x) {
    x["theta_deg"] = draw_angle(random);
    x["psi_deg"] = x["theta_deg"] + random.uniform(-60, 60);
    x["axis"] = random.chance(0.2) ? 0 : 1;
  };
  return sampled(entry, draw, put_epoxy);
}

}  // namespace

std::vector<Quantity> transverse_half_space_entries() {
  return {entry_transverse_compliance(),
          transverse_line("ti.coupling", &LineResponse::coupling, &ref::LineResponse::coupling),
          transverse_line("ti.coupling_across", &LineResponse::coupling_across,
                          &ref::LineResponse::coupling_across),
          transverse_line_entry(
              "ti.condition", exact_condition,
              [](NamedPoint x) { return transverse_surface_of(x).condition(direction_of(x, "psi_deg")); },
              [](NamedPoint) { return 1.0; }),
          entry_transverse_rayleigh(),
          entry_branch(),
          entry_transverse_critical()};
}

}  // namespace nipref::verify
