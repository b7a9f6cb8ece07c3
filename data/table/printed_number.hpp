#pragma once
#include <algorithm>
#include <numeric>
#include <optional>
#include <string_view>

namespace nipref::data {

/// Closed interval [lower, upper] of doubles.
struct Interval {
  double lower;
  double upper;

  static Interval only(double value) { return {value, value}; }
  [[nodiscard]] double middle() const { return std::midpoint(lower, upper); }
  [[nodiscard]] double width() const { return upper - lower; }
  [[nodiscard]] bool meets(const Interval& other) const {
    return lower <= other.upper && other.lower <= upper;
  }
  /// The part of the interval that lies in `other`; the whole interval if they do not meet.
  [[nodiscard]] Interval within(const Interval& other) const {
    return meets(other) ? Interval{std::max(lower, other.lower), std::min(upper, other.upper)} : *this;
  }
  [[nodiscard]] Interval times(double factor) const {
    return {lower * factor, upper * factor};
  }  ///< factor > 0
};

/// Stands for a digit that cannot be read.
inline constexpr char lost_digit = '?';

/// A number as printed in a table, with the scaling of its column undone.
struct PrintedNumber {
  double value;       ///< the double nearest to printed / scale
  Interval rounding;  ///< all values that round to the printed digits, divided by scale
};

/// Reads a plain decimal: optional sign, digits, optional point and digits; no exponent, no blanks. `scale_exponent` is
/// s of the printed scale 10^s of the column, so that the value is text * 10^-s and the rounding interval is (text -+
/// half a unit of the last printed digit) * 10^-s. Value and ends are correctly rounded (formed in decimal, converted
/// once). Returns nullopt for a text that is not a plain decimal, has more than 18 digits or leaves the range of
/// double. A '?' is a lost digit: the interval covers all digits, and the value is its middle.
[[nodiscard]] std::optional<PrintedNumber> read_printed_number(std::string_view text, int scale_exponent);

/// Reads a whole field as one finite number, exponent allowed (1e-3); nullopt if anything else is there.
[[nodiscard]] std::optional<double> read_exact_number(std::string_view text);

}  // namespace nipref::data
