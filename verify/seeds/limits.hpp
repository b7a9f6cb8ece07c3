#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/seeds/propagated.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The converged contact at one place on the way to a limit.
struct LimitSample {
  double size;       ///< what goes to 0; exact
  Propagated found;  ///< by the solver
  Propagated limit;  ///< by the closed form, which knows nothing of the solver

  /// |found - limit|/|limit|
  [[nodiscard]] Propagated distance() const;
};

/// How the solver's contact approaches one of the known limits.
struct LimitRow {
  std::string name;       ///< "limit.hertz.load"
  std::string statement;  ///< the closed form
  std::string source;     ///< where it comes from
  std::string size;       ///< what goes to 0, dimensionless
  /// The exponent with which the distance must fall, by the first term that the limit leaves out; 0: faster than any
  /// power.
  double order;
  std::vector<LimitSample> samples;  ///< sizes falling by halves

  /// The exponent between the last two samples; none where the last distance is no more than its error.
  [[nodiscard]] std::optional<Propagated> measured_order() const;
  /// Whether distances fall with that exponent, to 0.1, or faster than with exponent 4 where it is 0; and errors are so
  /// small that this can be told.
  [[nodiscard]] bool approached() const;
};

/// All of data/statements/limits.csv, computed now: of the elastic nip thick and thin with and without friction, and of the rolling one with
/// short memory, with long memory and thin.
[[nodiscard]] std::vector<LimitRow> limits();

/// What `limits` answers, and a report has of them.
Json limits_json(const std::vector<LimitRow>& limits);

}  // namespace nipref::verify
