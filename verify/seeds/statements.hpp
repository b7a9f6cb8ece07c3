#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/formulas/propagated.hpp>
#include <nipref/verify/support/json.hpp>

// The statements of the seeds in the files of data/statements: claims in words, limits, and formulas that are
// misprinted. The functions here throw BadInput that names the line if a file is wrong.

namespace nipref::verify {

struct TomlTable;

/// A statement of a seed: an entry of such a file with the seed, the place, and what is stated, in our words.
struct Statement {
  std::string id;  ///< "thesis-creep-with-friction"
  const TomlTable* entry;
};

/// A number that decides about a claim.
struct ClaimNumber {
  std::string what;
  Propagated number;
  bool is_printed = false;  ///< by the seed

  /// "printed", "exact", "computed"
  [[nodiscard]] std::string_view origin() const;
};

enum class ClaimVerdict { holds, fails, holds_in_a_range };

/// "holds", "false", "holds in a range"
std::string_view name_of(ClaimVerdict verdict);

/// A claim that a seed makes in words, and its verdict, which follows from the numbers.
struct CheckedClaim {
  Statement claim;
  ClaimVerdict verdict = ClaimVerdict::holds;
  std::string why = {};  ///< one sentence with the numbers that decide, or the range in which it holds
  std::vector<ClaimNumber> numbers = {};
};

std::vector<Statement> claims();
/// Computes the numbers of one of claims().
CheckedClaim check(const Statement& claim);
/// Checks several claims on all cores and keeps their order.
std::vector<CheckedClaim> check_all(const std::vector<Statement>& claims);
Json claims_json(const std::vector<CheckedClaim>& claims);
/// How many claims have each of these verdicts, in this order.
Json verdict_counts_json(const std::vector<CheckedClaim>& claims, const std::vector<ClaimVerdict>& verdicts);

/// The converged contact at one place on the way to a limit.
struct LimitSample {
  double size;       ///< what goes to 0; exact
  Propagated found;  ///< by the solver
  Propagated limit;  ///< by a closed form or another contact, which is independent of the solver

  /// |found - limit|/|limit|
  [[nodiscard]] Propagated distance() const;
};

/// How the solver's contact approaches one of the known limits.
struct LimitRow {
  std::string name;       ///< "limit.hertz.load"
  std::string statement;  ///< the limit
  std::string source;     ///< where it comes from
  std::string size;       ///< what goes to 0, dimensionless
  /// The exponent with which the distance must fall, by the first term that the limit leaves out; 0: faster than any
  /// power.
  double order = 0;
  std::vector<LimitSample> samples = {};  ///< sizes falling by halves

  /// The exponent between the last two samples; empty where the last distance is no larger than its error.
  [[nodiscard]] std::optional<Propagated> measured_order() const;
  /// Whether the distances fall with the exponent `order`, to 0.1, while their errors are small enough to tell. If
  /// `order` is 0: whether they fall faster than with the exponent 4, or the last one is within its error.
  [[nodiscard]] bool approached() const;
};

/// The limits of the elastic nip, thick and thin, with and without friction; of the nip with Coulomb's friction, thick,
/// with little and with much friction; and of the rolling nip, with short memory, with long memory and thin.
[[nodiscard]] std::vector<Statement> limits();
/// Computes the contacts on the way to one of limits().
[[nodiscard]] LimitRow approach(const Statement& limit);
[[nodiscard]] std::vector<LimitRow> approach_all(const std::vector<Statement>& limits);
Json limits_json(const std::vector<LimitRow>& limits);

/// A misprinted formula of a seed at one place: its value as printed, as corrected, and the truth, computed by neither.
/// The entry of the erratum says what is wrong, what must stand there, and how the truth is computed.
struct Settlement {
  std::string at;                     ///< the place, and what is computed there
  std::optional<Propagated> printed;  ///< empty: the printed formula has no value
  Propagated right;
  Propagated truth;
  Statement erratum = {};

  /// Whether the corrected value agrees with the truth within the sum of both errors, and the printed one does not.
  [[nodiscard]] bool settled() const;
};

std::vector<Statement> formula_errata();
/// Computes the numbers of one of formula_errata().
Settlement settle(const Statement& erratum);
std::vector<Settlement> settle_all(const std::vector<Statement>& errata);
Json errata_json(const std::vector<Settlement>& errata);

}  // namespace nipref::verify
