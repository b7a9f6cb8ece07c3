#include <fmt/format.h>

#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <map>
#include <utility>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>
#include <nipref/verify/replay/internal/viscoelastic_nip.hpp>
#include <nipref/verify/support/internal/cache.hpp>

// The viscoelastic nip. (thesis 7.5)

namespace nipref::verify {
namespace {

constexpr double rolling_curve_accuracy = 1e-6, thin = 0.005;

/// memory: F0 tau, in.
fast::ConvergedViscoelasticNip rolling_contact(double thickness, double load, double memory) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  const auto solid = data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, memory);
  return fast::converged_for_load({data::seed::roller_radius, thickness, solid, 1}, load,
                                  rolling_curve_accuracy);
}

using RollingPlace = std::array<double, 3>;  ///< thickness, load, memory

/// The columns of the tables.
std::map<std::string, double> rolling_values(const RollingPlace& place) {
  const auto contact = rolling_contact(place[0], place[1], place[2]);
  return {{"p_max", contact.peak_pressure().value},
          {"creep", contact.creep_ratio().value},
          {"muR", contact.rolling_resistance().value},
          {"L/B", contact.contact_length().value / place[0]},
          {"d0/B", contact.indentation().value / place[0]}};
}

double rolling_value(double thickness, double load, double memory, const std::string& column) {
  static Cache<RollingPlace, std::map<std::string, double>> known;
  const RollingPlace place{thickness, load, memory};
  return known.at(place, [&] { return rolling_values(place); })->at(column);
}

std::string memory_label(double memory) { return fmt::format("F0 tau = {:g} in", memory); }

const FigureAxis memory_axis{"speed times relaxation time F0 tau, in", true};

std::size_t row_of_memory(const data::Table& table, double memory) {
  std::size_t row = 0;
  while (std::fabs(relaxation_length(table, row) / memory - 1) > 1e-6) ++row;
  return row;
}

/// One row of each table.
std::vector<Panel> rolling_against_load(const FigureSubject& subject) {
  const std::vector<Replay> replays = replays_of(subject.tables);
  const std::string& column = subject.text;
  Panel panel{{"load W, lbf/in"}, {axis_label(column)}, {}};
  for (const double memory : {10.0, 1.0, 1e-1, 1e-2, 1e-3, 1e-5}) {
    std::vector<PlacedRow> rows;
    for (const Replay& replay : replays) {
      const std::size_t row = row_of_memory(replay.table, memory);
      rows.push_back({&replay, row, replay.table.parameter("W").value, replay.nips[row].values.at("W")});
    }
    const std::string label = memory_label(memory);
    panel.series.push_back(computed(label, of_continuum, Mark::line, evenly(20, 200, 19),
                                    [&](double load) { return rolling_value(thin, load, memory, column); }));
    panel.series.push_back(replayed_series(label, rows, column));
    panel.series.push_back(printed_series(label, rows, column));
  }
  return {panel};
}

/// A table, its replay and the continuous contact against the memory.
void append_memory_table(Panel& panel, const std::string& label, const Replay& replay,
                         const std::string& column) {
  const double thickness = replay.table.parameter("B").value, load = replay.table.parameter("W").value;
  std::vector<PlacedRow> rows;
  for (std::size_t row = 0; row < replay.nips.size(); ++row) {
    const double memory = relaxation_length(replay.table, row);
    rows.push_back({&replay, row, memory, memory});
  }
  panel.series.push_back(
      computed(label, of_continuum, Mark::line, logarithmically(1e-6, 1e3, 73),
               [&](double memory) { return rolling_value(thickness, load, memory, column); }));
  panel.series.push_back(replayed_series(label, rows, column));
  panel.series.push_back(printed_series(label, rows, column));
}

/// Where the rolling resistance is largest.
Series largest_resistance_at(const std::string& label, double thickness, double load) {
  constexpr int binary_digits = 16;
  const auto negative = [&](double log_memory) {
    return -rolling_value(thickness, load, std::exp(log_memory), "muR");
  };
  const double memory = std::exp(
      boost::math::tools::brent_find_minima(negative, std::log(1e-3), std::log(1.0), binary_digits).first);
  return {label, at_largest, Mark::star, {memory}, {rolling_value(thickness, load, memory, "muR")}};
}

std::vector<Panel> against_memory(const FigureSubject& subject) {
  const std::vector<Replay> replays = replays_of(subject.tables);
  const bool by_thickness = differ_in(replays, "B");
  Panel panel{memory_axis, {axis_label(subject.text)}, {}};
  for (const Replay& replay : replays) {
    const double thickness = replay.table.parameter("B").value, load = replay.table.parameter("W").value;
    const std::string label = by_thickness ? thickness_label(replay) : load_label(load);
    append_memory_table(panel, label, replay, subject.text);
    if (subject.text == "muR") panel.series.push_back(largest_resistance_at(label, thickness, load));
  }
  return {panel};
}

const FigureAxis along_nip{"distance from the line of the centres Y, in (entry > 0)"};
constexpr auto profile_memories = {1.0, 1e-1, 1e-2, 1e-3, 1e-5};

/// Line loads of a row, from its printed length.
struct LineLoadsOfRow {
  data::ViscoelasticNip nip;
  fast::ViscoelasticLineLoadMethod method;
  fast::ViscoelasticLineLoads loads;

  LineLoadsOfRow(const Replay& replay, std::size_t row)
      : nip(viscoelastic_nip_of_the_tables(replay.table, row, false)),
        method(viscoelastic_method(*find_viscoelastic_table(replay.table.id))) {
    method.trailing_elements = replay.nips[row].trailing_elements;
    loads = fast::viscoelastic_line_loads_for_length(nip, method, replay.nips[row].values.at("L1"));
  }

  /// Middles of the elements, or, one more of them, their ends.
  [[nodiscard]] std::vector<double> places(bool ends) const {
    const double inwards = ends ? 0 : loads.element_width() / 2;
    return evenly(inwards - loads.trailing_length, loads.leading_length - inwards,
                  static_cast<int>(loads.loads.size()) + (ends ? 1 : 0));
  }
};

/// One profile at W = 100 lbf/in; displacements reach beyond the ends.
std::vector<Panel> along_rolling_nips(const FigureSubject& subject) {
  const std::string& quantity = subject.text;
  const bool is_pressure = quantity == "pressure", is_normal = quantity == "normal_displacement";
  const Replay replay = std::move(replays_of(subject.tables).front());
  Panel panel{along_nip, {axis_label(quantity)}, {}};
  for (const double memory : profile_memories) {
    const auto contact = rolling_contact(thin, replay.table.parameter("W").value, memory);
    const LineLoadsOfRow thesis(replay, row_of_memory(replay.table, memory));
    const fast::ViscoelasticLineLoadSurface surface(thesis.nip, thesis.loads, thesis.method);
    const std::vector<double> places =
        is_pressure ? evenly(-contact.trailing_length().value, contact.leading_length().value, 201)
                    : evenly(-0.06, 0.06, 201);
    panel.series.push_back(sampled(memory_label(memory), of_continuum, Mark::line, places, [&](double at) {
      if (is_pressure) return contact.pressure(at).value;
      return (is_normal ? contact.normal_displacement(at) : contact.tangential_displacement(at)).value;
    }));
    panel.series.push_back(
        sampled(memory_label(memory), by_thesis, Mark::points, thesis.places(!is_pressure), [&](double at) {
          if (is_pressure) return fast::element_pressure(thesis.loads, at);
          return is_normal ? surface.normal_displacement(at) : surface.tangential_displacement(at);
        }));
  }
  return {panel};
}

}  // namespace

Drawings rolling_drawings() {
  return {{"rolling against load", rolling_against_load},
          {"rolling against memory", against_memory},
          {"along rolling", along_rolling_nips}};
}

}  // namespace nipref::verify
