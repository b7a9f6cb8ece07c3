#include <numeric>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/catalogue/internal/printed.hpp>
#include <nipref/verify/seeds/internal/solved.hpp>

namespace nipref::verify {
namespace {

/// The tractions at a place of one half of the contact.
struct Station {
  double pressure, shear, error;
};

/// The tractions of a contact with full friction, of half-length L/B on a sheet of half-thickness 1, modulus 1 and
/// nu = 1/3. Within one step of an end the oscillation r^(1/2) cos(eps ln r) may reverse the shear, negligible there.
std::vector<Station> stations(double length_over_thickness) {
  constexpr int steps = 400;
  const data::ElasticNip nip{100 * (1 + length_over_thickness), 2, {1, 1.0 / 3}};
  const auto contact = fast::converged_for_length(nip, data::Friction::full, 2 * length_over_thickness, 1e-9);
  const double half = contact.contact_length().value / 2;
  return mapped(std::views::iota(1, steps), [&](int i) -> Station {
    const double y = static_cast<double>(i) / steps * half;
    const fast::Estimate shear = contact.shear(y);
    return {contact.pressure(y).value, shear.value, shear.error};
  });
}

using Property = bool (*)(const std::vector<Station>&);

/// The L/B at which a property ends, found by bisection between a length with it and a length without it.
Propagated border_between(Property is_so, double with, double without) {
  constexpr int halvings = 7;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(with, without);
    (is_so(stations(middle)) ? with : without) = middle;
  }
  return Propagated::between(Propagated::exact(std::min(with, without)),
                             Propagated::exact(std::max(with, without)));
}

/// The first and the last L/B with a property, among lengths from 0.5 to 20 that grow by a twentieth; 0 if none has it.
struct Range {
  Propagated first = 0, last = 0;
};
Range range_where(Property is_so) {
  constexpr double lowest = 0.5, highest = 20, factor = 1.05;
  double first = 0, last = 0;
  for (double length = lowest; length < highest * factor; length *= factor) {
    const double here = std::min(length, highest);
    if (!is_so(stations(here))) continue;
    if (first == 0) first = here;
    last = here;
  }
  if (first == 0) return {};
  return {first == lowest ? Propagated::exact(lowest) : border_between(is_so, first, first / factor),
          last == highest ? Propagated::exact(highest) : border_between(is_so, last, last * factor)};
}

/// Whether the shear changes its sign beyond its error.
bool reverses(const std::vector<Station>& all) {
  double last = 0;
  for (const Station& here : all) {
    if (std::fabs(here.shear) <= here.error) continue;
    if (last * here.shear < 0) return true;
    last = here.shear;
  }
  return false;
}
bool ratio_falls(const std::vector<Station>& all) {
  return !std::ranges::is_sorted(all, {},
                                 [](const Station& here) { return std::fabs(here.shear) / here.pressure; });
}

template <Property is_so>
const Range& range_of() {
  static const Range all = range_where(is_so);
  return all;
}

constexpr const data::TransverselyIsotropicSolid& epoxy = data::seed::graphite_epoxy;
constexpr const data::IsotropicSolid& steel = data::seed::steel;

}  // namespace

Propagated printed_form(double value) { return {value, 1e-8 * std::fabs(value)}; }

const std::map<std::string, std::function<Propagated()>>& computed_numbers() {
  static const std::map<std::string, std::function<Propagated()>> all{
      {"first_reversal", [] { return range_of<reverses>().first; }},
      {"last_reversal", [] { return range_of<reverses>().last; }},
      {"first_falling_ratio", [] { return range_of<ratio_falls>().first; }},
      {"last_falling_ratio", [] { return range_of<ratio_falls>().last; }},
      {"graphite_epoxy_c11", [] { return Propagated(epoxy.c11); }},
      {"steel_shear", [] { return Propagated(steel.shear); }},
      {"graphite_epoxy_speed_scale", [] { return sqrt(Propagated(epoxy.density) / steel.density); }},
      {"branch_radicand_as_printed",
       [] { return printed_form(printed("branch_radicand_printed", {45}, scaled_moduli(epoxy, steel))); }}};
  return all;
}

}  // namespace nipref::verify
