#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// Points for somebody else's program, as CSV: the comment lines, a column for each argument with the exact number
/// in hexadecimal, or the name of a choice, and NAME_decimal with the shortest decimal that means the same double.
std::string points_csv(const Quantity& quantity, const std::vector<Point>& points,
                       const std::vector<std::string>& comments);

/// What somebody else's program says of points.
struct MeasuredPoints {
  const Quantity* quantity;
  std::vector<Point> points;
  std::vector<double> values;  ///< may be infinite or NaN
  /// Rows whose two columns of an argument are different doubles; that of the argument's own name is taken.
  std::size_t contradicting_rows = 0;
  /// Rows with an argument in decimal, of 15 significant digits or less: it may have been rounded on the way.
  std::size_t short_rows = 0;
};

/// Reads such a CSV with the values in one column more: the one called `column`, or "value", or as the quantity is
/// called, or the only one that is not an argument's. An argument is read from the column of its name or from
/// NAME_decimal; one without a column has its default. The quantity is the one named, or that of the comment line
/// "quantity: NAME". "-" is standard input. BadInput that names file, line and column for whatever cannot be read.
MeasuredPoints read_measured_points(const std::string& path, const std::optional<std::string>& quantity,
                                    const std::optional<std::string>& column);

}  // namespace nipref::verify
