#include <algorithm>

#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {
namespace {

RowValues solved_row(const data::ElasticNip& nip, const fast::LineLoadMethod& method, double length,
                     std::optional<double> creep) {
  const fast::LineLoadSolution solution =
      creep ? fast::gripped_line_loads_for_length(nip, method, length, *creep)
            : fast::line_loads_for_length(nip, method, length);
  return row_values(nip, solution, fast::creep_ratio(nip, solution, method));
}

}  // namespace

RowValues row_values(const data::ElasticNip& nip, const fast::LineLoadSolution& solution, double creep) {
  const double thickness = nip.sheet_thickness;
  return {{"W", solution.load},
          {"L", solution.contact_length},
          {"d0", solution.indentation},
          {"d1", solution.edge_displacement},
          {"creep", creep},
          {"p_max", solution.peak_pressure},
          {"q_max", solution.peak_shear},
          {"L/B", solution.contact_length / thickness},
          {"d0/B", solution.indentation / thickness},
          {"d1/B", solution.edge_displacement / thickness},
          {"d1/d0", solution.edge_displacement / solution.indentation}};
}

data::Interval ReplayedRow::range(const std::string& column) const {
  data::Interval all{at_centre.at(column), at_centre.at(column)};
  for (const RowValues& corner : corners) {
    all.lower = std::min(all.lower, corner.at(column));
    all.upper = std::max(all.upper, corner.at(column));
  }
  return all;
}

ReplayedRow replay_row(const data::ElasticNip& nip, const fast::LineLoadMethod& method,
                       const RowInput& input) {
  std::vector<std::optional<double>> creeps{std::nullopt};
  if (input.creep) creeps = {input.creep->lower, input.creep->upper};
  ReplayedRow row;
  row.at_centre = solved_row(nip, method, input.length.middle(),
                             input.creep ? std::optional(input.creep->middle()) : std::nullopt);
  for (const double length : {input.length.lower, input.length.upper}) {
    for (const std::optional<double> creep : creeps) {
      row.corners.push_back(solved_row(nip, method, length, creep));
    }
  }
  return row;
}

}  // namespace nipref::verify
