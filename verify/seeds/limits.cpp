#include <cmath>
#include <iterator>
#include <utility>

#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/seeds/internal/limit_rows.hpp>
#include <nipref/verify/seeds/limits.hpp>

namespace nipref::verify {

Propagated LimitSample::distance() const { return fabs(found - limit) / fabs(limit); }

std::optional<Propagated> LimitRow::measured_order() const {
  const LimitSample &before = *std::prev(samples.end(), 2), &last = samples.back();
  if (!last.distance().is_positive()) return {};
  return log(before.distance() / last.distance()) /
         log(Propagated::exact(before.size) / Propagated::exact(last.size));
}

bool LimitRow::approached() const {
  constexpr double agreement = 0.1, faster_than_powers = 4, told_apart = 0.01;
  const Propagated last = samples.back().distance();
  const std::optional<Propagated> measured = measured_order();
  if (order == 0) return !measured || measured->value() > faster_than_powers;
  return measured && last.error() < told_apart * last.value() &&
         std::fabs(measured->value() - order) <= agreement;
}

std::vector<LimitRow> limits() {
  constexpr int sizes = 3;
  LimitSamples samples = elastic_limits();
  samples.merge(rolling_limits());
  const data::CsvFile file = data::read_csv(data::statements_directory() / "limits.csv");
  std::vector<LimitRow> rows;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    const auto& record = file.records[i];
    if (record.size() != 6)
      data::refuse(file.path, record.front().position,
                   "must have name, statement, source, size, order, first");
    const auto sample = samples.find(record[0].text);
    if (sample == samples.end())
      data::refuse(file.path, record[0].position, "must be the name of a limit that is checked");
    LimitRow row{
        record[0].text, record[1].text, record[2].text, record[3].text, std::stod(record[4].text), {}};
    for (int k = 0; k < sizes; ++k)
      row.samples.push_back(sample->second(std::ldexp(std::stod(record[5].text), -k)));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace nipref::verify
