#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What a plugin does wrong besides wrong values.
enum class FaultKind {
  crash,        ///< ended by a signal
  exit,         ///< ended the process
  hang,         ///< no answer within the time limit
  refused,      ///< returned another number than 0
  not_finite,   ///< a value is infinite or no number
  unwritten,    ///< a value was not written
  overrun,      ///< touched what lies beside its output or its arguments
  arguments,    ///< changed its arguments
  environment,  ///< left another rounding, small numbers flushed to zero, traps
  output,       ///< wrote to standard output
  order,        ///< a value depends on the other points, their order or earlier calls
  threads,      ///< a value depends on what other threads do
  protocol,     ///< meddled with the descriptor that nipref talks over
  given_up      ///< it was not asked any more
};

/// "crash", "not finite", ...
std::string_view name_of(FaultKind kind);

struct Fault {
  FaultKind kind;
  std::optional<Point> point;  ///< none: it happened before the first point
  std::string words;           ///< one line: which signal, which value, what was changed

  bool operator==(const Fault&) const = default;
};

/// All faults of one kind.
struct FaultGroup {
  FaultKind kind;
  std::size_t count;
  std::optional<Point> lower, upper;  ///< of the smallest box of arguments that holds the points
  std::vector<Fault> first;           ///< a few, in the order of their points
};

/// In the order of the kinds.
std::vector<FaultGroup> grouped(std::vector<Fault> faults);

/// For people: a line for each of the first few of each kind, what is left out counted; with where they lie.
std::string faults_text(const Quantity& quantity, const std::vector<Fault>& faults);

/// List of the groups.
Json faults_json(const Quantity& quantity, const std::vector<Fault>& faults);

}  // namespace nipref::verify
