#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <nipref/data/scene/results.hpp>
#include <nipref/fast/elastic_nip/line_loads_displacements.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/figures/internal/nip_at.hpp>

// Pressure, shear and displacements along nips (thesis 5.7, 7.5), and stresses inside the sheet, which the thesis derives
// but does not draw (3.19, 3.20, 4.3, 4.14).

namespace nipref::verify {
namespace {

ResultId result_named(const std::string& word) { return data::find_scene_result(word)->id; }

bool is_displacement(ResultId quantity) {
  return quantity == ResultId::normal_displacement || quantity == ResultId::tangential_displacement;
}

/// A profile by the thesis's line loads for a row, and the places where it is shown: pressures in the middles of the
/// elements, displacements at their ends.
struct ThesisProfile {
  std::vector<double> places;
  Curve curve;
};

ThesisProfile elastic_profile(const Replay& replay, std::size_t row, ResultId quantity) {
  const LineLoadTable& how = line_load_table(replay.table.id);
  const data::ElasticNip nip = nip_of_the_tables(replay.table);
  const fast::LineLoadMethod method(how.elements_per_side);
  const RowValues& values = replay.nips[row].values;
  const auto loads =
      how.friction == data::Friction::full
          ? fast::gripped_line_loads_for_length(nip, method, values.at("L"), values.at("creep"))
          : fast::line_loads_for_length(nip, method, values.at("L"));
  const int ends = is_displacement(quantity) ? 1 : 0;
  const double reach = (loads.contact_length - (1 - ends) * loads.element_width()) / 2;
  return {evenly(-reach, reach, 2 * static_cast<int>(loads.line_loads.size()) + ends), [=](double y) {
            if (quantity == ResultId::pressure) return fast::element_pressure(loads, y);
            if (quantity == ResultId::shear) return fast::element_shear(loads, y);
            return quantity == ResultId::normal_displacement
                       ? fast::normal_displacement(nip, loads, method, y)
                       : fast::tangential_displacement(nip, loads, method, y);
          }};
}

ThesisProfile rolling_profile(const Replay& replay, std::size_t row, ResultId quantity) {
  const data::ViscoelasticNip nip = viscoelastic_nip_of_the_tables(replay.table, row, false);
  auto method = viscoelastic_method(*find_viscoelastic_table(replay.table.id));
  method.trailing_elements = replay.nips[row].trailing_elements;
  const auto loads = fast::viscoelastic_line_loads_for_length(nip, method, replay.nips[row].values.at("L1"));
  const auto surface = std::make_shared<fast::ViscoelasticLineLoadSurface>(nip, loads, method);
  const int ends = quantity == ResultId::pressure ? 0 : 1;
  const double inwards = (1 - ends) * loads.element_width() / 2;
  return {evenly(inwards - loads.trailing_length, loads.leading_length - inwards,
                 static_cast<int>(loads.loads.size()) + ends),
          [=](double y) {
            if (quantity == ResultId::pressure) return fast::element_pressure(loads, y);
            return quantity == ResultId::normal_displacement ? surface->normal_displacement(y)
                                                             : surface->tangential_displacement(y);
          }};
}

using Contact = SolvedContact<fast::Estimate>;

void append(Panel& panel, const std::string& label, const std::vector<double>& places, const Contact& contact,
            ResultId quantity, const ThesisProfile& thesis) {
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
      const NipAt nip = nip_of_table(replay.table, load);
      const SolvedInDouble contact = contact_of(nip, accuracy);
      const double half = contact->number(ResultId::contact_length).value / 2;
      std::vector<double> places = subject.numbers("places");
      for (double& place : places) place = half * std::sin(std::numbers::pi / 2 * place);
      if (is_displacement(quantity)) places = evenly(-2 * half, 2 * half, static_cast<int>(places.size()));
      append(panel, loads.size() > 1 ? load_label(load) : friction_label(nip.friction), places, *contact,
             quantity, elastic_profile(replay, row, quantity));
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
    NipAt nip = nip_of_table(replay.table, replay.table.parameter("W").value);
    nip.memory = memory;
    const SolvedInDouble contact = contact_of(nip, accuracy);
    const ContactEnds ends = contact->ends();
    append(panel, memory_label(memory),
           quantity == ResultId::pressure ? evenly(ends.first, ends.last, 201) : subject.numbers("places"),
           *contact, quantity, rolling_profile(replay, row_of_memory(replay.table, memory), quantity));
  }
  return {panel};
}

struct StressPart {
  const char* name;
  ResultId id;
  double step;  ///< between neighbouring contours
};

constexpr StressPart stress_parts[] = {{"sigma_x", ResultId::stress_across, 0.1},
                                       {"sigma_y", ResultId::stress_along, 0.1},
                                       {"tau_xy", ResultId::stress_shear, 0.05},
                                       {"maximum shear", ResultId::maximum_shear, 0.05}};

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
    Contours contours{std::string(part.name) + " over the largest pressure", along, depths, {}, part.step};
    for (const fast::Estimate& here : contact.get(part.id, places))
      contours.values.push_back(here.value / peak);
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

Drawings profile_drawings() {
  return {{"along elastic", along_elastic_nips},
          {"along rolling", along_rolling_nips},
          {"stresses", inner_stresses}};
}

}  // namespace nipref::verify
