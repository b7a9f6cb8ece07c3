#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The faults of a plugin other than wrong values; fault.cpp has their names in this order.
enum class FaultKind {
  crash,        ///< a signal ended the process
  exit,         ///< it ended the process
  hang,         ///< it did not return within the time limit
  refused,      ///< it returned a number other than 0
  not_finite,   ///< a value is infinite or NaN
  unwritten,    ///< it did not write a value
  overrun,      ///< it accessed memory next to its output or its arguments
  arguments,    ///< it changed its arguments
  environment,  ///< it changed the rounding mode, flushes small numbers to zero, or unmasked exceptions
  output,       ///< it wrote to standard output
  order,        ///< a value depends on the other points, their order or earlier calls
  threads,      ///< a value depends on other threads
  protocol,     ///< it used the descriptor over which nipref talks to the process
  given_up      ///< no more points were evaluated after too many faults
};

/// "crash", "not finite", ...
std::string_view name_of(FaultKind kind);

struct Fault {
  FaultKind kind;
  std::optional<Point> point;  ///< nothing if it happened before the first point
  std::string words;           ///< one line that names the signal, the value or the change

  bool operator==(const Fault&) const = default;
};

/// All faults of one kind.
struct FaultGroup {
  FaultKind kind;
  std::size_t count;
  std::optional<Point> lower,
      upper;                 ///< the corners of the smallest box of arguments that contains the points
  std::vector<Fault> first;  ///< a few, in the order of their points
};

/// The groups in the order of the kinds.
std::vector<FaultGroup> grouped(std::vector<Fault> faults);

/// The list of the groups: the first few faults of each kind, the number of all and the box that contains them.
Json faults_json(const Quantity& quantity, const std::vector<Fault>& faults);

}  // namespace nipref::verify
