#include <algorithm>
#include <cmath>
#include <utility>

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
  const Replay replay = std::move(replays_of({id}).front());
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

constexpr double profile_load = 100;

/// One profile without and with slip; displacements reach half a contact length beyond the ends.
Panel profile(const std::string& quantity, const std::vector<std::string>& tables) {
  Panel panel{along_elastic, {axis_label(quantity)}, {}};
  for (const std::string& table : tables) {
    const ElasticNipOfRow one = nip_of_row(table, profile_load);
    const std::string label =
        line_load_table(table).friction == data::Friction::full ? "no slip" : "complete slip";
    const double half = one.half_length();
    const bool is_pressure = quantity == "pressure", is_normal = quantity == "normal_displacement";
    const auto truth = [&](double y) {
      if (is_pressure) return one.contact.pressure(y).value;
      return (is_normal ? one.contact.normal_displacement(y) : one.contact.tangential_displacement(y)).value;
    };
    const auto thesis = [&](double y) {
      if (is_pressure) return fast::element_pressure(one.line_loads, y);
      return is_normal ? fast::normal_displacement(one.nip, one.line_loads, one.method, y)
                       : fast::tangential_displacement(one.nip, one.line_loads, one.method, y);
    };
    panel.series.push_back(sampled(label, of_continuum, Mark::line,
                                   is_pressure ? across_contact(half, 201) : evenly(-2 * half, 2 * half, 201),
                                   truth));
    panel.series.push_back(
        sampled(label, by_thesis, Mark::points, element_places(one.line_loads, !is_pressure), thesis));
  }
  return panel;
}

std::vector<Panel> along_elastic_nips(const FigureSubject& subject) {
  std::vector<Panel> panels;
  for (const std::string& quantity : subject.words) panels.push_back(profile(quantity, subject.tables));
  return panels;
}

std::vector<Panel> shears(const FigureSubject& subject) {
  Panel panel{along_elastic, {"shear on the sheet q, psi"}, {}};
  for (std::size_t i = 0; i < subject.words.size(); ++i) {
    const double load = subject.number(i);
    const ElasticNipOfRow one = nip_of_row(subject.tables.front(), load);
    const std::string label = load_label(load);
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

}  // namespace

Drawings elastic_profile_drawings() {
  return {{"along elastic", along_elastic_nips}, {"shear for loads", shears}};
}

}  // namespace nipref::verify
