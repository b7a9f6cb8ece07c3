#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>

// Numbers of the elastic nip against its load. (thesis 5.7)

namespace nipref::verify {
namespace {

constexpr double load_curve_accuracy = 1e-6;

struct ElasticColumn {
  std::string column;  ///< of the tables
  std::string axis;
};

const ElasticColumn pressure_column{"p_max", "peak pressure p_max, psi"},
    length_column{"L/B", "contact length over thickness, L/B"},
    depth_column{"d0/B", "indentation over thickness, d0/B"}, creep_column{"creep", "creep ratio"};

/// Up to 200 lbf/in, the tables' loads among them.
std::vector<double> loads() {
  std::vector<double> all = evenly(0.5, 4.5, 9);
  std::ranges::copy(evenly(5, 200, 40), std::back_inserter(all));
  return all;
}

double continuous_value(const data::ElasticNip& nip, data::Friction friction, double load,
                        const std::string& column) {
  const auto contact = fast::converged_for_load(nip, friction, load, load_curve_accuracy);
  if (column == "p_max") return contact.peak_pressure().value;
  if (column == "creep") return contact.creep_ratio().value;
  if (column == "L") return contact.contact_length().value;
  if (column == "L/B") return contact.contact_length().value / nip.sheet_thickness;
  const double d0 = contact.indentation().value;
  return column == "d0" ? d0 : d0 / nip.sheet_thickness;
}

std::vector<PlacedRow> by_load(const Replay& replay) {
  std::vector<PlacedRow> rows;
  for (std::size_t row = 0; row < replay.nips.size(); ++row)
    rows.push_back({&replay, row, key_of_row(replay.table, row), replay.nips[row].values.at("W")});
  return rows;
}

/// The continuous contact, the table and its replay.
void append_table(Panel& panel, const std::string& label, const Replay& replay, const std::string& column) {
  const data::ElasticNip nip = nip_of_the_tables(replay.table);
  const data::Friction friction = line_load_table(replay.table.id).friction;
  panel.series.push_back(computed(label, of_continuum, Mark::line, loads(), [&](double load) {
    return continuous_value(nip, friction, load, column);
  }));
  panel.series.push_back(replayed_series(label, by_load(replay), column));
  panel.series.push_back(printed_series(label, by_load(replay), column));
}

const std::string load_axis = "load W, lbf/in";

FigurePlan against_load(int number, const std::string& title, const std::vector<std::string>& tables,
                        const ElasticColumn& what, const std::string& parameters) {
  return {fmt::format("thesis-{}", number), title, parameters, [=] {
            Panel panel{{load_axis}, {what.axis, what.column == "L/B" || what.column == "d0/B"}, {}};
            for (const Replay& replay : replays_of(tables))
              append_table(panel, fmt::format("B = {:g} in", replay.table.parameter("B").value), replay,
                           what.column);
            return std::vector<Panel>{panel};
          }};
}

std::vector<Panel> friction_limits() {
  const std::vector<Replay> replays = replays_of({"thesis-VI", "thesis-X"});
  std::vector<Panel> panels{{{load_axis}, {"contact length L, in"}, {}},
                            {{load_axis}, {"indentation d0, in"}, {}}};
  for (const Replay& replay : replays) {
    const std::string label =
        line_load_table(replay.table.id).friction == data::Friction::full ? "no slip" : "complete slip";
    append_table(panels[0], label, replay, "L");
    append_table(panels[1], label, replay, "d0");
  }
  return panels;
}

}  // namespace

std::vector<FigurePlan> elastic_load_figures() {
  struct Case {
    int first;
    std::string words;
    std::vector<std::string> tables;
  };
  std::vector<FigurePlan> all;
  for (const Case& one :
       {Case{17, "without slip", {"thesis-III", "thesis-IV", "thesis-V", "thesis-VI"}},
        Case{21, "with complete slip", {"thesis-VII", "thesis-VIII", "thesis-IX", "thesis-X"}}}) {
    const std::string parameters =
        fmt::format("elastic, {}, R = 6 in, E = 1.40536e5 psi, nu = 1/3", one.words);
    const auto add = [&](int number, const std::string& what, const ElasticColumn& column) {
      all.push_back(against_load(number, what + " against load, four thicknesses, " + one.words, one.tables,
                                 column, parameters));
    };
    add(one.first, "Peak pressure", pressure_column);
    add(one.first + 1, "Contact length", length_column);
    add(one.first + 2, "Indentation", depth_column);
    add(one.first + 3, "Creep", creep_column);
  }
  all.push_back({"thesis-25", "Contact length and indentation against load: no slip and complete slip",
                 "elastic, B = 0.005 in, R = 6 in, E = 1.40536e5 psi, nu = 1/3", friction_limits});
  return all;
}

}  // namespace nipref::verify
