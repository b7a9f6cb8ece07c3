#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/partial_slip/partial_slip.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>

// Curves with a point for each load, range or zone of a contact, and contours: no formula of a figure describes them.

namespace nipref::verify {
namespace {

/// The row whose first cell is this number.
std::size_t row_with(const data::Table& table, double key) {
  std::size_t row = 0;
  while (std::fabs(key_of_row(table, row) / key - 1) > 1e-6) ++row;
  return row;
}

/// The thesis's line loads for a row of a table.
fast::LineLoadNip line_loads_of(const Replay& replay, FigureFormulas& formulas) {
  const data::Table& table = replay.table;
  if (const ViscoelasticTable* const how = find_viscoelastic_table(table.id)) {
    const std::size_t row = row_with(table, formulas.value("memory"));
    auto method = viscoelastic_method(*how);
    method.trailing_elements = replay.nips[row].trailing_elements;
    return fast::line_loads_for_length(viscoelastic_nip_of_the_tables(table, row, false), method,
                                       replay.nips[row].values.at("L1"));
  }
  const RowValues& values = replay.nips[row_with(table, formulas.value("load"))].values;
  const auto friction = formulas.value("full_friction") != 0
                            ? data::LineLoadFriction::full(values.at("creep"))
                            : data::LineLoadFriction{};
  return fast::line_loads_for_length(nip_of_the_tables(table), line_load_table(table.id).elements_per_side,
                                     values.at("L"), friction);
}

/// Adds a bar with its middle.
void add_bar(Series& bars, double x, double low, double high) {
  bars.x.push_back(x);
  bars.y.push_back((low + high) / 2);
  bars.low.push_back(low);
  bars.high.push_back(high);
}

/// The difference between contours: 1, 2 or 5 times a power of ten; at most ten steps from 0 to the largest value.
double contour_step(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  const double power = std::pow(10, std::floor(std::log10(largest / 10)));
  for (const double step : {power, 2 * power, 5 * power})
    if (10 * step >= largest) return step;
  return 10 * power;
}

}  // namespace

/// Tractions at the middles of the elements, displacements at the ends of the elements.
std::vector<Series> by_line_loads(FigureFormulas& formulas, const Series& start) {
  const fast::LineLoadNip loads = line_loads_of(formulas.tables().front(), formulas);
  const ResultId shown = data::find_scene_result(formulas.scope.shown->text("id"))->id;
  const bool is_traction = shown == ResultId::pressure || shown == ResultId::shear;
  const double inwards = is_traction ? loads.element_width() / 2 : 0;
  const double first = inwards - loads.trailing_length(), last = loads.leading_length - inwards;
  const std::size_t steps = loads.loads.size() - (is_traction ? 1 : 0);
  Series series = start;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double y = std::lerp(first, last, static_cast<double>(i) / static_cast<double>(steps));
    series.x.push_back(y);
    series.y.push_back(shown == ResultId::pressure              ? loads.pressure(y)
                       : shown == ResultId::shear               ? loads.shear(y)
                       : shown == ResultId::normal_displacement ? loads.normal_displacement(y)
                                                                : loads.tangential_displacement(y));
  }
  return {series};
}

std::vector<Series> creep_ranges(FigureFormulas& formulas, const Series& start) {
  const data::Table& table = formulas.tables().front().table;
  Series series = start;
  for (const double m_beta : formulas.scope.row->numbers("m_beta")) {
    formulas.define("m_beta", m_beta);
    // The ranges do not depend on the creep.
    const auto loads =
        fast::line_loads_for_length(nip_of_the_tables(table), line_load_table(table.id).elements_per_side,
                                    formulas.value("length(m_beta)"), data::LineLoadFriction::full(0));
    for (const fast::CreepRange& range : loads.creep_ranges)
      add_bar(series, m_beta, range.lower, range.upper);
  }
  return {series};
}

/// Positions are fractions of the contact: 0 at the trailing end, 1 at the leading end.
std::vector<Series> slip_zones(FigureFormulas& formulas, const Series& start) {
  Series towards_entry = start, towards_exit = start;
  towards_entry.label += " towards the entry";
  towards_exit.label += " towards the exit";
  const data::ElasticNip nip = data::seed::nip(formulas.value("B"));
  const double load = formulas.value("load");
  for (const double mu : formulas.scope.row->numbers("mu")) {
    const auto contact =
        fast::partial_slip_for_load({nip, mu, data::GivenTraction{formulas.value("traction") * mu * load}},
                                    load, formulas.value("accuracy"));
    const std::vector<fast::Estimate> boundaries = contact.zone_boundaries();
    const double exit = boundaries.back().value, entry = boundaries.front().value;
    const auto place = [&](std::size_t i) { return (boundaries[i].value - exit) / (entry - exit); };
    const std::vector<int> signs = contact.zone_signs();
    for (std::size_t i = 0; i < signs.size(); ++i)
      if (signs[i] != 0) add_bar(signs[i] > 0 ? towards_entry : towards_exit, mu, place(i + 1), place(i));
  }
  return {towards_entry, towards_exit};
}

Contours stress_contours(FigureFormulas& formulas) {
  const FigureScope& scope = formulas.scope;
  const double half = formulas.value("half"), reach = formulas.value("reach");
  Contours contours{scope.shown->text("axis"),
                    mapped(scope.row->numbers("along"), [&](double share) { return share * reach; }),
                    scope.row->numbers("depths"),
                    {},
                    0};
  Places places;
  for (const double depth : contours.y)
    for (const double along : contours.x) places.push_back({along * half, depth});
  const SolvedContact<fast::Estimate>& contact = formulas.nip();
  const double peak = contact.number(ResultId::peak_pressure).value;
  const ResultId stress = data::find_scene_result(scope.shown->text("id"))->id;
  for (const fast::Estimate& here : contact.get(stress, places)) contours.values.push_back(here.value / peak);
  contours.step = contour_step(contours.values);
  return contours;
}

}  // namespace nipref::verify
