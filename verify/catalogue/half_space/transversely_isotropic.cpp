// Responses of transversely isotropic half-spaces along lines, and their critical speeds.

#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::SymmetryAxis;
using fast::Direction;
using fast::LineResponse;

ExactLine subcritical_transverse(const NamedExact& x) {
  check_subcritical(x);
  return {exact_transverse_of(x, symmetry_axis(x)), x["speed"], direction_of(x, "theta_deg"),
          direction_of(x, "psi_deg")};
}

Quantity transverse_line(const char* name, double LineResponse::*of_fast,
                         ref::Enclosure ref::LineResponse::*of_ref) {
  const auto response = [](NamedPoint x) {
    return in_steel(transverse_surface_of(x).along(direction_of(x, "psi_deg")));
  };
  return entry_of(
      name, component_of(subcritical_transverse, of_ref), [=](NamedPoint x) { return response(x).*of_fast; },
      [=](NamedPoint x) { return response(x).compliance; });
}

// In the order of their names on the command line.
constexpr fast::BranchWave branch_waves[] = {
    fast::BranchWave::transverse, fast::BranchWave::quasi_longitudinal, fast::BranchWave::quasi_transverse};
constexpr ref::BulkWave bulk_waves[] = {ref::BulkWave::upright, ref::BulkWave::faster, ref::BulkWave::slower};

}  // namespace

std::vector<Quantity> transverse_half_space_entries() {
  return {
      transverse_line("ti.compliance", &LineResponse::compliance, &ref::LineResponse::compliance),
      transverse_line("ti.coupling", &LineResponse::coupling, &ref::LineResponse::coupling),
      transverse_line("ti.coupling_across", &LineResponse::coupling_across,
                      &ref::LineResponse::coupling_across),
      entry_of(
          "ti.condition",
          [](NamedExact x, int digits) { return exact_condition(subcritical_transverse(x), digits); },
          [](NamedPoint x) { return transverse_surface_of(x).condition(direction_of(x, "psi_deg")); }),
      entry_of(
          "ti.rayleigh",
          [](NamedExact x, int digits) {
            const auto found =
                ref::surface_wave_speed(exact_transverse_of(x, symmetry_axis(x)),
                                        direction_of(x, "theta_deg"), direction_of(x, "psi_deg"), digits);
            if (!found)
              throw data::BadInput("psi_deg", "(as given)", "must be a direction that has a surface wave");
            return *found;
          },
          [](NamedPoint x) {
            return speed_in_steel(fast::rayleigh_speed(transverse_of(x), symmetry_axis(x),
                                                       direction_of(x, "theta_deg"),
                                                       direction_of(x, "psi_deg")));
          }),
      // The axis lies in the surface.
      entry_of(
          "ti.branch",
          [](NamedExact x, int digits) {
            return ref::bulk_wave_speed(exact_transverse_of(x, SymmetryAxis::in_plane),
                                        direction_of(x, "theta_deg"), bulk_waves[x.choice("which")], digits);
          },
          [](NamedPoint x) {
            return speed_in_steel(fast::branch_speed(branch_waves[x.choice("which")], transverse_of(x),
                                                     direction_of(x, "theta_deg")));
          }),
      entry_of(
          "ti.critical",
          [](NamedExact x, int digits) {
            return ref::critical_speed(exact_transverse_of(x, symmetry_axis(x)), direction_of(x, "theta_deg"),
                                       digits)
                .speed;
          },
          critical_speed_of)};
}

}  // namespace nipref::verify
