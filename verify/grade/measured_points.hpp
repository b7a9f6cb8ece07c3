#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The results of a kind of golden contacts as quantities KIND.RESULT, which live as long as the program. Their
/// arguments are the keys that the sweep varies; a key with lists is a choice. The reference solves a contact once for
/// all results, to contact_digits. Errors have the scales of the scene's results. BadInput if there is no such kind.
const std::vector<Quantity>& contact_quantities(const std::string& kind);

/// The contacts of all combinations as points of these quantities. BadInput for a key that does not vary, and for a
/// list that is none of the choices.
std::vector<Point> contact_points(const std::string& kind, const AxesProduct& contacts);

/// Points for another program, as CSV: the comment lines, for each argument a column with the exact hexadecimal
/// number, or the name of a choice, and a column NAME_decimal with the shortest decimal number that is rounded to the
/// same double.
std::string points_csv(const Quantity& quantity, const std::vector<Point>& points,
                       const std::vector<std::string>& comments);

/// The values of another program at points.
struct MeasuredPoints {
  const Quantity* quantity;
  std::vector<Point> points;
  std::vector<double> values;  ///< may be infinite or NaN
  /// The number of rows in which the two columns of an argument have different doubles; the exact column is used.
  std::size_t contradicting_rows = 0;
  /// The number of rows with a decimal argument of at most 15 significant digits, which the program may have rounded.
  std::size_t short_rows = 0;
};

/// Reads such a file with one more column for the values. Its name is `column`, "value" or the name of the quantity,
/// or it is the only column that belongs to no argument. An argument is read from the column of its name or from
/// NAME_decimal; an argument without a column has its default. The quantity is the given one, or that of the comment
/// line "quantity: NAME". A file of golden contacts may have a column for each result of their kind; each result is a
/// quantity. "-" is standard input. BadInput that names file, line and column for a text that cannot be read.
std::vector<MeasuredPoints> read_measured_points(const std::string& path,
                                                 const std::optional<std::string>& quantity,
                                                 const std::optional<std::string>& column);

}  // namespace nipref::verify
