#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include <nipref/data/problem/partial_slip.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/mapped.hpp>

// The nip with Coulomb's friction: its creep against the traction, and its zones of slip against the coefficient of friction.

namespace nipref::verify {
namespace {

constexpr double accuracy = 1e-3;

/// The thesis's material and rollers. With the scales of the axes neither they nor the thickness matter.
constexpr data::ElasticNip nip = data::seed::nip(0.005);

/// The load under which a contact without friction is so many thicknesses long. Friction changes that length by 3 % at most.
double load_of(double thicknesses) {
  return fast::converged_for_length(nip, data::Friction::none, thicknesses * nip.sheet_thickness, accuracy)
      .load()
      .value;
}

/// traction: over mu W
fast::PartialSlipNip rolling(double load, double mu, double traction) {
  return fast::partial_slip_for_load({nip, mu, data::GivenTraction{traction * mu * load}}, load, accuracy);
}

/// A panel for each length.
std::vector<Panel> creep_panels(const FigureSubject& subject) {
  return mapped(subject.numbers("L/B"), [&](double thicknesses) {
    const double load = load_of(thicknesses);
    auto curves = mapped(subject.numbers("mu"), [&](double mu) {
      return computed(fmt::format("mu = {:g}", mu), of_continuum, Mark::line, subject.numbers("traction"),
                      [&](double traction) {
                        const auto contact = rolling(load, mu, traction);
                        return contact.creep_ratio().value * nip.roller_radius /
                               (mu * contact.contact_length().value);
                      });
    });
    return Panel{{"traction T/(mu W)"},
                 {fmt::format("creep ratio times R/(mu L), L/B = {:g}", thicknesses)},
                 std::move(curves)};
  });
}

/// Along the contact, from its trailing end at 0 to its leading end at 1.
struct SlipZone {
  int sign;  ///< of the shear
  double first, last;
};

std::vector<SlipZone> slip_zones(const fast::PartialSlipNip& contact) {
  const std::vector<fast::Estimate> boundaries = contact.zone_boundaries();
  const double exit = boundaries.back().value, entry = boundaries.front().value;
  const auto places = mapped(boundaries, [&](const auto& y) { return (y.value - exit) / (entry - exit); });
  const std::vector<int> signs = contact.zone_signs();
  std::vector<SlipZone> zones;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] != 0) zones.push_back({signs[i], places[i + 1], places[i]});
  }
  return zones;
}

/// A bar for each zone with that sign; zones[i] are those at mu[i].
Series bars_of(std::string label, int sign, const std::vector<double>& mu,
               const std::vector<std::vector<SlipZone>>& zones) {
  Series bars{std::move(label), of_continuum, Mark::bars, {}, {}};
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (const SlipZone& zone : zones[i]) {
      if (zone.sign != sign) continue;
      bars.x.push_back(mu[i]);
      bars.y.push_back((zone.first + zone.last) / 2);
      bars.low.push_back(zone.first);
      bars.high.push_back(zone.last);
    }
  }
  return bars;
}

/// The same.
std::vector<Panel> zone_panels(const FigureSubject& subject) {
  const std::vector<double> mu = subject.numbers("mu");
  return mapped(subject.numbers("L/B"), [&](double thicknesses) {
    const double load = load_of(thicknesses), traction = subject.number("traction");
    const auto zones =
        parallel_mapped(mu.size(), [&](std::size_t i) { return slip_zones(rolling(load, mu[i], traction)); });
    return Panel{{"coefficient of friction mu", true},
                 {fmt::format("place over L from exit to entry, L/B = {:g}", thicknesses)},
                 {bars_of("slip, shear towards the entry", 1, mu, zones),
                  bars_of("slip, shear towards the exit", -1, mu, zones)}};
  });
}

}  // namespace

Drawings partial_slip_drawings() {
  return {{"creep against traction", creep_panels}, {"zones against friction", zone_panels}};
}

}  // namespace nipref::verify
