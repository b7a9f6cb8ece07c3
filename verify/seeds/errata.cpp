#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/data/directory.hpp>
#include <nipref/verify/seeds/errata.hpp>
#include <nipref/verify/seeds/internal/statement.hpp>

namespace nipref::verify {
namespace {

const Statement& errata_file() {
  static const Statement file = read_statements(data::statements_directory() / "errata.toml");
  return file;
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
  std::vector<FormulaErratum> all;
  for (const Statement& one :
       errata_file().list("erratum", {"id", "seed", "equation", "printed", "right", "proof"},
                          {"quantity", "setting", "given", "at", "printed_value", "right_value", "truth"}))
    all.push_back({one.text("id"), one.text("seed"), one.text("equation"), one.text("printed"),
                   one.text("right"), one.text("proof")});
  return all;
}

Settlement settle(const FormulaErratum& erratum) {
  const Statement& entry = errata_file().entry("erratum", erratum.id);
  StatementFormulas formulas(errata_file(), entry);
  if (const std::string quantity = entry.text_or("quantity", ""); !quantity.empty()) {
    const auto by = [&](const char* kind) { return formulas.value(fmt::format("[{} {}]", kind, quantity)); };
    return {quantity, by("printed"), by("fast"), by("ref")};
  }
  std::optional<Propagated> printed;
  if (const std::string formula = entry.text_or("printed_value", ""); !formula.empty())
    printed = formulas.value(formula);
  return {entry.text("at") + formulas.setting(), printed, formulas.value(entry.text("right_value")),
          formulas.value(entry.text("truth"))};
}

std::vector<SettledErratum> settle_all(std::vector<FormulaErratum> errata) {
  std::vector<SettledErratum> settled;
  for (FormulaErratum& erratum : errata) {
    const Settlement settlement = settle(erratum);
    settled.push_back({std::move(erratum), settlement});
  }
  return settled;
}

}  // namespace nipref::verify
