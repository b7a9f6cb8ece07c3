#include <utility>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>

// Creep ratios that the thesis's conditions leave. (thesis 5.5)

namespace nipref::verify {
namespace {

const std::string creep_sheet = "B = 0.005 in";
constexpr double sheet_thickness = 0.005, creep_accuracy = 1e-6;

/// m beta: elements a side times half an element over half the thickness.
double length_of(double m_beta) { return 2 * m_beta * sheet_thickness; }

/// Each range as a bar about its middle.
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

Drawings creep_range_drawing() { return {{"creep ranges", creep_range_panels}}; }

}  // namespace nipref::verify
