#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/table/printed_number.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>

namespace nipref::verify {

/// What a row of an elastic table is replayed from.
struct RowInput {
  data::Interval length;                ///< L, in
  std::optional<data::Interval> creep;  ///< with full friction
};

/// The columns of a row, base units, by name.
using RowValues = std::map<std::string, double>;

/// A row as the line loads give it.
struct ReplayedRow {
  RowValues at_centre;             ///< of the inputs' intervals
  std::vector<RowValues> corners;  ///< of the intervals' product

  /// From the least to the greatest value of a column.
  [[nodiscard]] data::Interval range(const std::string& column) const;
};

ReplayedRow replay_row(const data::ElasticNip& nip, const fast::LineLoadMethod& method,
                       const RowInput& input);

/// The columns that a solution gives.
RowValues row_values(const data::ElasticNip& nip, const fast::LineLoadSolution& solution, double creep);

}  // namespace nipref::verify
