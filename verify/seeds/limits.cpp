#include <cmath>
#include <iterator>
#include <utility>

#include <nipref/data/directory.hpp>
#include <nipref/verify/seeds/internal/statement.hpp>
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
  const Statement file = read_statements(data::statements_directory() / "limits.toml");
  std::vector<LimitRow> rows;
  for (const Statement& entry : file.list("limit", {"name", "statement", "source", "size", "found", "limit"},
                                          {"order", "first", "setting", "given"})) {
    LimitRow row{entry.text("name"), entry.text("statement"), entry.text("source"),
                 entry.text("size"), entry.number("order"),   {}};
    StatementFormulas formulas(file, entry);
    for (int k = 0; k < sizes; ++k) {
      const double size = std::ldexp(entry.number("first"), -k);
      formulas.define("s", Propagated::exact(size));
      row.samples.push_back({size, formulas.value(entry.text("found")), formulas.value(entry.text("limit"))});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace nipref::verify
