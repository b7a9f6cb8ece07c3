#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/seeds/propagated.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// A formula that a seed prints wrong, of data/statements/formulas.csv.
struct FormulaErratum {
  std::string id;        ///< "thesis-4.8"
  std::string seed;      ///< thesis, brock2012 or brock2013
  std::string equation;  ///< "(4.8b)"
  std::string printed;   ///< what is wrong with it
  std::string right;     ///< what must stand there
  std::string proof;     ///< what computes the truth of its Settlement
};

/// The formula as printed and as it must be, at one place, against something that is neither.
struct Settlement {
  std::string at;                     ///< where, and what is computed
  std::optional<Propagated> printed;  ///< none: what is printed stands for nothing
  Propagated right;
  Propagated truth;

  /// The right one is the truth and the printed one is not, to the sum of both errors.
  [[nodiscard]] bool settled() const;
};

/// All of data/statements/formulas.csv. BadInput that names its line if it cannot be read or names an erratum that nothing
/// settles.
std::vector<FormulaErratum> formula_errata();

/// Computes it, now. The erratum is one of formula_errata().
Settlement settle(const FormulaErratum& erratum);

struct SettledErratum {
  FormulaErratum erratum;
  Settlement settlement;
};

/// The same of many, in their order.
std::vector<SettledErratum> settle_all(std::vector<FormulaErratum> errata);

/// What `errata` answers, and a report has of them.
Json errata_json(const std::vector<SettledErratum>& errata);

}  // namespace nipref::verify
