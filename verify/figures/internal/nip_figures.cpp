#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/support/internal/cache.hpp>
#include <nipref/verify/support/mapped.hpp>

// Numbers of nips against their loads and memories, and the creep ratios that the thesis's conditions allow (thesis, section 5.5,
// 5.7, 7.5); pressure, shear and displacements along nips (thesis 5.7, 7.5), and stresses inside the sheet, which the
// thesis derives but does not draw (3.19, 3.20, 3.26, 3.27, 4.3, 4.14).

namespace nipref::verify {
namespace {

/// A nip of the thesis's tables: of the sheet's material, or of the standard linear solid whose instantaneous response is that
/// material.
struct NipAt {
  double thickness, load;
  double memory = 0;  ///< speed times relaxation time, in; 0: elastic
  data::Friction friction = data::Friction::none;
};

NipAt nip_of_row(const data::Table& table, std::size_t row) {
  const double thickness = table.parameter("B").value, key = key_of_row(table, row);
  if (find_viscoelastic_table(table.id) != nullptr) return {thickness, table.parameter("W").value, key};
  return {thickness, key, 0, line_load_table(table.id).friction};
}

std::size_t row_of_memory(const data::Table& table, double memory) {
  std::size_t row = 0;
  while (std::fabs(relaxation_length(table, row) / memory - 1) > 1e-6) ++row;
  return row;
}

/// The continuous contact.
SolvedInDouble contact_of(const NipAt& nip, double accuracy) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  if (nip.memory == 0)
    return solve_nip(data::ElasticNipProblem{.nip = {data::seed::roller_radius, nip.thickness, at_once},
                                             .given = data::GivenLoad{nip.load},
                                             .friction = nip.friction},
                     accuracy);
  const auto solid = data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, nip.memory);
  return solve_nip(data::ViscoelasticNipProblem{.nip = {data::seed::roller_radius, nip.thickness, solid, 1},
                                                .given = data::GivenLoad{nip.load}},
                   accuracy);
}

std::string load_label(double load) { return fmt::format("W = {:g} lbf/in", load); }
std::string memory_label(double memory) { return fmt::format("F0 tau = {:g} in", memory); }
std::string friction_label(data::Friction friction) {
  return friction == data::Friction::full ? "no slip" : "complete slip";
}

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

/// The memory at which the rolling resistance is largest.
Series largest_resistance(const std::string& label, NipAt nip) {
  constexpr int binary_digits = 16;
  const auto resistance = [&](double log_memory) {
    nip.memory = std::exp(log_memory);
    return value_at(nip, "muR");
  };
  const double at = boost::math::tools::brent_find_minima([&](double log) { return -resistance(log); },
                                                          std::log(1e-3), std::log(1.0), binary_digits)
                        .first;
  return {label, at_largest, Mark::star, {std::exp(at)}, {resistance(at)}};
}

/// The rows of the tables on a curve, on which the load varies, otherwise the memory.
std::vector<PlacedCell> cells_on(const NipAt& curve, const std::vector<Replay>& replays, bool by_load,
                                 const std::string& column) {
  std::vector<PlacedCell> cells;
  for (const Replay& replay : replays) {
    for (std::size_t row = 0; row < replay.nips.size(); ++row) {
      const NipAt nip = nip_of_row(replay.table, row);
      const bool other_memory = curve.memory > 0 && std::fabs(nip.memory / curve.memory - 1) > 1e-6;
      if (nip.thickness != curve.thickness || nip.friction != curve.friction ||
          (by_load ? other_memory : nip.load != curve.load))
        continue;
      cells.push_back({&replay, row, column, by_load ? nip.load : nip.memory,
                       by_load ? replay.nips[row].values.at("W") : nip.memory});
    }
  }
  return cells;
}

/// A panel for each column, with curves of continuous contacts on which one number varies, and the rows of tables on them: a
/// curve for each table or, of rolling sheets against the load, for each memory. They are called by what differs.
std::vector<Panel> nip_panels(const FigureSubject& subject, double NipAt::*varied) {
  const std::vector<Replay> replays = subject.replays();
  const bool by_load = varied == &NipAt::load, rolls = nip_of_row(replays.front().table, 0).memory > 0;
  std::vector<NipAt> curves = mapped(replays, [](const Replay& one) { return nip_of_row(one.table, 0); });
  if (by_load && rolls) {
    curves.assign(subject.numbers("memory").size(), curves.front());
    for (std::size_t i = 0; i < curves.size(); ++i) curves[i].memory = subject.numbers("memory")[i];
  }
  for (NipAt& curve : curves) curve.*varied = 0;
  const auto differ = [&](auto number) { return curves.front().*number != curves.back().*number; };
  const auto label_of = [&](const NipAt& nip) {
    if (differ(&NipAt::thickness)) return fmt::format("B = {:g} in", nip.thickness);
    if (differ(&NipAt::load)) return load_label(nip.load);
    return differ(&NipAt::memory) ? memory_label(nip.memory) : friction_label(nip.friction);
  };
  return mapped(subject.words, [&](const std::string& column) {
    const bool has_decades = !rolls && (column == "L/B" || column == "d0/B");
    Panel panel{
        by_load ? FigureAxis{"load W, lbf/in"} : FigureAxis{"speed times relaxation time F0 tau, in", true},
        {axis_label(column), has_decades},
        {}};
    for (const NipAt& curve : curves) {
      const std::string label = label_of(curve);
      const auto cells = cells_on(curve, replays, by_load, column);
      panel.series.push_back(computed(label, of_continuum, Mark::line,
                                      subject.numbers(by_load ? "load" : "memory"), [&](double at) {
                                        NipAt nip = curve;
                                        nip.*varied = at;
                                        return value_at(nip, column);
                                      }));
      panel.series.push_back(replayed_series(label, by_thesis, cells));
      panel.series.push_back(printed_series(label, cells));
      if (column == "muR") panel.series.push_back(largest_resistance(label, curve));
    }
    return panel;
  });
}

std::vector<Panel> against_load(const FigureSubject& subject) { return nip_panels(subject, &NipAt::load); }
std::vector<Panel> against_memory(const FigureSubject& subject) {
  return nip_panels(subject, &NipAt::memory);
}

const std::string creep_sheet = "B = 0.005 in";
constexpr double sheet_thickness = 0.005, creep_accuracy = 1e-6;

/// The contact length of m beta: m elements on each side, beta is half an element's width over half the thickness.
double length_of(double m_beta) { return 2 * m_beta * sheet_thickness; }

/// A bar about the middle of each range.
Series allowed_ranges(const data::ElasticNip& nip, int elements, const std::vector<double>& m_beta) {
  Series series{creep_sheet, "range that the conditions leave", Mark::ranges, {}, {}};
  for (const double place : m_beta) {
    // The ranges do not depend on the creep.
    const auto loads =
        fast::line_loads_for_length(nip, elements, length_of(place), {data::Grip::Creep::given, 0});
    for (const fast::CreepRange& range : loads.creep_ranges) {
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

ResultId result_named(const std::string& word) { return data::find_scene_result(word)->id; }

bool is_displacement(ResultId quantity) {
  return quantity == ResultId::normal_displacement || quantity == ResultId::tangential_displacement;
}

/// A profile by the thesis's line loads for a row, and the places where it is shown: tractions in the middles of the
/// elements, displacements at their ends.
struct ThesisProfile {
  std::vector<double> places;
  Curve curve;
};

ThesisProfile thesis_profile(fast::LineLoadNip loads, ResultId quantity) {
  const int ends = is_displacement(quantity) ? 1 : 0;
  const double inwards = (1 - ends) * loads.element_width() / 2;
  auto places = evenly(inwards - loads.trailing_length(), loads.leading_length - inwards,
                       static_cast<int>(loads.loads.size()) + ends);
  return {std::move(places), [=, loads = std::move(loads)](double y) {
            if (quantity == ResultId::pressure) return loads.pressure(y);
            if (quantity == ResultId::shear) return loads.shear(y);
            return quantity == ResultId::normal_displacement ? loads.normal_displacement(y)
                                                             : loads.tangential_displacement(y);
          }};
}

ThesisProfile elastic_profile(const Replay& replay, std::size_t row, ResultId quantity) {
  const LineLoadTable& how = line_load_table(replay.table.id);
  const RowValues& values = replay.nips[row].values;
  const data::Grip grip = how.friction == data::Friction::full
                              ? data::Grip{data::Grip::Creep::given, values.at("creep")}
                              : data::Grip{};
  return thesis_profile(fast::line_loads_for_length(nip_of_the_tables(replay.table), how.elements_per_side,
                                                    values.at("L"), grip),
                        quantity);
}

ThesisProfile rolling_profile(const Replay& replay, std::size_t row, ResultId quantity) {
  auto method = viscoelastic_method(*find_viscoelastic_table(replay.table.id));
  method.trailing_elements = replay.nips[row].trailing_elements;
  return thesis_profile(fast::line_loads_for_length(viscoelastic_nip_of_the_tables(replay.table, row, false),
                                                    method, replay.nips[row].values.at("L1")),
                        quantity);
}

using Contact = SolvedContact<fast::Estimate>;

void append_profile(Panel& panel, const std::string& label, const std::vector<double>& places,
                    const Contact& contact, ResultId quantity, const ThesisProfile& thesis) {
  panel.series.push_back(sampled(label, of_continuum, Mark::line, places,
                                 [&](double y) { return contact.at(quantity, y).value; }));
  if (quantity == ResultId::shear) {
    const Series& curve = panel.series.back();
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(curve.y) - curve.y.begin());
    const double largest = contact.number(ResultId::peak_shear).value;
    panel.series.push_back({label, at_largest, Mark::star, {curve.x[peak]}, {largest}});
  }
  panel.series.push_back(sampled(label, by_thesis, Mark::points, thesis.places, thesis.curve));
}

/// Appends the profile for each table and load: places are denser towards the ends of the contact; displacements are shown
/// over twice the contact length.
void append_elastic(Panel& panel, const FigureSubject& subject, ResultId quantity) {
  constexpr double accuracy = 1e-8;
  const std::vector<double> loads = subject.numbers("load");
  for (const Replay& replay : subject.replays()) {
    for (const double load : loads) {
      std::size_t row = 0;
      while (key_of_row(replay.table, row) != load) ++row;
      const NipAt nip = nip_of_row(replay.table, row);
      const SolvedInDouble contact = contact_of(nip, accuracy);
      const double half = contact->number(ResultId::contact_length).value / 2;
      std::vector<double> places = subject.numbers("places");
      for (double& place : places) place = half * std::sin(std::numbers::pi / 2 * place);
      if (is_displacement(quantity)) places = evenly(-2 * half, 2 * half, static_cast<int>(places.size()));
      append_profile(panel, loads.size() > 1 ? load_label(load) : friction_label(nip.friction), places,
                     *contact, quantity, elastic_profile(replay, row, quantity));
    }
  }
}

std::vector<Panel> along_elastic_nips(const FigureSubject& subject) {
  std::vector<Panel> panels;
  for (const std::string& word : subject.words) {
    panels.push_back({{"distance from the middle of the nip Y, in"}, {axis_label(word)}, {}});
    append_elastic(panels.back(), subject, result_named(word));
  }
  return panels;
}

/// A profile for each memory: pressures along the contact, displacements at the given places.
std::vector<Panel> along_rolling_nips(const FigureSubject& subject) {
  constexpr double accuracy = 1e-6;
  const ResultId quantity = result_named(subject.text);
  const Replay replay = std::move(subject.replays().front());
  Panel panel{{"distance from the line of the centres Y, in (entry > 0)"}, {axis_label(subject.text)}, {}};
  for (const double memory : subject.numbers("memory")) {
    NipAt nip = nip_of_row(replay.table, 0);
    nip.memory = memory;
    const SolvedInDouble contact = contact_of(nip, accuracy);
    const ContactEnds ends = contact->ends();
    append_profile(
        panel, memory_label(memory),
        quantity == ResultId::pressure ? evenly(ends.first, ends.last, 201) : subject.numbers("places"),
        *contact, quantity, rolling_profile(replay, row_of_memory(replay.table, memory), quantity));
  }
  return {panel};
}

struct StressPart {
  const char* name;
  ResultId id;
};

constexpr StressPart stress_parts[] = {{"sigma_x", ResultId::stress_across},
                                       {"sigma_y", ResultId::stress_along},
                                       {"tau_xy", ResultId::stress_shear},
                                       {"maximum shear", ResultId::maximum_shear}};

/// Between neighbouring contours: 1, 2 or 5 times a power of ten, at most ten of them from 0 to the largest value.
double contour_step(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  const double power = std::pow(10, std::floor(std::log10(largest / 10)));
  for (const double step : {power, 2 * power, 5 * power}) {
    if (10 * step >= largest) return step;
  }
  return 10 * power;
}

/// Stresses are divided by the largest pressure, places along the sheet by half the contact length.
std::vector<Panel> stress_panels(const Contact& contact, double thickness) {
  const auto value = [&](ResultId id) { return contact.number(id).value; };
  const double half = value(ResultId::contact_length) / 2, peak = value(ResultId::peak_pressure);
  const double reach = std::max(1.6, thickness / 2 / half);
  const std::vector<double> along = evenly(-reach, reach, 161), depths = evenly(-1, 1, 61);
  Places places;
  for (const double depth : depths) {
    for (const double place : along) places.push_back({place * half, depth});
  }
  std::vector<Panel> panels;
  for (const StressPart& part : stress_parts) {
    Contours contours{std::string(part.name) + " over the largest pressure", along, depths, {}, 0};
    for (const fast::Estimate& here : contact.get(part.id, places))
      contours.values.push_back(here.value / peak);
    contours.step = contour_step(contours.values);
    panels.push_back({{"distance from the middle over half the contact length"},
                      {"x/b, from face to face"},
                      {},
                      false,
                      std::move(contours)});
  }
  panels.back().series.push_back({"maximum shear",
                                  at_largest,
                                  Mark::star,
                                  {value(ResultId::greatest_shear_position) / half},
                                  {value(ResultId::greatest_shear_depth)}});
  return panels;
}

std::vector<Panel> inner_stresses(const FigureSubject& subject) {
  constexpr double accuracy = 1e-6;
  const NipAt nip{subject.number("thickness"), subject.number("load"), subject.number("memory"),
                  subject.number("memory") == 0 ? data::Friction::full : data::Friction::none};
  return stress_panels(*contact_of(nip, accuracy), nip.thickness);
}

}  // namespace

Drawings nip_drawings() {
  return {{"creep ranges", creep_range_panels},  {"against load", against_load},
          {"against memory", against_memory},    {"along elastic", along_elastic_nips},
          {"along rolling", along_rolling_nips}, {"stresses", inner_stresses}};
}

}  // namespace nipref::verify
