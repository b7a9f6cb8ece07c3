#include <algorithm>
#include <iterator>
#include <utility>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>

// Numbers of the elastic nip against its load. (thesis 5.7)

namespace nipref::verify {
namespace {

constexpr double load_curve_accuracy = 1e-6;

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

std::vector<Panel> against_load(const FigureSubject& subject) {
  const std::vector<Replay> replays = replays_of(subject.tables);
  const bool by_thickness = differ_in(replays, "B");
  std::vector<Panel> panels;
  for (const std::string& column : subject.words) {
    Panel panel{{"load W, lbf/in"}, {axis_label(column), column == "L/B" || column == "d0/B"}, {}};
    for (const Replay& replay : replays) {
      const bool gripped = line_load_table(replay.table.id).friction == data::Friction::full;
      append_table(panel,
                   by_thickness ? thickness_label(replay)
                   : gripped    ? "no slip"
                                : "complete slip",
                   replay, column);
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

}  // namespace

Drawings elastic_load_drawing() { return {{"elastic against load", against_load}}; }

}  // namespace nipref::verify
