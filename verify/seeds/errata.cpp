#include <cmath>
#include <utility>

#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/seeds/errata.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

const Settlements& settlements() {
  static const Settlements all = [] {
    Settlements joined = thesis_settlements();
    for (auto* const part :
         {&half_space_settlements, &inversion_settlements, &rolling_line_settlements, &transform_settlements})
      joined.merge(part());
    return joined;
  }();
  return all;
}

}  // namespace

bool Settlement::settled() const {
  const auto are_apart = [&](const Propagated& other) {
    const double allowed = other.error() + truth.error();
    return !(std::fabs(other.value() - truth.value()) <= allowed);
  };
  return !are_apart(right) && (!printed || are_apart(*printed));
}

std::vector<FormulaErratum> formula_errata() {
  const data::CsvFile file = data::read_csv(data::statements_directory() / "formulas.csv");
  std::vector<FormulaErratum> all;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    const auto& record = file.records[i];
    if (record.size() != 6)
      data::refuse(file.path, record.front().position, "must have id, seed, equation, printed, right, proof");
    if (!settlements().contains(record[0].text))
      data::refuse(file.path, record[0].position, "must be the id of an erratum that is settled");
    all.push_back(
        {record[0].text, record[1].text, record[2].text, record[3].text, record[4].text, record[5].text});
  }
  return all;
}

Settlement settle(const FormulaErratum& erratum) { return settlements().at(erratum.id)(); }

std::vector<SettledErratum> settle_all(std::vector<FormulaErratum> errata) {
  std::vector<SettledErratum> settled;
  for (FormulaErratum& erratum : errata) {
    const Settlement settlement = settle(erratum);
    settled.push_back({std::move(erratum), settlement});
  }
  return settled;
}

}  // namespace nipref::verify
