#include <fmt/format.h>

#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <map>

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

const std::vector<std::string> thin_tables{"thesis-XXIII", "thesis-XXIV", "thesis-XXV", "thesis-XXVI"};

/// memory: F0 tau, in.
fast::ConvergedViscoelasticNip rolling_contact(double thickness, double load, double memory) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  const auto solid = data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, memory);
  return fast::converged_for_load({data::seed::roller_radius, thickness, solid, 1}, load,
                                  rolling_curve_accuracy);
}

struct RollingColumn {
  std::string column;  ///< of the tables
  std::string axis;
};

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
std::string load_label(double load) { return fmt::format("W = {:g} lbf/in", load); }

const FigureAxis memory_axis{"speed times relaxation time F0 tau, in", true};
const std::string rolling_solid =
    "theta2 as it is defined, in the thesis's method as it is printed (6.29); complete slip, R = 6 in, E at once "
    "1.40536e5 psi, nu = 1/3";

std::size_t row_of_memory(const data::Table& table, double memory) {
  std::size_t row = 0;
  while (std::fabs(relaxation_length(table, row) / memory - 1) > 1e-6) ++row;
  return row;
}

/// One figure against the load: a row of each table.
std::vector<Panel> rolling_against_load(const RollingColumn& what) {
  const std::vector<Replay> replays = replays_of(thin_tables);
  Panel panel{{"load W, lbf/in"}, {what.axis}, {}};
  for (const double memory : {10.0, 1.0, 1e-1, 1e-2, 1e-3, 1e-5}) {
    std::vector<PlacedRow> rows;
    for (const Replay& replay : replays) {
      const std::size_t row = row_of_memory(replay.table, memory);
      rows.push_back({&replay, row, replay.table.parameter("W").value, replay.nips[row].values.at("W")});
    }
    const std::string label = memory_label(memory);
    panel.series.push_back(computed(label, of_continuum, Mark::line, evenly(20, 200, 19), [&](double load) {
      return rolling_value(thin, load, memory, what.column);
    }));
    panel.series.push_back(replayed_series(label, rows, what.column));
    panel.series.push_back(printed_series(label, rows, what.column));
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

std::vector<Panel> against_memory(const RollingColumn& what) {
  Panel panel{memory_axis, {what.axis}, {}};
  for (const Replay& replay : replays_of(thin_tables))
    append_memory_table(panel, load_label(replay.table.parameter("W").value), replay, what.column);
  return {panel};
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

std::vector<Panel> resistances(const std::vector<std::string>& tables, bool by_load) {
  Panel panel{memory_axis, {"coefficient of rolling resistance mu_R"}, {}};
  for (const Replay& replay : replays_of(tables)) {
    const double thickness = replay.table.parameter("B").value, load = replay.table.parameter("W").value;
    const std::string label = by_load ? load_label(load) : fmt::format("B = {:g} in", thickness);
    append_memory_table(panel, label, replay, "muR");
    panel.series.push_back(largest_resistance_at(label, thickness, load));
  }
  return {panel};
}

const FigureAxis along_nip{"distance from the line of the centres Y, in (entry > 0)"};
constexpr double profile_load = 100;
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

std::vector<Panel> rolling_pressures() {
  const Replay replay = replay_table("thesis-XXIV");
  Panel panel{along_nip, {"pressure p, psi"}, {}};
  for (const double memory : profile_memories) {
    const auto contact = rolling_contact(thin, profile_load, memory);
    const LineLoadsOfRow thesis(replay, row_of_memory(replay.table, memory));
    const std::vector<double> y =
        evenly(-contact.trailing_length().value, contact.leading_length().value, 201);
    panel.series.push_back(sampled(memory_label(memory), of_continuum, Mark::line, y,
                                   [&](double at) { return contact.pressure(at).value; }));
    panel.series.push_back(sampled(memory_label(memory), by_thesis, Mark::points, thesis.places(false),
                                   [&](double at) { return fast::element_pressure(thesis.loads, at); }));
  }
  return {panel};
}

std::vector<Panel> rolling_displacements(bool normal) {
  const Replay replay = replay_table("thesis-XXIV");
  Panel panel{along_nip, {normal ? "normal displacement u, in" : "tangential displacement v, in"}, {}};
  for (const double memory : profile_memories) {
    const auto contact = rolling_contact(thin, profile_load, memory);
    const LineLoadsOfRow thesis(replay, row_of_memory(replay.table, memory));
    const fast::ViscoelasticLineLoadSurface surface(thesis.nip, thesis.loads, thesis.method);
    panel.series.push_back(
        sampled(memory_label(memory), of_continuum, Mark::line, evenly(-0.06, 0.06, 201), [&](double at) {
          return (normal ? contact.normal_displacement(at) : contact.tangential_displacement(at)).value;
        }));
    panel.series.push_back(
        sampled(memory_label(memory), by_thesis, Mark::points, thesis.places(true), [&](double at) {
          return normal ? surface.normal_displacement(at) : surface.tangential_displacement(at);
        }));
  }
  return {panel};
}

}  // namespace

std::vector<FigurePlan> rolling_figures() {
  const RollingColumn columns[] = {{"p_max", "peak pressure p_max, psi"},
                                   {"L/B", "contact length over thickness, L/B"},
                                   {"d0/B", "indentation over thickness, d0/B"},
                                   {"creep", "creep ratio"}};
  const std::string names[] = {"Peak pressure", "Contact length", "Indentation", "Creep"};
  const std::string parameters = rolling_solid + ", B = 0.005 in";
  std::vector<FigurePlan> all;
  for (int i = 0; i < 4; ++i) {
    const RollingColumn what = columns[i];
    all.push_back({fmt::format("thesis-{}", 41 + i), names[i] + " of a viscoelastic nip against load",
                   parameters, [=] { return rolling_against_load(what); }});
  }
  for (int i = 0; i < 4; ++i) {
    const RollingColumn what = columns[i];
    all.push_back({fmt::format("thesis-{}", 45 + i), names[i] + " of a viscoelastic nip against its memory",
                   parameters, [=] { return against_memory(what); }});
  }
  const std::string one_load = parameters + ", W = 100 lbf/in";
  all.push_back({"thesis-49", "Pressure along a viscoelastic nip", one_load, rolling_pressures});
  all.push_back({"thesis-50", "Rolling resistance against memory, with its largest, for four loads",
                 parameters, [] { return resistances(thin_tables, true); }});
  all.push_back({"thesis-51", "Rolling resistance against memory, with its largest, for four thicknesses",
                 rolling_solid + ", W = 100 lbf/in", [] {
                   return resistances({"thesis-XII", "thesis-XVI", "thesis-XX", "thesis-XXIV"}, false);
                 }});
  all.push_back({"thesis-52", "Normal displacement of a viscoelastic sheet's surface in and outside the nip",
                 one_load, [] { return rolling_displacements(true); }});
  all.push_back({"thesis-53",
                 "Tangential displacement of a viscoelastic sheet's surface in and outside the nip", one_load,
                 [] { return rolling_displacements(false); }});
  return all;
}

}  // namespace nipref::verify
