#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <map>
#include <utility>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/figures/internal/nip_at.hpp>
#include <nipref/verify/support/internal/cache.hpp>

// Numbers of nips against their loads and memories, and the creep ratios that the thesis's conditions allow (thesis 5.5,
// 5.7, 7.5).

namespace nipref::verify {
namespace {

constexpr double curve_accuracy = 1e-6;

/// The values of the tables' columns.
std::map<std::string, double> values_of(const NipAt& nip) {
  const SolvedInDouble contact = contact_of(nip, curve_accuracy);
  const auto value = [&](ResultId id) { return contact->number(id).value; };
  const double length = value(ResultId::contact_length), d0 = value(ResultId::indentation);
  return {{"p_max", value(ResultId::peak_pressure)},
          {"creep", value(ResultId::creep_ratio)},
          {"muR", value(ResultId::rolling_resistance)},
          {"L", length},
          {"L/B", length / nip.thickness},
          {"d0", d0},
          {"d0/B", d0 / nip.thickness}};
}

double value_at(const NipAt& nip, const std::string& column) {
  static Cache<std::array<double, 4>, std::map<std::string, double>> known;
  const std::array key{nip.thickness, nip.load, nip.memory, nip.friction == data::Friction::full ? 1.0 : 0.0};
  return known.at(key, [&] { return values_of(nip); })->at(column);
}

/// A curve of continuous contacts, in which one number of the nip varies, and the rows of tables that lie on it.
struct NipCurve {
  std::string label;
  NipAt nip;
  std::vector<PlacedCell> cells = {};

  void add(const Replay& replay, std::size_t row, const std::string& column, double printed_at,
           double replayed_at) {
    cells.push_back({&replay, row, column, printed_at, replayed_at});
  }
};

void append(Panel& panel, const NipCurve& curve, double NipAt::*varied, const std::vector<double>& places,
            const std::string& column) {
  panel.series.push_back(computed(curve.label, of_continuum, Mark::line, places, [&](double at) {
    NipAt nip = curve.nip;
    nip.*varied = at;
    return value_at(nip, column);
  }));
  panel.series.push_back(replayed_series(curve.label, by_thesis, curve.cells));
  panel.series.push_back(printed_series(curve.label, curve.cells));
}

double load_of(const Replay& replay, std::size_t row) { return replay.nips[row].values.at("W"); }

bool differ_in_thickness(const std::vector<Replay>& replays) {
  return replays.front().table.parameter("B").value != replays.back().table.parameter("B").value;
}

/// A panel for each column, with a curve for each table.
std::vector<Panel> elastic_against_load(const FigureSubject& subject) {
  const std::vector<Replay> replays = subject.replays();
  std::vector<Panel> panels;
  for (const std::string& column : subject.words) {
    Panel panel{{"load W, lbf/in"}, {axis_label(column), column == "L/B" || column == "d0/B"}, {}};
    for (const Replay& replay : replays) {
      NipCurve curve{"", nip_of_table(replay.table, 0)};
      curve.label = differ_in_thickness(replays) ? thickness_label(curve.nip.thickness)
                                                 : friction_label(curve.nip.friction);
      for (std::size_t row = 0; row < replay.nips.size(); ++row)
        curve.add(replay, row, column, key_of_row(replay.table, row), load_of(replay, row));
      append(panel, curve, &NipAt::load, subject.numbers("load"), column);
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

/// A curve for each memory, with a row of each table.
std::vector<Panel> rolling_against_load(const FigureSubject& subject) {
  const std::vector<Replay> replays = subject.replays();
  const std::string& column = subject.text;
  Panel panel{{"load W, lbf/in"}, {axis_label(column)}, {}};
  for (const double memory : subject.numbers("memory")) {
    NipCurve curve{memory_label(memory), nip_of_table(replays.front().table, 0)};
    curve.nip.memory = memory;
    for (const Replay& replay : replays) {
      const std::size_t row = row_of_memory(replay.table, memory);
      curve.add(replay, row, column, replay.table.parameter("W").value, load_of(replay, row));
    }
    append(panel, curve, &NipAt::load, subject.numbers("load"), column);
  }
  return {panel};
}

/// The memory at which the rolling resistance is largest.
Series largest_resistance(const NipCurve& curve) {
  constexpr int binary_digits = 16;
  const auto resistance = [&](double log_memory) {
    NipAt nip = curve.nip;
    nip.memory = std::exp(log_memory);
    return value_at(nip, "muR");
  };
  const double at = boost::math::tools::brent_find_minima([&](double log) { return -resistance(log); },
                                                          std::log(1e-3), std::log(1.0), binary_digits)
                        .first;
  return {curve.label, at_largest, Mark::star, {std::exp(at)}, {resistance(at)}};
}

/// A curve for each table.
std::vector<Panel> rolling_against_memory(const FigureSubject& subject) {
  const std::vector<Replay> replays = subject.replays();
  const std::string& column = subject.text;
  Panel panel{{"speed times relaxation time F0 tau, in", true}, {axis_label(column)}, {}};
  for (const Replay& replay : replays) {
    NipCurve curve{"", nip_of_table(replay.table, replay.table.parameter("W").value)};
    curve.label =
        differ_in_thickness(replays) ? thickness_label(curve.nip.thickness) : load_label(curve.nip.load);
    for (std::size_t row = 0; row < replay.nips.size(); ++row) {
      const double memory = relaxation_length(replay.table, row);
      curve.add(replay, row, column, memory, memory);
    }
    append(panel, curve, &NipAt::memory, subject.numbers("memory"), column);
    if (column == "muR") panel.series.push_back(largest_resistance(curve));
  }
  return {panel};
}

const std::string creep_sheet = "B = 0.005 in";
constexpr double sheet_thickness = 0.005, creep_accuracy = 1e-6;

/// The contact length of m beta: m elements on each side, beta is half an element's width over half the thickness.
double length_of(double m_beta) { return 2 * m_beta * sheet_thickness; }

/// A bar about the middle of each range.
Series allowed_ranges(const data::ElasticNip& nip, int elements, const std::vector<double>& m_beta) {
  Series series{creep_sheet, "range that the conditions leave", Mark::ranges, {}, {}};
  for (const double place : m_beta) {
    for (const fast::CreepRange& range : fast::creep_ranges(nip, elements, length_of(place))) {
      series.x.push_back(place);
      series.y.push_back((range.lower + range.upper) / 2);
      series.low.push_back(range.lower);
      series.high.push_back(range.upper);
    }
  }
  return series;
}

std::vector<Panel> creep_range_panels(const FigureSubject& subject) {
  const Replay replay = std::move(subject.replays().front());
  const data::ElasticNip nip = nip_of_the_tables(replay.table);
  const std::vector<double> m_beta = subject.numbers("m_beta");
  std::vector<PlacedCell> cells;
  for (std::size_t row = 0; row < replay.nips.size(); ++row) {
    const double place = replay.nips[row].values.at("L/B") / 2;
    cells.push_back({&replay, row, subject.text, place, place});
  }
  return {{{"m beta = L/(2B)"},
           {"creep ratio"},
           {computed(creep_sheet, of_continuum, Mark::line, m_beta,
                     [&](double place) {
                       return fast::converged_for_length(nip, data::Friction::full, length_of(place),
                                                         creep_accuracy)
                           .creep_ratio()
                           .value;
                     }),
            allowed_ranges(nip, line_load_table(replay.table.id).elements_per_side, m_beta),
            printed_series(creep_sheet, cells)}}};
}

}  // namespace

Drawings nip_drawings() {
  return {{"creep ranges", creep_range_panels},
          {"elastic against load", elastic_against_load},
          {"rolling against load", rolling_against_load},
          {"rolling against memory", rolling_against_memory}};
}

}  // namespace nipref::verify
