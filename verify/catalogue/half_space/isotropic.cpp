// Responses of isotropic half-spaces along lines, and their critical speed.

#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/ref/half_space/critical_speed.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>
#include <nipref/verify/catalogue/half_space/internal/arguments.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Direction;
using ref::Exact;
using ref::SurfaceDirection;

ExactLine isotropic_line_at(const NamedExact& x) {
  return {exact_isotropic(x["poisson"]), x["speed"], SurfaceDirection::of_degrees(Exact(0.0)),
          direction_of(x, "psi_deg")};
}
ExactLine subcritical_isotropic(const NamedExact& x) { return isotropic_line_at(x).checked(); }

/// An entry by functions `by_ref` of a NamedExact and digits, and `by_fast` of solid, speed and direction.
template <class Ref, class Fast>
Quantity line_entry(const char* name, Ref by_ref, Fast by_fast) {
  Quantity entry = described(name);
  entry.by_ref = of_point(entry, by_ref);
  set_fast(entry, of_point(entry, {"poisson", "speed", "psi_deg"},
                           [by_fast](double poisson, double speed, double psi_deg) {
                             return by_fast(unit_isotropic(poisson), speed, Direction::of_degrees(psi_deg));
                           }));
  return entry;
}

Quantity isotropic_line(const char* name, double fast::LineResponse::*of_fast,
                        ref::Enclosure ref::LineResponse::*of_ref) {
  return line_entry(name, component_of(subcritical_isotropic, of_ref),
                    [of_fast](const auto&... line) { return fast::isotropic_response(line...).*of_fast; });
}

/// The response of lines along which the load is faster than Rayleigh waves and slower than shear waves;
/// line_response() solves the equations there, too. Throws BadInput at other speeds.
ref::LineResponse response_beyond(const NamedExact& x, int digits) {
  ref::LineResponse found = isotropic_line_at(x).response(digits);
  if (!(found.compliance.value < ref::Float(0)))
    throw data::BadInput("speed", x["speed"].text(),
                         "must be, along the line, between those of Rayleigh and of shear waves");
  return found;
}

Quantity response_beyond_entry(const char* name, double fast::LineResponse::*of_fast,
                               ref::Enclosure ref::LineResponse::*of_ref) {
  return line_entry(
      name, [of_ref](const NamedExact& x, int digits) { return response_beyond(x, digits).*of_ref; },
      [of_fast](const auto&... line) { return fast::isotropic_response_beyond(line...).*of_fast; });
}

/// The response to shear along or across a line. Shear across it needs the waves that sagittal_stiffness leaves out.
ref::Enclosure shear_by_ref(ref::Enclosure ref::LineResponse::*member, const NamedExact& x, int digits) {
  const Exact unit(1.0);
  ExactLine line = subcritical_isotropic(x);
  line.solid = ref::exact_stiffness(ref::ExactTransverse::isotropic(unit, x["poisson"], unit),
                                    data::SymmetryAxis::normal);
  // Near the critical speed the bound is that of the compliance, which is much larger than the response across the
  // line. More digits make up for this.
  const auto bound_over_value = [](const ref::Enclosure& found) {
    return mpfr_get_exp(ref::raw(found.error)) - mpfr_get_exp(ref::raw(found.value));
  };
  ref::Enclosure found = line.response(digits).*member;
  const auto asked = static_cast<long>(-digits / std::log10(2.0));
  if (const long lacking = bound_over_value(found) - asked; lacking > 0) {
    found =
        line.response(digits + 2 + static_cast<int>(static_cast<double>(lacking) * std::log10(2.0))).*member;
    found.digits = digits;
  }
  return found;
}

Quantity isotropic_shear(const char* name, double fast::ShearResponse::*of_fast,
                         ref::Enclosure ref::LineResponse::*of_ref) {
  return line_entry(
      name, [of_ref](const NamedExact& x, int digits) { return shear_by_ref(of_ref, x, digits); },
      [of_fast](const auto&... line) { return fast::isotropic_shear_response(line...).*of_fast; });
}

}  // namespace

std::vector<Quantity> half_space_entries() {
  using fast::LineResponse;
  using fast::ShearResponse;
  return {
      isotropic_line("halfspace.compliance", &LineResponse::compliance, &ref::LineResponse::compliance),
      isotropic_line("halfspace.coupling", &LineResponse::coupling, &ref::LineResponse::coupling),
      isotropic_shear("halfspace.in_line", &ShearResponse::in_line, &ref::LineResponse::in_line),
      isotropic_shear("halfspace.across", &ShearResponse::across, &ref::LineResponse::across),
      response_beyond_entry("halfspace.compliance_beyond", &LineResponse::compliance,
                            &ref::LineResponse::compliance),
      response_beyond_entry("halfspace.coupling_beyond", &LineResponse::coupling,
                            &ref::LineResponse::coupling),
      line_entry(
          "halfspace.rolling_index_beyond",
          [](const NamedExact& x, int digits) {
            const auto answer = [&](const Exact&, int some) { return line_answer(response_beyond(x, some)); };
            return ref::rolling_index_beyond(answer, x["psi_deg"], digits);
          },
          fast::rolling_index_beyond),
      line_entry(
          "halfspace.condition",
          [](const NamedExact& x, int digits) { return exact_condition(subcritical_isotropic(x), digits); },
          fast::isotropic_condition),
      entry_of(
          "halfspace.rayleigh", {"poisson"},
          [](const Exact& poisson, int digits) {
            const auto line = SurfaceDirection::of_degrees(Exact(0.0));
            return ref::surface_wave_speed(exact_isotropic(poisson), line, line, digits).value();
          },
          fast::isotropic_rayleigh_speed),
      entry_of(
          "halfspace.separation", {"poisson", "speed"},
          [](const Exact& poisson, const Exact& speed, int digits) {
            if (speed.value() > 1)
              throw data::BadInput("speed", speed.text(), "must be at most 1, that of shear waves");
            return ref::separation_degrees(exact_isotropic(poisson), speed, digits);
          },
          [](double poisson, double speed) {
            return fast::separation_angle(poisson, speed) * (180 / std::numbers::pi);
          })};
}

}  // namespace nipref::verify
