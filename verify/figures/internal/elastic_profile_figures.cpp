#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads_displacements.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>

// Pressure, shear and displacements along elastic nips. (thesis 5.7)

namespace nipref::verify {
namespace {

constexpr double profile_accuracy = 1e-8;

/// One row of a table: its continuous contact, at the table's load, and its line loads, from the printed length.
struct ElasticNipOfRow {
  data::ElasticNip nip;
  fast::ConvergedElasticNip contact;
  fast::LineLoadMethod method;
  fast::LineLoadSolution line_loads;

  [[nodiscard]] double half_length() const { return contact.contact_length().value / 2; }
};

ElasticNipOfRow nip_of_row(const std::string& id, double load) {
  const Replay replay = replay_table(id);
  std::size_t row = 0;
  while (key_of_row(replay.table, row) != load) ++row;
  const LineLoadTable& how = line_load_table(id);
  const data::ElasticNip nip = nip_of_the_tables(replay.table);
  const fast::LineLoadMethod method(how.elements_per_side);
  const RowValues& values = replay.nips[row].values;
  return {nip, fast::converged_for_load(nip, how.friction, load, profile_accuracy), method,
          how.friction == data::Friction::full
              ? fast::gripped_line_loads_for_length(nip, method, values.at("L"), values.at("creep"))
              : fast::line_loads_for_length(nip, method, values.at("L"))};
}

const FigureAxis along_elastic{"distance from the middle of the nip Y, in"};
const std::string no_slip = "no slip", complete_slip = "complete slip";

/// From -half to half, closer towards the ends.
std::vector<double> across_contact(double half, int count) {
  std::vector<double> y = evenly(-1, 1, count);
  for (double& place : y) place = half * std::sin(std::acos(-1.0) / 2 * place);
  return y;
}

/// Middles of the elements, or, one more of them, their ends.
std::vector<double> element_places(const fast::LineLoadSolution& loads, bool ends) {
  const auto count = 2 * static_cast<int>(loads.line_loads.size());
  const double reach = (loads.contact_length - (ends ? 0 : loads.element_width())) / 2;
  return evenly(-reach, reach, count + (ends ? 1 : 0));
}

std::vector<Panel> pressures() {
  Panel panel{along_elastic, {"pressure p, psi"}, {}};
  for (const auto& [label, table] : {std::pair{no_slip, "thesis-VI"}, {complete_slip, "thesis-X"}}) {
    const ElasticNipOfRow one = nip_of_row(table, 100);
    panel.series.push_back(sampled(label, of_continuum, Mark::line, across_contact(one.half_length(), 201),
                                   [&](double y) { return one.contact.pressure(y).value; }));
    panel.series.push_back(sampled(label, by_thesis, Mark::points, element_places(one.line_loads, false),
                                   [&](double y) { return fast::element_pressure(one.line_loads, y); }));
  }
  return {panel};
}

std::vector<Panel> shears() {
  Panel panel{along_elastic, {"shear on the sheet q, psi"}, {}};
  for (const double load : {25.0, 50.0, 100.0, 200.0}) {
    const ElasticNipOfRow one = nip_of_row("thesis-VI", load);
    const std::string label = fmt::format("W = {:g} lbf/in", load);
    Series curve = sampled(label, of_continuum, Mark::line, across_contact(one.half_length(), 401),
                           [&](double y) { return one.contact.shear(y).value; });
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(curve.y) - curve.y.begin());
    Series largest{label, at_largest, Mark::star, {curve.x[peak]}, {one.contact.peak_shear().value}};
    panel.series.push_back(std::move(curve));
    panel.series.push_back(std::move(largest));
    panel.series.push_back(sampled(label, by_thesis, Mark::points, element_places(one.line_loads, false),
                                   [&](double y) { return fast::element_shear(one.line_loads, y); }));
  }
  return {panel};
}

std::vector<Panel> displacements(const std::string& gripped, const std::string& smooth) {
  Panel normal{along_elastic, {"normal displacement u, in"}, {}},
      tangential{along_elastic, {"tangential displacement v, in"}, {}};
  for (const auto& [label, table] : {std::pair{no_slip, gripped}, {complete_slip, smooth}}) {
    const ElasticNipOfRow one = nip_of_row(table, 100);
    const std::vector<double> y = evenly(-2 * one.half_length(), 2 * one.half_length(), 201);
    const std::vector<double> ends = element_places(one.line_loads, true);
    const auto append = [&](Panel& panel, const Curve& truth, const Curve& thesis) {
      panel.series.push_back(sampled(label, of_continuum, Mark::line, y, truth));
      panel.series.push_back(sampled(label, by_thesis, Mark::points, ends, thesis));
    };
    append(
        normal, [&](double at) { return one.contact.normal_displacement(at).value; },
        [&](double at) { return fast::normal_displacement(one.nip, one.line_loads, one.method, at); });
    append(
        tangential, [&](double at) { return one.contact.tangential_displacement(at).value; },
        [&](double at) { return fast::tangential_displacement(one.nip, one.line_loads, one.method, at); });
  }
  return {normal, tangential};
}

}  // namespace

std::vector<FigurePlan> elastic_profile_figures() {
  const std::string shared = "elastic, R = 6 in, E = 1.40536e5 psi, nu = 1/3, B = ";
  return {{"thesis-26", "Pressure along the nip: no slip and complete slip",
           shared + "0.005 in, W = 100 lbf/in", pressures},
          {"thesis-27", "Shear along the nip without slip, with its largest, for four loads",
           shared + "0.005 in", shears},
          {"thesis-28", "Displacements of a thick sheet's surface in and outside the nip",
           shared + "1 in, W = 100 lbf/in", [] { return displacements("thesis-III", "thesis-VII"); }},
          {"thesis-29", "Displacements of a thin sheet's surface in and outside the nip",
           shared + "0.005 in, W = 100 lbf/in", [] { return displacements("thesis-VI", "thesis-X"); }}};
}

}  // namespace nipref::verify
