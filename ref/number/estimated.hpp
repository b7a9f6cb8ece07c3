#pragma once
#include <string>

#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/real.hpp>

namespace nipref::ref {

/// A value with an estimate of its error, which is meant to cover it with a margin but is not proven. A
/// proven bound may stand where an estimate is asked for, never the reverse.
struct Estimated {
  Real value;
  Real error;           ///< >= 0
  int digits;           ///< that were asked for
  bool proven = false;  ///< the error is a bound

  Estimated(Real the_value, Real the_error, int the_digits);
  Estimated(const Enclosure& enclosure);

  /// Decimal text of the value, as Enclosure has it.
  [[nodiscard]] std::string value_text() const;
  /// Estimate of |value_text() - truth|, two significant digits, rounded up: "1.2e-53".
  [[nodiscard]] std::string error_text() const;
  /// Nearest double.
  [[nodiscard]] double to_double() const;
  /// x - value, formed exactly and rounded once: the error of an approximation x.
  [[nodiscard]] double error_of(double x) const;
};

}  // namespace nipref::ref
